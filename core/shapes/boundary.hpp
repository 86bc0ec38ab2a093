// The outline of a mirror: which points (x, y) of its tangent plane belong to it.
// A rectangle is half-open (low edge in, high edge out), so that two mirrors side by side tile without a seam; the other
// outlines are closed.
#pragma once

#include "core/numeric/number.hpp"
#include "core/shapes/mirror_data.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class S, class L>
ZERKALO_INLINE auto inside_rectangle(const S& b, L x, L y) -> decltype(x < y) {
    return (x >= L(-b.half_width)) & (x < L(b.half_width)) & (y >= L(-b.half_height)) & (y < L(b.half_height));
}

template <class S, class L>
ZERKALO_INLINE auto inside_ellipse(const S& b, L x, L y) -> decltype(x < y) {
    const L u = product<L>(x, b.inverse_a);
    const L v = product<L>(y, b.inverse_b);
    return u * u + v * v <= decltype(u * u)(1);
}

template <class S, class L>
ZERKALO_INLINE auto inside_polygon(const S& b, L x, L y) -> decltype(x < y) {
    decltype(x < y) inside = x == x;
    for (std::int32_t k = 0; k < b.corner_count; ++k) {
        const auto& edge = b.edges[k];
        inside = inside & (as<L>(x * edge.nx + y * edge.ny) <= L(edge.c));
    }
    return inside;
}

template <class S, class L>
ZERKALO_INLINE auto inside_boundary(const S& b, L x, L y) -> decltype(x < y) {
    if (b.shape == BoundaryShape::rectangle) return inside_rectangle(b, x, y);
    if (b.shape == BoundaryShape::polygon) return inside_polygon(b, x, y);
    return inside_ellipse(b, x, y);
}

}  // namespace zerkalo::inline ZERKALO_ISA
