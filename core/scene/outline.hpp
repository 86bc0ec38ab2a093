// Measures of a mirror's outline that both validation and set-up need.
#pragma once

#include "core/geometry/frame.hpp"
#include "core/scene/scene.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Distance from the vertex to the outline's farthest point, scene units.
inline double farthest_point(const Boundary& b) {
    if (b.shape == BoundaryShape::disc) return b.radius;
    if (b.shape == BoundaryShape::ellipse) return (b.width > b.height ? b.width : b.height) / 2;
    if (b.shape == BoundaryShape::rectangle) return length({b.width / 2, b.height / 2, 0});
    double farthest = 0;
    for (std::int32_t k = 0; k < b.corner_count; ++k) {
        const double r = length({b.corners[k].x, b.corners[k].y, 0});
        if (r > farthest) farthest = r;
    }
    return farthest;
}

}  // namespace zerkalo::inline ZERKALO_ISA
