// What a primitive's closed form in long double says of one ray: where it crosses, how steeply, how bent the surface
// is there. Reads the very constants that the lanes read, and shares no code with them. Its own error, 2^-64 of the
// square of a distance of at most 2^10 sizes, is below 2^-16 of a float's rounding wherever a ray is judged.
#pragma once

#include "tests/core/support/exact_shapes.hpp"

#include "core/shapes/mirror_data.hpp"

namespace zerkalo::test {

/// A place where a ray crosses the surface.
struct Crossing {
    Real80 t = kFar80;
    Real80 cosine = 1;     // of incidence, |n.d| / |d|; at an edge that of the flattest face that meets there
    Real80 bend = kFar80;  // radius of curvature
    Real80 rim = kFar80;   // how far inside the outline, along the surface; negative outside
    Real80 loss = 1;       // by how much roundings weigh more here: at tips of cones, on flat triangles
};

/// Near the tip of a cone A, B and C of the quadratic vanish together, but are differences of numbers of the solid's
/// size: what is lost grows as its size over the radius of curvature there. Measured: a sixteenth of that.
inline Real80 tip_loss(const TubeData& tube, Real80 bend) {
    if (tube.slope == 0) return 1;
    const Real80 widest = tube.mid_radius + std::abs(tube.slope) * Real80(tube.half_height);
    return 1 + std::hypot(widest, Real80(tube.half_height)) / (16 * bend);
}

/// Narrows `at` to one more face whose surface passes within `near` of the point.
inline void meet_face(Crossing& at, Real80 cosine, Real80 bend) {
    at.cosine = std::min(at.cosine, cosine);
    at.bend = std::min(at.bend, bend);
}

inline Crossing crossing_at(const SphereData& sphere, const Exact3& o, const Exact3& d, Real80 t, Real80) {
    const Real80 radius = std::sqrt(Real80(sphere.radius2));
    const Exact3 outward = (o + d * t - exact(sphere.centre)) * (1 / radius);
    return {t, std::abs(dot(outward, d)) / length(d), radius};
}

inline Crossing crossing_at(const Slab* slabs, const HalfSpacesData& body, const Exact3& o, const Exact3& d, Real80 t,
                            Real80 near) {
    const Exact3 p = o + d * t - exact(body.centre);
    Crossing at{t};
    for (int s = body.first_slab; s < body.first_slab + body.slab_count; ++s) {
        const Exact3 n = exact(slabs[s].n);
        const Real80 along = dot(n, p);
        const Real80 off = std::min(std::abs(along - slabs[s].hi), std::abs(along - slabs[s].lo));
        if (off <= near) meet_face(at, std::abs(dot(n, d)) / length(d), kFar80);
    }
    return at;
}

inline Crossing crossing_at(const TubeData& tube, const Exact3& o, const Exact3& d, Real80 t, Real80 near) {
    const auto axes = [&](const Exact3& v) {
        return Exact3{dot(exact(tube.axis_x), v), dot(exact(tube.axis_y), v), dot(exact(tube.axis_z), v)};
    };
    const Exact3 v = axes(d), p = axes(o - exact(tube.centre)) + v * t;
    const Real80 k = tube.slope, slant = std::sqrt(1 + k * k);
    const Real80 across = std::hypot(p.x, p.z), radius = tube.mid_radius + k * p.y;
    Crossing at{t};
    if (std::abs(std::abs(p.y) - tube.half_height) <= near) meet_face(at, std::abs(v.y) / length(v), kFar80);
    if (std::abs(across - radius) <= near * slant) {
        const Real80 steepness = std::abs((p.x * v.x + p.z * v.z) / across - k * v.y) / slant;
        meet_face(at, steepness / length(v), radius * slant);
        at.loss = tip_loss(tube, at.bend);
    }
    return at;
}

/// The crossings of a ray with a mirror, nearest first. The whole surface is kappa |p|^2 = 2 z; `outline` says how far
/// inside the boundary a point of the tangent plane lies.
struct Crossings {
    int count = 0;
    Crossing at[2];
    Real80 past = 0;  // of a ray without a crossing: by how much the surface would have to move to be touched
};

template <class Outline>
Crossings mirror_crossings(const MirrorShape& mirror, const Exact3& origin, const Exact3& direction, Outline outline) {
    const auto local = [&](const Exact3& v) {
        return Exact3{dot(exact(mirror.right), v), dot(exact(mirror.v), v), dot(exact(mirror.n), v)};
    };
    const Exact3 o = local(origin - exact(mirror.vertex)), d = local(direction);
    const Real80 kappa = mirror.kappa;
    const Real80 a = kappa * dot(d, d), b = kappa * dot(o, d) - d.z, c = kappa * dot(o, o) - 2 * o.z;
    const Real80 disc = b * b - a * c;
    Crossings found;
    if (disc < 0) {
        found.past = -disc / (2 * std::abs(a));
        return found;
    }
    const Real80 q = -(b + std::copysign(std::sqrt(disc), b));
    for (const Real80 t : {c / q, q / a}) {
        if (!std::isfinite(t)) continue;
        const Exact3 p = o + d * t;
        if (kappa * p.z >= 1) continue;
        const Exact3 n{-kappa * p.x, -kappa * p.y, 1 - kappa * p.z};
        found.at[found.count++] = {t, std::abs(dot(n, d)) / length(d), 1 / std::abs(kappa), outline(p.x, p.y)};
    }
    if (found.count == 2 && found.at[1].t < found.at[0].t) std::swap(found.at[0], found.at[1]);
    return found;
}

/// The crossing with the plane of a triangle; `rim` is the distance from its nearest edge.
inline Crossings triangle_crossings(const TriangleData& triangle, const Exact3& o, const Exact3& d) {
    const Exact3 a = exact(triangle.a), ab = exact(triangle.edge_ab), ac = exact(triangle.edge_ac);
    const Exact3 normal = unit(cross(ab, ac));
    const Real80 along = dot(normal, d);
    if (along == 0) return {};
    const Real80 t = dot(normal, a - o) / along;
    const Exact3 p = o + d * t;
    const auto inside_of = [&](const Exact3& from, const Exact3& edge) {
        return dot(cross(normal, unit(edge)), p - from);
    };
    const Real80 rim = std::min({inside_of(a, ab), inside_of(a + ab, ac - ab), inside_of(a + ac, -ac)});
    // The plane is told by two edges: what they lack of a right angle is lost.
    const Real80 longest = std::max({length(ab), length(ac), length(ac - ab)});
    const Real80 loss = longest * longest / length(cross(ab, ac));
    return {1, {{t, std::abs(along) / length(d), kFar80, rim, loss}, {}}};
}

}  // namespace zerkalo::test
