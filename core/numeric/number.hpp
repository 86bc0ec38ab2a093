// Number systems: which type holds a length, a direction, an area. Formulas are written once over a system N.
//
// In a float system all of them are the same lane type and the conversions below do nothing. In a fixed-point system
// they are formats (Q4.27, Q1.30, 64-bit products), a product changes the format, and `as<To>` is where it is rounded.
#pragma once

#include "core/numeric/lane.hpp"

#include <limits>

namespace zerkalo::inline ZERKALO_ISA {

/// Floats of one width. `Uniform` is the system of values that all lanes share.
template <class R>
struct FloatNumbers {
    using Length = R;
    using Direction = R;
    using Area = R;
    using Square = R;
    using Curvature = R;
    using Index = R;
    using Mask = zerkalo::Mask<R>;
    using Uniform = FloatNumbers<float>;
};

template <class N>
using Length = typename N::Length;
template <class N>
using Direction = typename N::Direction;
template <class N>
using Area = typename N::Area;
/// Of a direction's component: what a discriminant without a unit of length is.
template <class N>
using Square = typename N::Square;
template <class N>
using Curvature = typename N::Curvature;
template <class N>
using MaskOf = typename N::Mask;
template <class N>
using Uniform = typename N::Uniform;

/// The same value in another format; a float keeps its bits.
template <class To, class From>
ZERKALO_INLINE To as(From value) {
    return To(value);
}

/// a / b in the format To. Division by zero follows IEEE 754 in float.
template <class To, class A, class B>
ZERKALO_INLINE To quotient(A a, B b) {
    return To(a) / To(b);
}

/// a b in the format To, where the product has no format of its own.
template <class To, class A, class B>
ZERKALO_INLINE To product(A a, B b) {
    return To(a) * To(b);
}

/// Square root in the format To of a value >= 0.
template <class To, class A>
ZERKALO_INLINE To root(A a) {
    return sqrt(To(a));
}

/// Farther than anything: the bound of a span that never ends.
template <class L>
ZERKALO_INLINE L far_away() {
    if constexpr (requires { L::far_away(); }) {
        return L::far_away();
    } else {
        return L(std::numeric_limits<float>::infinity());
    }
}

/// Whether a crossing at t lies beyond t_min. `along`: the root that t was made of, which fixed point asks as well.
template <class T, class L>
ZERKALO_INLINE auto ahead_of(T t_min, L t, L) -> decltype(t > t_min) {
    return t > t_min;
}

}  // namespace zerkalo::inline ZERKALO_ISA
