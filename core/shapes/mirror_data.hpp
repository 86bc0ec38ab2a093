// What the kernels read of a mirror's shape: plain uniform data, derived once by prepare(). F: the formats of its numbers.
#pragma once

#include "core/geometry/vec.hpp"
#include "core/numeric/formats.hpp"
#include "core/shapes/boundary_shape.hpp"

namespace zerkalo {

/// All (x, y) with x * nx + y * ny <= c.
template <class F>
struct HalfPlaneOf {
    typename F::Edge nx, ny;
    typename F::Length c;
};
using HalfPlane = HalfPlaneOf<FloatFormats>;

template <class F>
struct BoundaryDataOf {
    BoundaryShape shape;
    std::int32_t corner_count;
    typename F::Length half_width, half_height;    // rectangle
    typename F::Inverse inverse_a, inverse_b;      // ellipse and disc: 1 / semi-axes
    HalfPlaneOf<F> edges[kMaxCorners];             // polygon
};
using BoundaryData = BoundaryDataOf<FloatFormats>;

/// Frame: x along right, y along v, z along n, origin at the vertex. kappa = 1 / R, 0 for a plane.
template <class F>
struct MirrorShapeOf {
    Vec3<typename F::Length> vertex;
    Vec3<typename F::Direction> right, v, n;
    typename F::Curvature kappa;
    BoundaryDataOf<F> boundary;
};
using MirrorShape = MirrorShapeOf<FloatFormats>;

}  // namespace zerkalo
