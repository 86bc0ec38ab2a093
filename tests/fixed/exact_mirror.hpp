// A mirror and its nearest crossing in long double: the curvature form solved by its textbook formula.
#pragma once

#include "tests/fixed/fixed_shapes.hpp"

namespace zerkalo::test {

/// Answers that hang on less than this (a point at the rim, two crossings at the same place) may go either way.
constexpr Real80 kDecision = 1e-5L;

/// Longer ways may leave the range of a length.
constexpr Real80 kLongestRay = 15;

struct MirrorCase {
    ExactFrame frame;
    FixedMirror fixed;
    Real80 size;  // of the boundary, roughly
};

inline FixedBoundary random_boundary(Random& random, Real80 size) {
    FixedBoundary b = fixed_rectangle(size, size * random.uniform(0.5, 1));
    const int kind = random.below(3);
    if (kind == 0) return b;
    if (kind == 1) {
        b.shape = BoundaryShape::ellipse;
        b.inverse_a = nearest<Inverse<One>>(1 / size);
        b.inverse_b = nearest<Inverse<One>>(1 / (size * random.uniform(0.5, 1)));
        return b;
    }
    b.shape = BoundaryShape::polygon;
    b.corner_count = 3;
    for (int k = 0; k < 3; ++k) {
        const Real80 angle = (k + random.uniform(-0.2, 0.2)) * 2 * 3.14159265358979L / 3;
        b.edges[k] = {nearest<Dir>(std::cos(angle)), nearest<Dir>(std::sin(angle)), nearest<Len>(size / 2)};
    }
    return b;
}

/// Curved mirrors of both signs with radii from 0.3 to 50, and the plane every fourth time.
inline MirrorCase random_mirror(Random& random, bool plane_only) {
    Real80 kappa = 0;
    if (!plane_only && random.below(4) != 0) {
        kappa = std::pow(10.0L, random.uniform(-1.7, 0.5));
        if (random.below(2) == 0) kappa = -kappa;
    }
    const Real80 widest = kappa == 0 ? 5 : std::min(5.0L, 0.6L / std::abs(kappa));
    const Real80 size = widest * random.uniform(0.4, 1);
    const ExactFrame frame = random_frame(random);
    const Exact3 vertex = random.direction() * random.uniform(0, 2);
    return {frame, fixed_mirror(vertex, frame, kappa, random_boundary(random, size)), size};
}

/// The point of the mirror's surface above (x, y) of its tangent plane, in the scene.
inline Exact3 surface_point(const MirrorCase& m, Real80 x, Real80 y) {
    const Real80 kappa = real(m.fixed.kappa), across = x * x + y * y;
    const Real80 z = kappa * across / (1 + std::sqrt(1 - kappa * kappa * across));
    return real(m.fixed.vertex) + m.frame.right * x + m.frame.v * y + m.frame.n * z;
}

inline Exact3 in_frame(const ExactFrame& f, const Exact3& p) { return {dot(f.right, p), dot(f.v, p), dot(f.n, p)}; }

/// How far inside the boundary a point is: negative outside.
inline Real80 depth_inside(const FixedBoundary& b, Real80 x, Real80 y) {
    if (b.shape == BoundaryShape::rectangle)
        return std::min(real(b.half_width) - std::abs(x), real(b.half_height) - std::abs(y));
    if (b.shape == BoundaryShape::ellipse) {
        const Real80 u = x * real(b.inverse_a), v = y * real(b.inverse_b);
        return 1 - u * u - v * v;
    }
    Real80 depth = 16;
    for (const FixedHalfPlane& edge : b.edges)
        depth = std::min(depth, real(edge.c) - x * real(edge.nx) - y * real(edge.ny));
    return depth;
}

struct ExactHit {
    bool hit = false;
    bool certain = true;  // no decision was close, and the incidence not flat
    Real80 t = 0;
    Exact3 p;  // in the mirror's frame
};

/// The nearest crossing beyond t = 0 of the ray o + t d (both in the mirror's frame).
inline ExactHit exact_hit(const FixedMirror& m, const Exact3& o, const Exact3& d) {
    const Real80 a = real(m.kappa), b = a * dot(o, d) - d.z, c = a * dot(o, o) - 2 * o.z;
    const Real80 disc = b * b - a * c;
    ExactHit best;
    best.certain = disc > kLeastCosine * kLeastCosine || disc < -kDecision;
    if (!best.certain || disc < 0) return best;
    const Real80 q = -(b + (b < 0 ? -1 : 1) * std::sqrt(disc));
    for (const Real80 t : {c / q, a == 0 ? -1 : q / a}) {
        const Exact3 p = o + d * t;
        const Real80 depth = std::min({depth_inside(m.boundary, p.x, p.y), t, 1 - a * p.z});
        best.certain = best.certain && std::abs(depth) > kDecision && (!best.hit || std::abs(t - best.t) > kDecision) &&
                       (depth < 0 || t < kLongestRay);
        if (depth > 0 && (!best.hit || t < best.t)) {
            best.hit = true;
            best.t = t;
            best.p = p;
        }
    }
    return best;
}

}  // namespace zerkalo::test
