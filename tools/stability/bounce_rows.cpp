// Rays that never end: facing reflectors, a hollow mirror that sees itself, total reflection inside glass.
#include "tools/stability/exact.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <numbers>

namespace zerkalo::stability {
namespace {

// ---- Facing reflectors

constexpr double kGains[] = {1, 0.9, 0.5};
constexpr int kDepths[] = {0, 1, 2, 6, 64, 255};

double truncated_series(double gain, int depth) {
    return gain == 1 ? depth + 1 : (1 - std::pow(gain, depth + 1)) / (1 - gain);
}

/// The largest relative error of what two facing reflectors show that glow with 1. shown(gain, depth limit).
template <class Shown>
double wrong_series(const Shown& shown) {
    double largest = 0;
    for (const double gain : kGains) {
        for (const int depth : kDepths) {
            largest = std::max(largest, std::abs(shown(gain, depth) / truncated_series(gain, depth) - 1));
        }
    }
    return largest;
}

double s46_ours(const Stage& stage) {
    return wrong_series([&](double gain, int depth) {
        Scene scene;
        add(scene, ideal_mirror({0, 0, 0}, {0, 1, 0}, 2));
        scene.mirrors[0].up = {0, 0, -1};
        scene.mirrors[0].ambient = 1;
        scene.mirrors[0].reflection = gain;
        add(scene, upright(SolidKind::prism, {0, 1, 0}, 2, 1, glowing({1, 1, 1})));
        scene.solids[0].material.reflection = gain;
        Settings settings;
        settings.depth_limit = depth;
        return double{stage.look(scene, {0.1, 0.5, 0.2}, {0, -1, 0}, settings).g};
    });
}

/// Without a limit: until the sum does not change any more.
double s46_naive() {
    return wrong_series([](double gain, int) {
        float sum = 0, weight = 1;
        while (sum + weight != sum) {
            sum += weight;
            weight *= float(gain);
        }
        return double{sum};
    });
}

// ---- A whispering gallery

constexpr double kRim = 0.9999;  // of the hemisphere's boundary, radii

/// Reflections on their way round a hemisphere from angle `start`, each 2 `grazing` on; the rim lies at 0 and pi.
int reflections(double start, double grazing) {
    const double last = std::numbers::pi - std::acos(kRim);
    return static_cast<int>((last - start) / (2 * grazing)) + 1;
}

/// The largest error of the number of reflections. shown(from, view, depth limit): how many are counted.
template <class Shown>
double wrong_reflections(const Shown& shown) {
    double largest = 0;
    constexpr double kStart = 0.05;
    for (const double grazing : {0.007, 0.02, 0.05, 0.11, 0.3, 0.7, 1.2}) {
        for (const int depth : {6, 255}) {
            const auto on_circle = [](double angle) { return exact::Vec{-std::cos(angle), -std::sin(angle), 0}; };
            const exact::Vec before = on_circle(kStart - 2 * grazing), first = on_circle(kStart);
            const exact::Vec middle = exact::times(exact::plus(before, first), 0.5);
            const double counted = shown(middle, exact::minus(first, before), depth);
            const int all = std::min(reflections(kStart, grazing), depth + 1);
            largest = std::max(largest, std::abs(counted - all));
        }
    }
    return largest;
}

double s47_ours(const Stage& stage) {
    return wrong_reflections([&](const exact::Vec& from, const exact::Vec& view, int depth) {
        Scene scene;
        Mirror mirror = ideal_mirror({0, -1, 0}, {0, 1, 0}, 1);
        mirror.up = {0, 0, -1};
        mirror.boundary.shape = BoundaryShape::disc;
        mirror.boundary.radius = kRim;
        mirror.curvature_radius = 1;
        mirror.ambient = 1;
        add(scene, mirror);
        Settings settings;
        settings.depth_limit = depth;
        return double{stage.look(scene, from, view, settings).g};
    });
}

/// The nearest root ahead of the reflected point, whichever it is.
double s47_naive() {
    return wrong_reflections([](const exact::Vec& from, const exact::Vec& view, int depth) {
        Vec3<float> o{float(from.x), float(from.y), 0};
        Vec3<float> d = naive::unit({float(view.x), float(view.y), 0});
        int count = 0;
        while (count <= depth) {
            const naive::Roots hit = naive::sphere(o, d, {0, 0, 0}, 1);
            const float t = hit.real ? (hit.first > 0 ? hit.first : hit.second) : 0;
            if (!(t > 0)) break;
            o = naive::along(o, t, d);
            if (o.y > -std::sqrt(1 - float(kRim * kRim))) break;
            d = naive::along(d, -2 * naive::dot(d, o), o);
            ++count;
        }
        return double(count);
    });
}

// ---- Total reflection

constexpr double kIndex = 1.5, kReflection = 0.25, kTransmission = 0.75, kGlow = 0.125;
constexpr int kDepth = 16;

/// What an eye in a glass ball sees along a chord that meets the wall at the given angle, in a white room.
double inside_glass(double angle) {
    const bool total = kIndex * std::sin(angle) > 1;
    const double gain = total ? kReflection + kTransmission : kReflection;
    return kGlow * truncated_series(gain, kDepth) + (total ? 0 : kTransmission * truncated_series(gain, kDepth - 1));
}

template <class Shown>
double wrong_inside_glass(const Shown& shown) {
    double largest = 0;
    const double critical = std::asin(1 / kIndex);
    for (const double off : {-0.6, -0.1, -1e-3, -1e-5, 1e-5, 1e-3, 0.1, 0.6}) {
        const double error = std::abs(shown(critical + off) / inside_glass(critical + off) - 1);
        if (std::isnan(error)) return error;
        largest = std::max(largest, error);
    }
    return largest;
}

Scene glass_ball(double index, double glow) {
    Scene scene;
    scene.background = {1, 1, 1};
    Material glass = glowing({1, 1, 1});
    glass.ambient = glow;
    glass.reflection = kReflection;
    glass.transmission = kTransmission;
    glass.refractive_index = index;
    add(scene, ball({0, 0, 0}, 1, glass));
    scene.camera = camera_at({0, 0, 3}, {0, 0, -1}, 0.75);
    return scene;
}

double s48_ours(const Stage& stage) {
    Settings settings;
    settings.depth_limit = kDepth;
    const double inside = wrong_inside_glass([&](double angle) {
        return double{stage.look(glass_ball(kIndex, kGlow), {0, std::sin(angle), 0}, {1, 0, 0}, settings).g};
    });
    // A bubble reflects totally from outside: as bright as the white room, but for 1/4 to the 17th.
    constexpr int kSide = 32;
    double most = inside;
    for (const float light : stage.render(glass_ball(1 / kIndex, 0), kSide, kSide, settings).rgb) {
        most = std::max(most, std::abs(double{light} - 1));
    }
    return most;
}

/// The series without total reflection: every wall lets K_t through, along a direction from Snell's cosine.
double s48_naive() {
    return wrong_inside_glass([](double angle) {
        const float sine = float(kIndex) * float(std::sin(angle)), cosine = std::sqrt(1 - sine * sine);
        const float direction = std::sqrt(sine * sine + cosine * cosine);
        float sum = 0, weight = 1;
        for (int depth = 0; depth <= kDepth; ++depth) {
            sum += weight * float(kGlow) + (depth < kDepth ? weight * float(kTransmission) * direction : 0);
            weight *= float(kReflection);
        }
        return double{sum};
    });
}

constexpr StiffCase kRows[] = {
    {"S46", "two facing reflectors, K_r up to 1, depth limit 0 to 255",
     "recursion ends when float cannot count further", "the geometric series, cut off at the depth limit", "relative",
     1e-6, s46_ours, s46_naive},
    {"S47", "a ray that whispers along a hollow hemisphere", "the root that is zero comes out as 1e-8: false bounces",
     "as many reflections as chords fit in, or as the depth limit allows", "reflections", 0, s47_ours, s47_naive},
    {"S48", "total reflection inside a glass ball, outside a bubble", "Snell's cosine is the root of a negative number",
     "K_t joins K_r: closed forms on both sides of the critical angle, white room white", "relative", 1e-6, s48_ours,
     s48_naive},
};

}  // namespace

std::span<const StiffCase> bounce_rows() { return kRows; }

}  // namespace zerkalo::stability
