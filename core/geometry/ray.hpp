// Rays, and the answer of a convex solid to a ray: the span in which the ray is inside.
#pragma once

#include "core/geometry/algebra.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Origin in scene units, unit direction (seed formula 2.3: P = o + t d).
template <class N>
struct Ray {
    Vec3<Length<N>> o;
    Vec3<Direction<N>> d;
};

/// The ray is inside for entry < t < exit; empty when entry >= exit. Infinite ends mean "for ever".
/// `face_in`, `face_out`: which face set the end, as the solid numbers its faces.
template <class N>
struct Span {
    Length<N> entry, exit;
    typename N::Index face_in, face_out;
};

template <class N>
ZERKALO_INLINE Span<N> empty_span() {
    const auto far = far_away<Length<N>>();
    return {far, -far, typename N::Index(0), typename N::Index(0)};
}

}  // namespace zerkalo::inline ZERKALO_ISA
