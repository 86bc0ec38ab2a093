// The outline of a mirror: which points (x, y) of its tangent plane belong to it.
// Half-open (low edge in, high edge out), so that two mirrors side by side tile without a seam.
#pragma once

#include "core/numeric/number.hpp"
#include "core/shapes/mirror_data.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class L>
ZERKALO_INLINE auto inside_rectangle(const BoundaryData& b, L x, L y) -> decltype(x < y) {
    return (x >= L(-b.half_width)) & (x < L(b.half_width)) & (y >= L(-b.half_height)) & (y < L(b.half_height));
}

template <class L>
ZERKALO_INLINE auto inside_ellipse(const BoundaryData& b, L x, L y) -> decltype(x < y) {
    const L u = x * L(b.inverse_a);
    const L v = y * L(b.inverse_b);
    return u * u + v * v <= L(1);
}

template <class L>
ZERKALO_INLINE auto inside_polygon(const BoundaryData& b, L x, L y) -> decltype(x < y) {
    decltype(x < y) inside = x == x;
    for (std::int32_t k = 0; k < b.corner_count; ++k) {
        const HalfPlane& edge = b.edges[k];
        inside = inside & (x * L(edge.nx) + y * L(edge.ny) <= L(edge.c));
    }
    return inside;
}

template <class L>
ZERKALO_INLINE auto inside_boundary(const BoundaryData& b, L x, L y) -> decltype(x < y) {
    if (b.shape == BoundaryShape::rectangle) return inside_rectangle(b, x, y);
    if (b.shape == BoundaryShape::polygon) return inside_polygon(b, x, y);
    return inside_ellipse(b, x, y);
}

}  // namespace zerkalo::inline ZERKALO_ISA
