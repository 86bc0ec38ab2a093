// Glass that is hardly there, and glass that bends more than any.
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace zerkalo::stability {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();  // an error where there is no answer at all

Material glass(double index) {
    Material material = glowing({0, 0, 0});
    material.transmission = 1;
    material.refractive_index = index;
    return material;
}

// S49. A row of glowing balls behind a ball of index 1, looked at along -z, parallel rays.

constexpr int kSide = 64;           // pixels a side
constexpr double kHalfView = 0.25;  // tangent of half the angle of view
constexpr double kEye = 6;
constexpr int kDepth = 2;  // into the ball and out of it: nothing to spare

struct Behind {
    double x, y, radius;
    Rgb<double> color;
};
constexpr double kBehind = -3;  // z of their centres
constexpr Behind kBalls[] = {{-1.1, 0.4, 0.7, {1, 0.25, 0.125}}, {0.6, -0.7, 0.9, {0.125, 1, 0.25}},
                             {0.9, 1.0, 0.5, {0.25, 0.125, 1}}};
constexpr Rgb<double> kSky{0.25, 0.5, 0.75};

Scene balls_behind() {
    Scene scene;
    scene.background = kSky;
    scene.camera = camera_at({0, 0, kEye}, {0, 0, -1}, 2 * std::atan(kHalfView));
    for (const Behind& b : kBalls) add(scene, ball({b.x, b.y, kBehind}, b.radius, glowing(b.color)));
    return scene;
}

double s49_ours(const Stage& stage) {
    const Scene without = balls_behind();
    Scene with = without;
    add(with, ball({0, 0, 0}, 1, glass(1)));
    Settings settings;
    settings.depth_limit = kDepth;
    return pixels_apart(stage.render(without, kSide, kSide), stage.render(with, kSide, kSide, settings));
}

/// The index of the ball behind that the ray meets first, -1 for the sky.
int first_behind(Vec3<float> o, Vec3<float> d) {
    int first = -1;
    float nearest = std::numeric_limits<float>::infinity();
    for (const Behind& b : kBalls) {
        const auto roots = naive::sphere(o, d, {float(b.x), float(b.y), float(kBehind)}, float(b.radius));
        if (!roots.real || roots.first <= 0 || roots.first >= nearest) continue;
        nearest = roots.first;
        first = int(&b - kBalls);
    }
    return first;
}

/// Textbook refraction: every root with t > 0 is a hit, also the one at the point that the ray has just left, and each
/// hit is one step of depth. -2: the depth is used up, and the pixel black.
int seen_through(Vec3<float> o, Vec3<float> d) {
    for (int depth = 0; depth <= kDepth; ++depth) {
        const auto roots = naive::sphere(o, d, {0, 0, 0}, 1);
        const float t = !roots.real ? -1 : roots.first > 0 ? roots.first : roots.second;
        if (t <= 0) return first_behind(o, d);
        o = naive::along(o, t, d);
        const Vec3<float> outward = o;
        const Vec3<float> n = naive::dot(outward, d) < 0 ? outward : naive::times(outward, -1);
        const float cosine = -naive::dot(d, n), behind = std::sqrt(1 - (1 - cosine * cosine));
        d = naive::along(d, cosine - behind, n);
    }
    return -2;
}

double s49_naive() {
    int wrong = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const float x = float(kHalfView * (2 * (i + 0.5) / kSide - 1));
            const float y = float(kHalfView * (1 - 2 * (j + 0.5) / kSide));
            const Vec3<float> eye{0, 0, float(kEye)}, d = naive::unit({x, y, -1});
            wrong += seen_through(eye, d) != first_behind(eye, d);
        }
    }
    return wrong;
}

// S50. Rays along -z at height b into a ball of glass, and a chalk wall behind it whose shade tells where they land.

constexpr double kWall = -3;
constexpr double kLampAbove = 1;  // the wall, and about as far to the side of the landing place
constexpr double kIndices[] = {1 + 0x1p-23, 1e3};
constexpr int kHeights = 33;  // b = 0, 1/64, ... 1/2

/// Where the ray lands on the wall by Snell's law twice (in at the angle i, inside at r, out turned by 2 (i - r)), and
/// how fast that place moves with the angle at which the ray leaves.
struct Landing {
    double x, lever;
};
Landing landing(double b, double index) {
    const double i = std::asin(b), r = std::asin(b / index);
    const double leaving = i - 2 * r, turned = 2 * (i - r), ahead = -std::cos(leaving) - kWall;
    return {-std::sin(leaving) - std::tan(turned) * ahead, ahead / (std::cos(turned) * std::cos(turned))};
}

/// The largest error of the angle at which a ray leaves, told from its landing place, in roundings of the glass: a sine
/// inside is multiplied by the index, its rounding too.
template <class Lands>
double largest_turn(const Lands& lands) {
    double farthest = 0;
    for (const double index : kIndices) {
        for (int k = 0; k < kHeights; ++k) {
            const double b = k / 64.0;
            const Landing exact = landing(b, index);
            const double off = std::abs(lands(b, index) - exact.x) / exact.lever / (index * 0x1p-24);
            if (!(off <= farthest)) farthest = std::isnan(off) ? kNothing : off;
        }
    }
    return farthest;
}

double s50_ours(const Stage& stage) {
    Mirror wall = ideal_mirror({0, 0, kWall}, {0, 0, 1}, 40);
    wall.reflection = 0;
    wall.diffuse = 1;
    return largest_turn([&](double b, double index) {
        const double beside = std::round(landing(b, index).x) - 1;
        Scene scene;
        add(scene, ball({0, 0, 0}, 1, glass(index)));
        add(scene, wall);
        add(scene, lamp({beside, 0, kWall + kLampAbove}));
        if (stage.beyond_formats(scene, "refractive_index")) return landing(b, index).x;
        const double shade = double{stage.look(scene, {b, 0, 4}, {0, 0, -1}).r};
        return beside + std::sqrt(1 / (shade * shade) - 1);  // shade = 1 / sqrt(1 + distance^2)
    });
}

/// The refracted direction of most textbooks: the cosine behind from 1 - eta^2 (1 - cosine^2).
Vec3<float> refracted(Vec3<float> d, Vec3<float> n, float eta) {
    const float cosine = -naive::dot(d, n);
    const float behind = std::sqrt(1 - eta * eta * (1 - cosine * cosine));
    return naive::along(naive::times(d, eta), eta * cosine - behind, n);
}

double s50_naive() {
    return largest_turn([](double b, double index) {
        const Vec3<float> o{float(b), 0, 4}, d{0, 0, -1};
        const Vec3<float> in = naive::along(o, naive::sphere(o, d, {0, 0, 0}, 1).first, d);
        const Vec3<float> inside = refracted(d, in, 1 / float(index));
        const Vec3<float> out = naive::along(in, naive::sphere(in, inside, {0, 0, 0}, 1).second, inside);
        const Vec3<float> after = refracted(inside, naive::times(out, -1), float(index));
        return double{out.x} + double{after.x} / double{after.z} * (kWall - double{out.z});
    });
}

constexpr StiffCase kRows[] = {
    {"S49", "a clear ball of index 1 before glowing balls, depth limit 2",
     "its walls are met again and again: black specks", "the picture without it, to the last bit", "pixels apart", 0,
     s49_ours, s49_naive},
    {"S50", "balls of index 1 + 2^-23 and of index 1000",
     "1 - eta^2 (1 - cos^2) cancels: rays leave anywhere, or never",
     "rays leave at the angle of Snell's law but for 16 roundings inside, times the index", "index 2^-24", 16,
     s50_ours, s50_naive, {.refused = "refractive_index"}},
};

}  // namespace

std::span<const StiffCase> glass_rows() { return kRows; }

}  // namespace zerkalo::stability
