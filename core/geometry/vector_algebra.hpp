// Dot and cross products of fixed-point numbers in vector registers.
#pragma once

#include "core/geometry/algebra.hpp"
#include "core/numeric/fixed_vectors.hpp"

#if defined(ZERKALO_INT_VECTORS)
namespace zerkalo::inline ZERKALO_ISA {

// Of the three products of a sum two fit into 64 bits without being held; all three do where one vector is a direction,
// whose components are at most 1 but for rounding, or a difference of two, times itself.
template <class A, Format FA, class B, Format FB>
    requires SingleWord<A> && SingleWord<B> && InVectors<A, B>
ZERKALO_INLINE auto dot(Vec3<Fixed<A, FA>> a, Vec3<Fixed<B, FB>> b) {
    constexpr Format kDirection = FixedFormats::Direction::kFormat;
    const Longs two = fitting_sum((a.x * b.x).raw.v, (a.y * b.y).raw.v);
    const Longs third = (a.z * b.z).raw.v;
    if constexpr (FA == kDirection || FB == kDirection) {
        return fixed_of<FA + FB>(fitting_sum(two, third));
    } else {
        return fixed_of<FA + FB>(held_sum(two, third));
    }
}
template <class A, Format FA, class B, Format FB>
    requires SingleWord<A> && SingleWord<B> && InVectors<A, B>
ZERKALO_INLINE auto cross(Vec3<Fixed<A, FA>> a, Vec3<Fixed<B, FB>> b) {
    const auto x = fixed_of<FA + FB>(fitting_difference((a.y * b.z).raw.v, (a.z * b.y).raw.v));
    const auto y = fixed_of<FA + FB>(fitting_difference((a.z * b.x).raw.v, (a.x * b.z).raw.v));
    const auto z = fixed_of<FA + FB>(fitting_difference((a.x * b.y).raw.v, (a.y * b.x).raw.v));
    return Vec3<std::remove_const_t<decltype(x)>>{x, y, z};
}

}  // namespace zerkalo::inline ZERKALO_ISA
#endif
