// Spheres very small, very large, and barely touched.
#include "tools/stability/exact.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <limits>

namespace zerkalo::stability {
namespace {

// S03: a small ball throws its shadow on another, from 1 away; then everything 2^13 times larger.
constexpr int kSide = 48;
constexpr double kTiny = 1e-4, kLarger = 8192;
constexpr Vec3<double> kTinyBalls[] = {{0, 0, -1}, {kTiny, kTiny, -1 + 2 * kTiny}};
constexpr double kTinyRadii[] = {kTiny, kTiny / 2};
// The second ball stands between each of them and the first.
constexpr Vec3<double> kTinyLamp{1, 1, 1}, kNearLamp{20 * kTiny, 20 * kTiny, -1 + 40 * kTiny};

Scene tiny_balls(double scale, const Vec3<double>& lamp_at) {
    Scene scene;
    scene.camera = camera_at({0, 0, 0}, {0, 0, -1}, 4 * kTiny);
    for (int k = 0; k < 2; ++k) add(scene, ball(exact::times(kTinyBalls[k], scale), kTinyRadii[k] * scale, chalk()));
    add(scene, lamp(exact::times(lamp_at, scale)));
    return scene;
}

/// The same picture in closed form.
double exact_tiny_light(const Vec3<double>& lamp_at, int i, int j) {
    const double half = std::tan(2 * kTiny);
    const Vec3<double> d = exact::unit({half * ((2 * i + 1.0) / kSide - 1), half * (1 - (2 * j + 1.0) / kSide), -1});
    double depths[2];
    for (int k = 0; k < 2; ++k) depths[k] = exact::sphere({{0, 0, 0}, d}, kTinyBalls[k], kTinyRadii[k]).entry;
    const int seen = depths[1] < depths[0], other = 1 - seen;
    if (!std::isfinite(depths[seen])) return 0;
    const Vec3<double> p = exact::times(d, depths[seen]);
    const Vec3<double> l = exact::unit(exact::minus(lamp_at, p));
    const exact::Span shade = exact::sphere({p, l}, kTinyBalls[other], kTinyRadii[other]);
    if (shade.entry > 0 && shade.entry < shade.exit) return 0;
    return exact::lambert(p, exact::unit(exact::minus(p, kTinyBalls[seen])), lamp_at);
}

/// Pixels that differ from the picture of the larger scene, or from the closed form where that is smooth.
double tiny_faults(const Picture& picture, const Picture& larger, const Vec3<double>& lamp_at) {
    constexpr double kEdge = 0.2, kClose = 0.01;
    int wrong = pixels_apart(picture, larger);
    for (int j = 1; j + 1 < kSide; ++j) {
        for (int i = 1; i + 1 < kSide; ++i) {
            const double light = exact_tiny_light(lamp_at, i, j);
            bool smooth = true;
            for (const auto& [x, y] : {std::pair{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}}) {
                smooth = smooth && std::abs(exact_tiny_light(lamp_at, x, y) - light) < kEdge;
            }
            wrong += smooth && !(std::abs(picture.at(i, j).r - light) < kClose);
        }
    }
    return wrong;
}

double s03_ours(const Stage& stage) {
    const Vec3<double>& lamp_at = stage.beyond_formats(tiny_balls(1, kTinyLamp), "position") ? kNearLamp : kTinyLamp;
    const auto picture = [&](double scale) { return stage.render(tiny_balls(scale, lamp_at), kSide, kSide); };
    return tiny_faults(picture(1), picture(kLarger), lamp_at);
}

/// What the ray sees of the two balls, with the usual epsilon against hits of the own surface.
float light_with_epsilon(Vec3<float> d, float scale) {
    constexpr float kEpsilon = 1e-3f;
    const Vec3<float> light = naive::times(naive::rounded(kTinyLamp), scale);
    Vec3<float> centres[2];
    float radii[2], nearest = std::numeric_limits<float>::infinity();
    int seen = -1;
    for (int k = 0; k < 2; ++k) {
        centres[k] = naive::times(naive::rounded(kTinyBalls[k]), scale);
        radii[k] = float(kTinyRadii[k]) * scale;
        const naive::Roots roots = naive::sphere({0, 0, 0}, d, centres[k], radii[k]);
        if (roots.real && roots.first > kEpsilon && roots.first < nearest) nearest = roots.first, seen = k;
    }
    if (seen < 0) return 0;
    const Vec3<float> p = naive::times(d, nearest);
    for (int k = 0; k < 2; ++k) {
        const naive::Roots roots = naive::sphere(p, naive::unit(naive::minus(light, p)), centres[k], radii[k]);
        if (roots.real && roots.first > kEpsilon) return 0;
    }
    return naive::lambert(p, naive::times(naive::minus(p, centres[seen]), 1 / radii[seen]), light);
}

Picture naive_tiny_balls(float scale) {
    Picture picture{kSide, kSide, {}};
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const float x = float(2 * kTiny) * (float(2 * i + 1) / kSide - 1);
            const float y = float(2 * kTiny) * (1 - float(2 * j + 1) / kSide);
            picture.rgb.insert(picture.rgb.end(), 3, light_with_epsilon(naive::unit({x, y, -1}), scale));
        }
    }
    return picture;
}

double s03_naive() { return tiny_faults(naive_tiny_balls(1), naive_tiny_balls(float(kLarger)), kTinyLamp); }

// S04: from 1 above a planet of radius 1e5, where does it end and the sky begin?
constexpr double kPlanet = 1e5, kHeight = 1;

/// The relative error of the distance to the horizon, sqrt(2 r h + h^2) = r tan(dip), where rays that dip less than
/// some angle do not meet the planet.
template <class Meets>
double horizon_error(const Meets& meets) {
    double above = 0, below = 0.1;  // radians
    for (int step = 0; step < 50; ++step) {
        const double dip = (above + below) / 2;
        (meets(dip) ? below : above) = dip;
    }
    const double distance = std::sqrt(2 * kPlanet * kHeight + kHeight * kHeight);
    return std::abs(kPlanet * std::tan(below) / distance - 1);
}

double s04_ours(const Stage& stage) {
    Scene scene;
    add(scene, ball({0, -kPlanet, 0}, kPlanet, glowing({1, 1, 1})));
    return horizon_error([&](double dip) {
        return stage.look(scene, {0, kHeight, 0}, {0, -std::sin(dip), -std::cos(dip)}).r > 0;
    });
}

double s04_naive() {
    return horizon_error([](double dip) {
        const Vec3<float> d{0, float(-std::sin(dip)), float(-std::cos(dip))};
        const naive::Roots roots = naive::sphere({0, float(kHeight), 0}, d, {0, float(-kPlanet), 0}, float(kPlanet));
        return roots.real && roots.first > 0;
    });
}

// S19: tangent rays whose distance from the centre is the radius, exactly: sides of right triangles.
constexpr int kTriples[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}, {12, 35, 37}};
constexpr double kStarts[] = {1, 100.3, 5000.3, 70000.1};

/// Tangent rays that do not show the sphere lit in the point of touch. Two lamps, one a mirror image of the other in
/// the tangent plane: there the normal may point to either side.
template <class Light>
double lost_tangents(const Light& light) {
    int lost = 0;
    for (const auto& [a, b, r] : kTriples) {
        for (const double start : kStarts) {
            const Vec3<double> touched{double(a), double(b), 0};
            const Vec3<double> lamps[] = {{3.0 * a, 3.0 * b, 10}, {-1.0 * a, -1.0 * b, 10}};
            const double expected = exact::lambert(touched, exact::times(touched, 1.0 / r), lamps[0]);
            lost += !(std::abs(light(touched, start, double(r), lamps) - expected) < 1e-5);
        }
    }
    return lost;
}

double s19_ours(const Stage& stage) {
    return lost_tangents([&](const Vec3<double>& touched, double start, double r, const Vec3<double>* lamps) {
        Scene scene;
        add(scene, ball({0, 0, 0}, r, chalk()));
        add(scene, lamp(lamps[0]));
        add(scene, lamp(lamps[1]));
        return double{stage.look(scene, {touched.x, touched.y, start}, {0, 0, -1}).r};
    });
}

double s19_naive() {
    return lost_tangents([](const Vec3<double>& touched, double start, double r, const Vec3<double>* lamps) {
        const Vec3<float> o = naive::rounded({touched.x, touched.y, start}), d{0, 0, -1};
        const naive::Roots roots = naive::sphere(o, d, {0, 0, 0}, float(r));
        if (!roots.real) return 0.0;
        const Vec3<float> p = naive::along(o, roots.first, d), n = naive::times(p, float(1 / r));
        return double{naive::lambert(p, n, naive::rounded(lamps[0])) + naive::lambert(p, n, naive::rounded(lamps[1]))};
    });
}

constexpr StiffCase kRows[] = {
    {"S03", "a sphere of radius 1e-4 at 1, in the shadow of another", "r^2 drowns beside f.f, epsilon 1e-3 in all else",
     "the same bits as 2^13 times larger; away from edges the closed form", "wrong pixels", 0, s03_ours, s03_naive,
     {.refused = "position"}},
    {"S04", "camera 1 above a sphere of radius 1e5", "c = f.f - r^2 keeps no digit of the height",
     "the horizon lies sqrt(2 r h + h^2) away", "relative", 1e-5, s04_ours, s04_naive},
    {"S19", "tangent rays, r away from the centre to the last digit", "b^2 - 4ac is noise: hit or miss by chance",
     "discriminant 0 is a hit, in the point of touch", "tangents lost", 0, s19_ours, s19_naive},
};

}  // namespace

std::span<const StiffCase> sphere_rows() { return kRows; }

}  // namespace zerkalo::stability
