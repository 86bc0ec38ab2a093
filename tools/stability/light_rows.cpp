// Light without measure: none at all, too much, from everywhere, and through a mirror.
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include "core/image/resolve.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 48;           // pixels a side
constexpr double kHalfView = 0.3;   // tangent of half the angle of view
constexpr Vec3<double> kEye{0, 0, 5};

// S52. A ball under a lamp of every strength.

constexpr Vec3<double> kLamp{3, 4, 6};
constexpr double kStrong = 1e30, kModest = 1e4, kWeak = 1e-30;
constexpr double kPowersOfTwo[] = {0x1p-100, 0x1p-20, 0x1p10, 0x1p20, 0x1p100};

/// A ball with a wide highlight: narrow ones are cut off where they fall below 2^-24 of the brightest light.
Material satin() {
    Material material;
    material.color = {1, 0.5, 0.25};
    material.shininess = 8;
    return material;
}

/// Judges a renderer: render(intensity, ambient) -> picture, or an empty one for an intensity that it refuses, of which
/// those that are not `judged` are left out. `step`: of the stored light, 0 for numbers that keep their digits instead.
template <class Render, class Judged>
double wrong_at_some_strength(const Render& render, double step, const Judged& judged) {
    const Picture dark = render(0, 0), ambient_only = render(0, 1), one = render(1, 0);
    double wrong = std::count_if(dark.rgb.begin(), dark.rgb.end(), [](float x) { return x != 0; });
    const Rgb<float> middle = ambient_only.at(kSide / 2, kSide / 2);
    for (const auto& [got, expected] : {std::pair{middle.r, 0.1f}, {middle.g, 0.05f}, {middle.b, 0.025f}}) {
        wrong += std::abs(got - expected) > step;  // C K_a and nothing else
    }
    for (const double power : kPowersOfTwo) {
        if (!judged(power)) continue;
        Picture scaled = one;
        for (float& x : scaled.rgb) x *= float(power);
        wrong += pixels_apart(scaled, render(power, 0), std::max(1.0, power) * step);
    }
    // Each stays in proportion to the last digits, and only the stored codes saturate.
    for (const double power : {kStrong, kModest, kWeak}) {
        if (!judged(power)) continue;
        const Picture picture = render(power, 0);
        std::vector<std::uint8_t> codes(picture.rgb.size());
        resolve8(picture.rgb.data(), codes.data(), codes.size());
        for (std::size_t i = 0; i < one.rgb.size(); ++i) {
            constexpr double kDigits = 4 * 0x1p-24;
            const double expected = power * double{one.rgb[i]};
            const double room = kDigits * expected + std::max(1.0, power) * step;
            wrong += !(std::abs(double{picture.rgb[i]} - expected) <= room);
            wrong += power > 1 && codes[i] != (expected >= 1 ? 255 : expected > 0 ? codes[i] : 0);
        }
    }
    return wrong + !render(-1, 0).rgb.empty();
}

Scene satin_ball(double intensity, double ambient) {
    Scene scene;
    scene.ambient = {ambient, ambient, ambient};
    scene.camera = camera_at(kEye, {0, 0, -1}, 2 * std::atan(kHalfView));
    add(scene, ball({0, 0, 0}, 1, satin()));
    add(scene, lamp(kLamp));
    scene.lights[0].intensity = intensity;
    return scene;
}

double s52_ours(const Stage& stage) {
    const auto render = [&](double intensity, double ambient) {
        const Scene scene = satin_ball(intensity, ambient);
        if (intensity < 0 && stage.refused_field(scene) == "intensity") return Picture{};
        return stage.render(scene, kSide, kSide);
    };
    const double step = stage.fixed() ? 8 * 0x1p-24 : 0;
    return wrong_at_some_strength(
        render, step, [&](double intensity) { return !stage.beyond_formats(satin_ball(intensity, 0), "intensity"); });
}

/// Calls colour(i, j, eye, direction) for each pixel.
template <class Colour>
Picture drawn(const Colour& colour) {
    Picture picture{kSide, kSide, {}};
    const Vec3<float> eye{float(kEye.x), float(kEye.y), float(kEye.z)};
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const float x = float(kHalfView * (2 * (i + 0.5) / kSide - 1));
            const float y = float(kHalfView * (1 - 2 * (j + 0.5) / kSide));
            const Rgb<float> c = colour(eye, naive::unit({x, y, -1}));
            picture.rgb.insert(picture.rgb.end(), {c.r, c.g, c.b});
        }
    }
    return picture;
}

/// Phong's formula with the share of each lamp clipped to 0..1 as it is added: the store saturates too early.
double s52_naive() {
    const auto render = [](double intensity, double ambient) {
        return drawn([&](Vec3<float> eye, Vec3<float> d) -> Rgb<float> {
            const auto roots = naive::sphere(eye, d, {0, 0, 0}, 1);
            if (!roots.real) return {0, 0, 0};
            const Vec3<float> n = naive::along(eye, roots.first, d);
            const Vec3<float> l = naive::unit(naive::minus({float(kLamp.x), float(kLamp.y), float(kLamp.z)}, n));
            const float cosine = std::max(0.0f, naive::dot(n, l));
            const Vec3<float> r = naive::minus(naive::times(n, 2 * cosine), l);
            const Material m = satin();
            const float shine = cosine > 0 ? std::pow(std::max(0.0f, -naive::dot(r, d)), float(m.shininess)) : 0;
            const auto sum = [&](double c) {
                const float share = float(intensity) * (float(c * m.diffuse) * cosine + float(m.specular) * shine);
                return std::min(1.0f, float(c * m.ambient * ambient) + share);
            };
            return {sum(m.color.r), sum(m.color.g), sum(m.color.b)};
        });
    };
    return wrong_at_some_strength(render, 0, [](double) { return true; });
}

// S66. Everything black, and everything white: mirrors and glass that lose nothing, in surroundings of radiance 1.

Scene everything(double radiance) {
    Scene scene;
    scene.background = scene.ambient = {radiance, radiance, radiance};
    scene.camera = camera_at(kEye, {0, 0, -1}, 2 * std::atan(kHalfView));
    Material clear = glowing({1, 1, 1});
    clear.ambient = 0;
    clear.transmission = 1;
    Material half = clear;
    half.reflection = half.transmission = 0.5;
    Material silver = clear;
    silver.reflection = 1, silver.transmission = 0;
    add(scene, ball({-0.7, 0.5, 1}, 0.5, clear));
    add(scene, ball({0.7, 0.5, 1}, 0.5, silver));
    add(scene, upright(SolidKind::prism, {0, -1, 1}, 0.5, 0.8, half));
    add(scene, upright(SolidKind::cone, {1, -1, 1}, 0.4, 0.8, glowing({1, 1, 1})));
    add(scene, ideal_mirror({0, 0, -1}, {0, 0, 1}, 3));
    add(scene, ideal_mirror({0, 0, 9}, {0, 0, -1}, 3));
    return scene;
}

/// Light that comes out of nothing, in roundings; infinite where a black picture is not black.
double gain(const Picture& black, const Picture& white) {
    for (const float value : black.rgb) {
        if (value != 0) return kInfinity;
    }
    double most = 0;
    for (const float value : white.rgb) {
        const double over = (double{value} - 1) / 0x1p-24;
        if (!(over <= most)) most = std::isnan(over) ? kInfinity : over;
    }
    return most;
}

double s66_ours(const Stage& stage) {
    double most = 0;
    for (const double exponent : {0.0, 1.0, 100.0, 1e9, kInfinity}) {
        for (const Lobe lobe : {Lobe::phong, Lobe::max_phong}) {
            const auto picture = [&](double radiance) {
                Scene scene = everything(radiance);
                scene.mirrors[0].lobe_exponent = exponent;
                scene.mirrors[0].lobe = lobe;
                return stage.render(scene, kSide, kSide);
            };
            most = std::max(most, gain(picture(0), picture(1)));
        }
    }
    return most;
}

/// The highlight's cos^n as a mirror's lobe, n = 1, and nothing to make its sum over all directions 1.
double s66_naive() {
    constexpr int kRings = 1000;
    constexpr float kStep = std::numbers::pi_v<float> / 2 / kRings;
    const auto returned = [](float radiance) {
        float sum = 0;
        for (int k = 0; k < kRings; ++k) {
            const float angle = (float(k) + 0.5f) * kStep;
            const float ring = 2 * std::numbers::pi_v<float> * std::sin(angle) * kStep;
            sum += radiance * std::pow(std::cos(angle), 1.0f) * std::cos(angle) * ring;
        }
        return Picture{1, 1, {sum, sum, sum}};
    };
    return gain(returned(0), returned(1));
}

// S67. A chalk ball under a lamp, and a mirror below that would send the lamp's light up to its dark side.

constexpr Vec3<double> kAbove{0, 6, 1};
constexpr double kFloor = -2;

double s67_ours(const Stage& stage) {
    Scene without;
    without.camera = camera_at(kEye, {0, 0, -1}, 2 * std::atan(kHalfView));
    add(without, ball({0, 0, 0}, 1, chalk()));
    add(without, lamp(kAbove));
    Scene with = without;
    add(with, ideal_mirror({0, kFloor, 0}, {0, 1, 0}, 8));  // below the picture's edge
    // With the mirror another power of two brings the scene into the box of fixed point: other roundings.
    const double tolerance = stage.fixed() ? 8 * 0x1p-24 : 0;
    return pixels_apart(stage.render(without, kSide, kSide), stage.render(with, kSide, kSide), tolerance);
}

/// A mirror as a second lamp at the first one's image.
double s67_naive() {
    const auto lit_by = [](bool mirror) {
        return drawn([&](Vec3<float> eye, Vec3<float> d) -> Rgb<float> {
            const auto roots = naive::sphere(eye, d, {0, 0, 0}, 1);
            if (!roots.real) return {0, 0, 0};
            const Vec3<float> n = naive::along(eye, roots.first, d);
            const auto share = [&](double y) {
                return std::max(0.0f, naive::dot(n, naive::unit(naive::minus({0, float(y), float(kAbove.z)}, n))));
            };
            const float sum = share(kAbove.y) + (mirror ? share(2 * kFloor - kAbove.y) : 0);
            return {sum, sum, sum};
        });
    };
    return pixels_apart(lit_by(false), lit_by(true));
}

constexpr StiffCase kRows[] = {
    {"S52", "a lamp of intensity 0, 2^-100, 1e-30, 1e30, 2^100, -1",
     "clips each lamp's share to 1: all strong ones are alike",
     "0: ambient light alone; the rest in proportion; -1 refused", "wrong values", 0, s52_ours, s52_naive,
     {.refused = "intensity"}},
    {"S66", "mirrors, lobes and glass without loss where nothing, or all, glows",
     "cos^n without its norm returns twice the light", "0 exactly; at most 1 and two roundings", "2^-24 above 1", 2,
     s66_ours, s66_naive},
    {"S67", "a mirror below a ball under a lamp", "the lamp's image in the mirror lights the ball: a caustic",
     "Whitted's model has no caustics: the picture without the mirror, to the last bit", "pixels apart", 0,
     s67_ours, s67_naive},
};

}  // namespace

std::span<const StiffCase> light_rows() { return kRows; }

}  // namespace zerkalo::stability
