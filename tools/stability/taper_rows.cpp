// Tapered tubes at the edges of their family: almost a cylinder, a cone to the last bit, wider on top.
#include "tools/stability/naive_shapes.hpp"
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <numbers>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 49;  // pixels a side; odd, so that one looks along the axis

Scene tube(double base_radius, double taper, const Vec3<double>& position, const Vec3<double>& rotation) {
    Scene scene;
    scene.ambient = {0, 0, 0};
    add(scene, lamp({3, 4, 5}));
    add(scene, upright(SolidKind::cylinder, position, base_radius, 1, chalk()));
    scene.solids[0].taper = taper;
    scene.solids[0].rotation = rotation;
    scene.camera = camera_at({0.4, 1.9, 4}, {-0.1, -0.35, -1}, 0.8);
    return scene;
}

/// What the textbook's tube shows along the view of tube(): Lambert's cosine towards a lamp far away, 2 for a miss.
/// Only the wall: the caps are the same in every formula.
template <class Each>
void each_wall(const Each& each) {
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const float x = 2 * (float(i) + 0.5f) / kSide - 1, y = 2 * (float(j) + 0.5f) / kSide - 1;
            each(Vec3<float>{0, 0.5f, 4}, naive::unit({0.3f * x, 0.15f * y, -1}));
        }
    }
}
float wall_light(const naive::WallHit& hit) {
    constexpr float kMiss = 2;
    return hit.real ? naive::dot(hit.normal, naive::unit({3, 4, 5})) : kMiss;
}

// ---- Almost a cylinder

constexpr double kUlp = 0x1p-23;

double s28_ours(const Stage& stage) {
    const auto picture = [&](double taper) { return stage.render(tube(1, taper, {0, 0, 0}, {0, 0, 0}), kSide, kSide); };
    const Picture cylinder = picture(1);
    return std::max(largest_difference(cylinder, picture(1 - kUlp)), largest_difference(cylinder, picture(1 + kUlp)));
}

double s28_naive() {
    double largest = 0;
    each_wall([&](Vec3<float> o, Vec3<float> d) {
        const float cylinder = wall_light(naive::tube_wall(o, d, 1, 1, 1));
        for (const float top : {1 - float(kUlp), 1 + float(kUlp)}) {
            const float cone = wall_light(naive::tube_wall(o, d, 1, top, 1));
            largest = std::fmax(largest, double{std::abs(cone - cylinder)});
        }
    });
    return largest;
}

// ---- A cone and its last bit of a cap

Scene cone_from_above(double taper) {
    Scene scene = tube(1, taper, {0, 0, 0}, {0, 0, 0});
    scene.camera = camera_at({0, 4, 0}, {0, -1, 0}, 0.6);
    return scene;
}

double s29_ours(const Stage& stage) {
    const Picture sharp = stage.render(cone_from_above(0), kSide, kSide);
    const Picture blunt = stage.render(cone_from_above(0x1p-100), kSide, kSide);
    // At the tip the axis is the normal: the lamp stands 3 above it and sqrt(3^2 + 5^2) beside it.
    const double tip = 3 / std::sqrt(3.0 * 3 + 3 * 3 + 5 * 5);
    return largest_difference(sharp, blunt) + std::abs(sharp.at(kSide / 2, kSide / 2).r - tip);
}

/// Hill's form: p = (0, y, 0) on the axis, normal (x, z, -k m) / m with the local radius m = 1 + k y.
double s29_naive() {
    const auto tip = [](float taper) {
        const float k = taper - 1, m = 1 + k;
        const Vec3<float> normal = naive::unit({0 / m, -k * m / m, 0 / m});
        const Vec3<float> to_lamp = naive::unit({3, 3, 5});
        return naive::dot(normal, to_lamp);
    };
    return std::abs(double{tip(0)} - double{tip(0x1p-100f)});
}

// ---- Wider on top

double s30_ours(const Stage& stage) {
    const Picture funnel = stage.render(tube(0.5, 2, {0, 0, 0}, {0, 0, 0}), kSide, kSide);
    const Picture turned = stage.render(tube(1, 0.5, {0, 1, 0}, {std::numbers::pi, 0, 0}), kSide, kSide);
    return largest_difference(funnel, turned);
}

double s30_naive() {
    double largest = 0;
    each_wall([&](Vec3<float> o, Vec3<float> d) {
        const float funnel = wall_light(naive::tube_wall(o, d, 0.5f, 1, 1));
        naive::WallHit turned = naive::tube_wall({o.x, 1 - o.y, o.z}, {d.x, -d.y, d.z}, 1, 0.5f, 1);
        turned.normal.y = -turned.normal.y;
        largest = std::fmax(largest, double{std::abs(wall_light(turned) - funnel)});
    });
    return largest;
}

constexpr StiffCase kRows[] = {
    {"S28", "tubes of taper 1 - 2^-23, 1 and 1 + 2^-23", "the apex lies 8e6 away: its cone loses the wall's digits",
     "the three pictures are the same", "brightness", 1e-6, s28_ours, s28_naive},
    {"S29", "cones of taper 0 and 2^-100, seen along the axis", "the normal divides by the radius at the apex: 0 / 0",
     "the pictures are the same, and the apex has the axis for its normal", "brightness", 1e-6, s29_ours, s29_naive},
    {"S30", "a tube of taper 2", "the apex lies below the base: the formula takes the wrong nappe",
     "it looks like taper 1/2 upside down", "brightness", 1e-6, s30_ours, s30_naive},
};

}  // namespace

std::span<const StiffCase> taper_rows() { return kRows; }

}  // namespace zerkalo::stability
