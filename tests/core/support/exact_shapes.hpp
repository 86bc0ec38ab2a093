// Spans of the solids in closed form, in long double, from the very constants that the lanes read.
//
// `grow` moves the whole surface outwards (or inwards, negative) by a distance. An answer in float is right when it
// lies between the answers of the solid shrunk and grown by a few roundings of its size and of the ray's way to it:
// that one sentence holds at edges, at the rim and for grazing rays, where a bound on t alone would need exceptions.
#pragma once

#include "core/shapes/shape_data.hpp"
#include "tests/core/support/exact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace zerkalo::test {

constexpr Real80 kFar80 = std::numeric_limits<Real80>::infinity();

/// Inside for entry < t < exit.
struct ExactSpan {
    Real80 entry = kFar80, exit = -kFar80;
    bool empty() const { return !(entry < exit); }
    Real80 length() const { return empty() ? 0 : exit - entry; }
};

/// Keeps what lies inside the half-space n.p <= c too.
inline void clip(ExactSpan& span, const Exact3& n, Real80 c, const Exact3& o, const Exact3& d) {
    const Real80 along = dot(n, d), room = c - dot(n, o);
    if (along == 0 && room < 0) span = {};
    if (along > 0) span.exit = std::min(span.exit, room / along);
    if (along < 0) span.entry = std::max(span.entry, room / along);
}

inline ExactSpan exact_span(const SphereData& sphere, const Exact3& o, const Exact3& d, Real80 grow) {
    const Exact3 f = o - exact(sphere.centre);
    const Real80 radius = std::sqrt(Real80(sphere.radius2)) + grow;
    const Real80 a = dot(d, d), b = dot(f, d);
    const Real80 disc = b * b - a * (dot(f, f) - radius * radius);
    if (radius < 0 || disc < 0) return {};
    return {(-b - std::sqrt(disc)) / a, (-b + std::sqrt(disc)) / a};
}

inline ExactSpan exact_span(const Slab* slabs, const HalfSpacesData& body, const Exact3& o, const Exact3& d,
                            Real80 grow) {
    const Exact3 from = o - exact(body.centre);
    ExactSpan span{-kFar80, kFar80};
    for (int s = body.first_slab; s < body.first_slab + body.slab_count; ++s) {
        const Exact3 n = exact(slabs[s].n);
        clip(span, n, slabs[s].hi + grow, from, d);
        if (std::isfinite(slabs[s].lo)) clip(span, -n, grow - slabs[s].lo, from, d);
    }
    return span;
}

/// A tube's span by trial: of all crossings with its lateral surface and its two end planes, those where the ray
/// changes sides bound it. A point is inside where |y| <= h and its distance from the axis is at most r + k y.
inline ExactSpan exact_span(const TubeData& tube, const Exact3& o, const Exact3& d, Real80 grow) {
    const auto axes = [&](const Exact3& v) {
        return Exact3{dot(exact(tube.axis_x), v), dot(exact(tube.axis_y), v), dot(exact(tube.axis_z), v)};
    };
    const Exact3 p = axes(o - exact(tube.centre)), v = axes(d);
    const Real80 k = tube.slope, h = tube.half_height + grow;
    const Real80 r = tube.mid_radius + grow * std::sqrt(1 + k * k);
    const auto inside = [&](Real80 t) {
        const Exact3 q = p + v * t;
        const Real80 radius = r + k * q.y;
        return std::abs(q.y) <= h && radius >= 0 && q.x * q.x + q.z * q.z <= radius * radius;
    };
    std::vector<Real80> crossings;
    const auto add = [&](Real80 t) {
        if (std::isfinite(t)) crossings.push_back(t);
    };
    add((h - p.y) / v.y), add((-h - p.y) / v.y);
    const Real80 m = r + k * p.y, n = k * v.y;
    const Real80 a = v.x * v.x + v.z * v.z - n * n, b = p.x * v.x + p.z * v.z - m * n;
    const Real80 c = p.x * p.x + p.z * p.z - m * m, disc = b * b - a * c;
    if (disc >= 0) {
        const Real80 q = -(b + std::copysign(std::sqrt(disc), b));
        add(c / q), add(q / a);
    }
    std::sort(crossings.begin(), crossings.end());
    // The solid is convex, so the inside is one interval between neighbouring crossings, asked at its middle.
    ExactSpan span;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        if (!inside((crossings[i] + crossings[i + 1]) / 2)) continue;
        span.entry = std::min(span.entry, crossings[i]);
        span.exit = std::max(span.exit, crossings[i + 1]);
    }
    return span;
}

}  // namespace zerkalo::test
