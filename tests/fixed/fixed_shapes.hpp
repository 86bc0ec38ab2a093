// What the shape templates read, in fixed formats: a sphere, a slab, and a mirror with its boundary.
#pragma once

#include "tests/fixed/fixed_values.hpp"

namespace zerkalo::test {

struct FixedSphere {
    Vec3<Len> centre;
    Area<One> radius2;
};

struct FixedSlab {
    Vec3<Dir> n;
    Len lo, hi;
    One::Index index;
};

struct FixedHalfPlane {
    Dir nx, ny;
    Len c;
};

struct FixedBoundary {
    BoundaryShape shape;
    std::int32_t corner_count;
    Len half_width, half_height;
    Inverse<One> inverse_a, inverse_b;
    FixedHalfPlane edges[3];
};

struct FixedMirror {
    Vec3<Len> vertex;
    Vec3<Dir> right, v, n;
    Curvature<One> kappa;
    FixedBoundary boundary;
};

inline FixedSphere fixed_sphere(const Exact3& centre, Real80 radius) {
    return {nearest<Len>(centre), nearest<Area<One>>(radius * radius)};
}

/// A right-handed frame of exact unit vectors: right, v, n.
struct ExactFrame {
    Exact3 right, v, n;
};
inline ExactFrame random_frame(Random& random) {
    const Exact3 n = random.direction();
    const Exact3 right = unit(cross(random.direction(), n));
    return {right, cross(n, right), n};
}

inline FixedMirror fixed_mirror(const Exact3& vertex, const ExactFrame& frame, Real80 kappa,
                                const FixedBoundary& boundary) {
    return {nearest<Len>(vertex), nearest<Dir>(frame.right), nearest<Dir>(frame.v), nearest<Dir>(frame.n),
            nearest<Curvature<One>>(kappa), boundary};
}

inline FixedBoundary fixed_rectangle(Real80 half_width, Real80 half_height) {
    FixedBoundary b{};
    b.shape = BoundaryShape::rectangle;
    b.half_width = nearest<Len>(half_width);
    b.half_height = nearest<Len>(half_height);
    return b;
}

inline FixedMirror flipped(const FixedMirror& m) {
    return {flipped(m.vertex), flipped(m.right), flipped(m.v), flipped(m.n), m.kappa, m.boundary};
}

}  // namespace zerkalo::test
