// What the kernels read of a mirror's shape: plain uniform data, derived once by prepare().
#pragma once

#include "core/geometry/vec.hpp"
#include "core/shapes/boundary_shape.hpp"

namespace zerkalo {

/// All (x, y) with x * nx + y * ny <= c.
struct HalfPlane {
    float nx, ny, c;
};

struct BoundaryData {
    BoundaryShape shape;
    std::int32_t corner_count;
    float half_width, half_height;          // rectangle
    float inverse_a, inverse_b;             // ellipse and disc: 1 / semi-axes
    HalfPlane edges[kMaxCorners];           // polygon
};

/// Frame: x along right, y along v, z along n, origin at the vertex. kappa = 1 / R, 0 for a plane.
struct MirrorShape {
    Vec3<float> vertex, right, v, n;
    float kappa;
    BoundaryData boundary;
};

}  // namespace zerkalo
