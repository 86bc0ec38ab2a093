// Rays along axes, generators, faces and caps: where an equation loses its leading term or divides by zero.
#include "tools/stability/exact.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <limits>
#include <numbers>

namespace zerkalo::stability {
namespace {

constexpr float kEndless = std::numeric_limits<float>::infinity();

/// The larger of both; NaN stays.
double worse(double a, double b) { return b <= a ? a : b; }

/// What a ray shows of a chalk solid under a lamp.
double light_on(const Stage& stage, const Solid& solid, const Vec3<double>& lamp_at, const Vec3<double>& o,
                const Vec3<double>& d) {
    Scene scene;
    add(scene, solid);
    add(scene, lamp(lamp_at));
    return stage.look(scene, o, d).r;
}

// S15, S16: cones of these radii and heights, apex up.
struct ConeSize {
    double radius, height;
};
constexpr ConeSize kCones[] = {{1, 1}, {3, 4}, {0.5, 2}, {12, 5}, {1, 1000}};
// In fixed point: the radius of the last cone is 2^20 steps of a length, its height 2^30. A step of the radius is a
// thousand of the height, where the lamp stands close by, and the generators' rays meet it at a sine below 1/1000.
constexpr double kNeedle15 = 1e-4, kNeedle16 = 4e-3;

// S15: straight down onto the apex. The lamp stands so that N.L is 0.8 for the normal of the axis.
template <class Light>
double apex_error(const Light& light) {
    double largest = 0;
    for (const ConeSize& cone : kCones) largest = worse(largest, std::abs(light(cone) - 0.8));
    return largest;
}

double s15_ours(const Stage& stage) {
    return apex_error([&](const ConeSize& cone) {
        const Solid solid = upright(SolidKind::cone, {0, 0, 0}, cone.radius, cone.height, chalk());
        const double h = cone.height;
        return light_on(stage, solid, {3, h + 4, 0}, {0, h + 7, 0}, {0, -1, 0});
    });
}

/// The normal is the gradient of x^2 + z^2 - (r - k y)^2, made a unit vector.
double s15_naive() {
    return apex_error([](const ConeSize& cone) {
        const float h = float(cone.height), k = float(cone.radius / cone.height);
        const Vec3<float> apex{0, h, 0};
        const Vec3<float> gradient{apex.x, k * (float(cone.radius) - k * apex.y), apex.z};
        return naive::lambert(apex, naive::unit(gradient), {3, h + 4, 0});
    });
}

// S16: rays parallel to the generator at +z, which meet the cone at other angles about its axis.
constexpr double kAngles[] = {-90, -60, 0, 30, 200};
constexpr double kHitAt = 0.4;  // of the height

template <class Light>
double generator_error(const Light& light) {
    double largest = 0;
    for (const ConeSize& cone : kCones) {
        for (const double degrees : kAngles) {
            const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
            const double rho = cone.radius * (1 - kHitAt);
            const Vec3<double> p{rho * c, kHitAt * cone.height, rho * s};
            const Vec3<double> n = exact::unit({cone.height * c, cone.radius, cone.height * s});
            const Vec3<double> d = exact::unit({0, -cone.height, cone.radius});
            const Vec3<double> lamp_at = exact::along(p, 4, exact::unit(exact::plus(n, {0.3, 0.2, -0.1})));
            const double got = light(cone, exact::along(p, -3, d), d, lamp_at);
            largest = worse(largest, std::abs(got - exact::lambert(p, n, lamp_at)));
        }
    }
    return largest;
}

double s16_ours(const Stage& stage) {
    return generator_error(
        [&](const ConeSize& cone, const Vec3<double>& o, const Vec3<double>& d, const Vec3<double>& lamp_at) {
            const Solid solid = upright(SolidKind::cone, {0, 0, 0}, cone.radius, cone.height, chalk());
            return light_on(stage, solid, lamp_at, o, d);
        });
}

double s16_naive() {
    return generator_error([](const ConeSize& cone, const Vec3<double>& origin, const Vec3<double>& direction,
                              const Vec3<double>& lamp_at) {
        const Vec3<float> o = naive::rounded(origin), d = naive::rounded(direction);
        const float k = float(cone.radius / cone.height), m = float(cone.radius) - k * o.y, n = -k * d.y;
        const naive::Roots roots = naive::roots(d.x * d.x + d.z * d.z - n * n, 2 * (o.x * d.x + o.z * d.z - m * n),
                                                o.x * o.x + o.z * o.z - m * m);
        for (const float t : {roots.first, roots.second}) {
            const Vec3<float> p = naive::along(o, t, d);
            if (!roots.real || !(t > 0) || p.y < 0 || p.y > float(cone.height)) continue;
            const float radius = std::sqrt(p.x * p.x + p.z * p.z);
            return naive::lambert(p, naive::unit({p.x, k * radius, p.z}), naive::rounded(lamp_at));
        }
        return 0.0f;
    });
}

// S17, S18: slabs lo <= n.p <= hi.
struct NaiveSlab {
    Vec3<float> n;
    float lo, hi;
};

/// Clips near..far to the slab by the sign of n.d, as Smits did: "Efficiency Issues for Ray Tracing", 1998.
void naive_clip(const NaiveSlab& slab, Vec3<float> o, Vec3<float> d, float& near, float& far) {
    const float along = naive::dot(slab.n, d), s = naive::dot(slab.n, o);
    const float first = along >= 0 ? (slab.lo - s) / along : (slab.hi - s) / along;
    const float last = along >= 0 ? (slab.hi - s) / along : (slab.lo - s) / along;
    if (first > near) near = first;
    if (last < far) far = last;
}

// S17: rays parallel to faces of a prism of four sides: its caps at y = 0 and 1, its sides at 0.7 along (1, 0, +-1).
struct ParallelRay {
    Vec3<double> passes, d;
    bool meets;
};
const ParallelRay kParallelRays[] = {
    {{0, 0.5, 0}, {1, 0, 0.25}, true},      {{0, 0.5, 0}, {-1, -0.0, -0.25}, true},
    {{0, 1.5, 0}, {1, 0, 0.25}, false},     {{0, -0.5, 0}, {-1, -0.0, -0.25}, false},
    {{0.25, 0.5, 0.25}, {1, 0, -1}, true},  {{-0.25, 0.5, -0.25}, {-1, 0, 1}, true},
    {{0.75, 0.5, 0.75}, {1, 0, -1}, false}, {{-0.75, 0.5, -0.75}, {-1, 0, 1}, false},
    {{0.25, 0.5, 0.125}, {0, 1, 0}, true},  {{0.25, 0.5, 0.125}, {-0.0, -1, -0.0}, true},
    {{0.75, 0.5, 0.75}, {0, 1, 0}, false},  {{0.75, 0.5, -0.75}, {-0.0, -1, -0.0}, false},
};

template <class Meets>
double wrong_parallels(const Meets& meets) {
    int wrong = 0;
    for (const ParallelRay& ray : kParallelRays)
        wrong += meets(exact::along(ray.passes, -4, ray.d), ray.d) != ray.meets;
    return wrong;
}

double s17_ours(const Stage& stage) {
    Scene scene;
    add(scene, upright(SolidKind::prism, {0, 0, 0}, 1, 1, glowing({1, 1, 1})));
    double wrong = 0;
    for (const double sense : {1.0, -1.0}) {  // of up: zeros of either sign
        scene.camera.up = {0.1 * sense, sense, 0};
        wrong += wrong_parallels(
            [&](const Vec3<double>& o, const Vec3<double>& d) { return stage.look(scene, o, d).r > 0; });
    }
    return wrong;
}

double s17_naive() {
    const float c = std::sqrt(0.5f);
    const NaiveSlab slabs[] = {{{c, 0, c}, -c, c}, {{-c, 0, c}, -c, c}, {{0, 1, 0}, 0, 1}};
    return wrong_parallels([&](const Vec3<double>& o, const Vec3<double>& d) {
        float near = -kEndless, far = kEndless;
        for (const NaiveSlab& slab : slabs) {
            naive_clip(slab, naive::rounded(o), naive::unit(naive::rounded(d)), near, far);
        }
        return near <= far && near > 0;
    });
}

// S18: rays in the plane of the caps between two cylinders, one on the other; and with the lower one alone.
constexpr double kOffsets[] = {0, 0.3, -0.7, 0.95};
const Vec3<double> kCapLamp{20, 30, 10};
constexpr int kAround = 16;
constexpr float kNothing = 2;

/// Rays that see nothing of the two, or of the lower one alone neither its lateral face nor nothing.
/// `light(count, o, d)`: of one or both.
template <class Light>
double lost_in_cap_plane(const Light& light) {
    int lost = 0;
    for (int k = 0; k < kAround; ++k) {
        const double angle = 2 * std::numbers::pi * k / kAround;
        const Vec3<double> d{std::cos(angle), k % 2 == 0 ? 0.0 : -0.0, std::sin(angle)}, beside{-d.z, 0, d.x};
        for (const double offset : kOffsets) {
            const Vec3<double> passes = exact::along({0, 1, 0}, offset, beside), o = exact::along(passes, -5, d);
            const Vec3<double> p = exact::along(passes, -std::sqrt(1 - offset * offset), d);
            const double alone = light(1, o, d), lateral = exact::lambert(p, {p.x, 0, p.z}, kCapLamp);
            lost += !(light(2, o, d) <= 1) + !(alone == kNothing || std::abs(alone - lateral) < 1e-4);
        }
    }
    return lost;
}

double s18_ours(const Stage& stage) {
    return lost_in_cap_plane([&](int count, const Vec3<double>& o, const Vec3<double>& d) {
        Scene scene;
        scene.background = {kNothing, kNothing, kNothing};
        for (int k = 0; k < count; ++k) add(scene, upright(SolidKind::cylinder, {0, double(k), 0}, 1, 1, chalk()));
        add(scene, lamp(kCapLamp));
        return stage.look(scene, o, d).r;
    });
}

double s18_naive() {
    return lost_in_cap_plane([](int count, const Vec3<double>& origin, const Vec3<double>& direction) {
        const Vec3<float> o = naive::rounded(origin), d = naive::rounded(direction);
        const naive::Roots roots =
            naive::roots(d.x * d.x + d.z * d.z, 2 * (o.x * d.x + o.z * d.z), o.x * o.x + o.z * o.z - 1);
        for (int k = 0; k < count; ++k) {
            float near = roots.first, far = roots.second;
            naive_clip({{0, 1, 0}, float(k), float(k + 1)}, o, d, near, far);
            const Vec3<float> p = naive::along(o, near, d);
            if (near <= far) return naive::lambert(p, {p.x, 0, p.z}, naive::rounded(kCapLamp));
        }
        return kNothing;
    });
}

constexpr StiffCase kRows[] = {
    {"S15", "straight down the axis onto the apex of a cone", "the gradient there is zero, its unit vector NaN",
     "a hit at the apex with the normal of the axis", "of full light", 1e-6, s15_ours, s15_naive,
     {.bound = kNeedle15}},
    {"S16", "rays parallel to a generator of a cone", "A = 0: the root is 0 / 0, or lost", "the one root -C / 2B",
     "of full light", 1e-4, s16_ours, s16_naive, {.bound = kNeedle16}},
    {"S17", "rays parallel to faces of a prism, zeros of either sign", "-0 counts as positive: inside is outside",
     "outside of the slab none meets, inside the others decide", "wrong rays", 0, s17_ours, s17_naive},
    {"S18", "rays in the plane between two stacked cylinders", "0 / 0, and -0 counts as positive: a seam",
     "each shows one of the two; of one alone the lateral face or nothing", "lost rays", 0, s18_ours, s18_naive},
};

}  // namespace

std::span<const StiffCase> parallel_ray_rows() { return kRows; }

}  // namespace zerkalo::stability
