// Mirrors that are nearly flat; eyes at the centre and the focus of a hollow one.
#include "core/image/resolve.hpp"
#include "tools/stability/exact.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 64;

Picture drawn(auto light) {
    Picture picture{kSide, kSide, {}};
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const float x = float(2 * i + 1) / kSide - 1, y = 1 - float(2 * j + 1) / kSide;
            picture.rgb.insert(picture.rgb.end(), 3, light(x, y));
        }
    }
    return picture;
}

// S05, S06: a chalk ball before a mirror of 2 x 2 at the origin.
constexpr Vec3<double> kBall{0.3, 0.1, 0.8}, kLamp{-1.2, 0.8, 0.2}, kEye{0.9, 0.4, 3};
constexpr double kRadius = 0.25, kFov = 0.8;

Picture ball_before(const Stage& stage, double curvature_radius) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.4};
    scene.camera = camera_at(kEye, {0, 0, -1}, kFov);
    add(scene, ball(kBall, kRadius, chalk()));
    add(scene, lamp(kLamp));
    add(scene, ideal_mirror({0, 0, 0}, {0, 0, 1}, 2));
    scene.mirrors[0].curvature_radius = curvature_radius;
    return stage.render(scene, kSide, kSide);
}

float ball_light(Vec3<float> o, Vec3<float> d) {
    const Vec3<float> centre = naive::rounded(kBall);
    const naive::Roots roots = naive::sphere(o, d, centre, float(kRadius));
    if (!roots.real || !(roots.first > 0)) return -1;
    const Vec3<float> p = naive::along(o, roots.first, d);
    return naive::lambert(p, naive::times(naive::minus(p, centre), float(1 / kRadius)), naive::rounded(kLamp));
}

/// The mirror as a sphere about (0, 0, R), or as a plane when R is 0.
bool naive_mirror(Vec3<float> o, Vec3<float> d, float radius, Vec3<float>& p, Vec3<float>& n) {
    if (radius == 0) {
        p = naive::along(o, -o.z / d.z, d), n = {0, 0, 1};
        return std::abs(p.x) < 1 && std::abs(p.y) < 1;
    }
    const Vec3<float> centre{0, 0, radius};
    const naive::Roots roots = naive::sphere(o, d, centre, radius);
    for (const float t : {roots.first, roots.second}) {
        p = naive::along(o, t, d), n = naive::times(naive::minus(centre, p), 1 / radius);
        if (roots.real && t > 0 && n.z > 0 && std::abs(p.x) < 1 && std::abs(p.y) < 1) return true;
    }
    return false;
}

Picture naive_ball_before(float radius) {
    return drawn([&](float x, float y) {
        const float half = float(std::tan(kFov / 2));
        const Vec3<float> o = naive::rounded(kEye), d = naive::unit({half * x, half * y, -1});
        const float direct = ball_light(o, d);
        if (direct >= 0) return direct;
        Vec3<float> p{}, n{};
        if (!naive_mirror(o, d, radius, p, n)) return 0.1f;
        const float seen = ball_light(p, naive::along(d, -2 * naive::dot(d, n), n));
        return seen >= 0 ? seen : 0.1f;
    });
}

/// Pixels of which a stored code of 8 bits differs.
int codes_apart(const Picture& a, const Picture& b) {
    std::vector<std::uint8_t> codes_a(a.rgb.size()), codes_b(b.rgb.size());
    resolve8(a.rgb.data(), codes_a.data(), a.rgb.size());
    resolve8(b.rgb.data(), codes_b.data(), b.rgb.size());
    int apart = 0;
    for (std::size_t i = 0; i < codes_a.size(); i += 3) {
        apart += !std::equal(&codes_a[i], &codes_a[i] + 3, &codes_b[i]);
    }
    return apart;
}

double s05_ours(const Stage& stage) {
    const Picture plane = ball_before(stage, kInfinity);
    int apart = 0;
    for (const double radius : {1e7, -1e7, 1e9}) apart += codes_apart(ball_before(stage, radius), plane);
    return apart;
}
double s05_naive() {
    const Picture plane = naive_ball_before(0);
    int apart = 0;
    for (const float radius : {1e7f, -1e7f, 1e9f}) apart += codes_apart(naive_ball_before(radius), plane);
    return apart;
}

double s06_ours(const Stage& stage) {
    const Picture plane = ball_before(stage, kInfinity);
    return pixels_apart(ball_before(stage, -kInfinity), plane) + pixels_apart(ball_before(stage, 1e300), plane) +
           pixels_apart(ball_before(stage, -1e300), plane);
}
double s06_naive() {
    constexpr float kEndless = std::numeric_limits<float>::infinity();
    const Picture plane = naive_ball_before(0);
    return pixels_apart(naive_ball_before(kEndless), plane) + pixels_apart(naive_ball_before(-kEndless), plane);
}

// S08: what an eye at the centre of curvature sees is what is behind it, turned about. A chalk ball stands there.
constexpr double kBowl = 2;
constexpr Vec3<double> kBehind{0, 0, kBowl + 12}, kBowlLamp{1, 2, 3};
constexpr double kBehindRadius = 10, kBowlFov = 0.8;

Picture upside_down(const Picture& picture) {
    Picture turned = picture;
    const std::size_t row = std::size_t{3} * kSide;
    for (std::size_t j = 0; j < kSide; ++j) {
        std::copy_n(&picture.rgb[j * row], row, &turned.rgb[(kSide - 1 - j) * row]);
    }
    return turned;
}

constexpr double kRounding = 0x1p-24;

double s08_ours(const Stage& stage) {
    Scene scene;
    add(scene, ball(kBehind, kBehindRadius, chalk()));
    add(scene, lamp(kBowlLamp));
    scene.camera = camera_at({0, 0, kBowl}, {0, 0, 1}, kBowlFov);
    const Picture direct = stage.render(scene, kSide, kSide);
    scene.camera.view.z = -1;
    add(scene, ideal_mirror({0, 0, 0}, {0, 0, 1}, 2));
    scene.mirrors[0].curvature_radius = kBowl;
    return largest_difference(stage.render(scene, kSide, kSide), upside_down(direct)) / kRounding;
}

float behind_light(Vec3<float> o, Vec3<float> d) {
    const Vec3<float> centre = naive::rounded(kBehind);
    const naive::Roots roots = naive::sphere(o, d, centre, float(kBehindRadius));
    const Vec3<float> p = naive::along(o, roots.first, d);
    const Vec3<float> n = naive::times(naive::minus(p, centre), float(1 / kBehindRadius));
    return roots.real ? naive::lambert(p, n, naive::rounded(kBowlLamp)) : 0;
}

/// The mirror of paraxial optics: sagitta rho^2 / 2R, normal (-x/R, -y/R, 1).
float behind_in_paraxial_mirror(Vec3<float> o, Vec3<float> d) {
    constexpr float kR = float(kBowl);
    const naive::Roots roots = naive::roots(d.x * d.x + d.y * d.y, -2 * kR * d.z, -2 * kR * o.z);
    const Vec3<float> p = naive::along(o, std::max(roots.first, roots.second), d);
    const Vec3<float> n = naive::unit({-p.x / kR, -p.y / kR, 1});
    return behind_light(p, naive::along(d, -2 * naive::dot(d, n), n));
}

double s08_naive() {
    const Vec3<float> eye{0, 0, float(kBowl)};
    const float half = float(std::tan(kBowlFov / 2));
    const auto light = [&](auto seen, float sign) {
        return drawn([&](float x, float y) { return seen(eye, naive::unit({sign * half * x, half * y, -sign})); });
    };
    const Picture direct = light(behind_light, -1);
    return largest_difference(light(behind_in_paraxial_mirror, 1), upside_down(direct)) / kRounding;
}

// S09: rays from the focus leave parallel to the axis, but for the aberration (h/R)^3.
constexpr double kHeights[] = {0.01, 0.05, 0.1, 0.2};
constexpr double kScreens[] = {10, 1e3, 1e6};

/// Where a ray from the focus that meets the mirror at height h goes, in closed form: its slope towards the axis.
double exact_slope(double h) {
    const double z = h * h / kBowl / (1 + std::sqrt(1 - h * h / (kBowl * kBowl)));
    const Vec3<double> d = exact::unit({h, 0, z - kBowl / 2}), n{-h / kBowl, 0, 1 - z / kBowl};
    const Vec3<double> out = exact::along(d, -2 * exact::dot(d, n), n);
    return out.x / out.z;
}

template <class Slope>
double slope_error(const Slope& slope) {
    double largest = 0;
    for (const double h : kHeights) {
        for (const double screen : kScreens) {
            const double error = std::abs(slope(h, screen) - exact_slope(h)) / kRounding;
            if (!(error <= largest)) largest = error;
        }
    }
    return largest;
}

/// Bisects the place of a screen's edge: where does the ray pierce the plane z = screen?
double s09_slope(const Stage& stage, double h, double screen) {
    const double z = h * h / kBowl / (1 + std::sqrt(1 - h * h / (kBowl * kBowl)));
    const double reach = 1 + screen * 2e-3;
    Scene scene;
    add(scene, ideal_mirror({0, 0, 0}, {0, 0, 1}, 1));
    scene.mirrors[0].curvature_radius = kBowl;
    add(scene, ideal_mirror({0, 0, screen}, {0, 0, -1}, 4 * reach));
    scene.mirrors[1].reflection = 0, scene.mirrors[1].ambient = 1;
    double low = -reach, high = reach;
    for (int step = 0; step < 40; ++step) {
        const double edge = (low + high) / 2;
        scene.mirrors[1].position.x = edge + 2 * reach;
        if (stage.beyond_formats(scene, "curvature_radius") || stage.beyond_formats(scene, "boundary")) {
            return exact_slope(h);
        }
        (stage.look(scene, {0, 0, kBowl / 2}, {h, 0, z - kBowl / 2}).r > 0 ? low : high) = edge;
    }
    return (low - h) / (screen - z);
}

double s09_ours(const Stage& stage) {
    return slope_error([&](double h, double screen) { return s09_slope(stage, h, screen); });
}

/// The mirror equation 1/u + 1/v = 2/R and the magnification -v/u, for the eye as an object of height 0.
double s09_naive() {
    return slope_error([](double h, double) {
        const float u = float(kBowl / 2), v = 1 / (2 / float(kBowl) - 1 / u), height = -v / u * 0;
        return double{(height - float(h)) / v};
    });
}

constexpr StiffCase kRows[] = {
    {"S05", "mirrors of curvature radius 1e7, -1e7, 1e9", "centre and radius: no mirror, or noise",
     "the plane mirror's picture, every code of 8 bits", "pixels apart", 0, s05_ours, s05_naive},
    {"S06", "mirrors of curvature radius inf, -inf, 1e300, -1e300", "a centre at infinity: no mirror",
     "the plane mirror's picture, bit by bit", "pixels apart", 0, s06_ours, s06_naive},
    {"S08", "eye at the centre of curvature, R = 2, aperture 2", "paraxial sagitta and normal miss the centre",
     "every ray comes back on itself: what is behind, turned about", "2^-24 of light", 16, s08_ours, s08_naive},
    {"S09", "eye at the focus R / 2", "the image lies at 1 / 0, its height is infinity times 0",
     "rays leave parallel to the axis, but for the aberration (h / R)^3", "2^-24 of slope", 4, s09_ours, s09_naive,
     {.refused = "boundary"}},
};

}  // namespace

std::span<const StiffCase> mirror_curvature_rows() { return kRows; }

}  // namespace zerkalo::stability
