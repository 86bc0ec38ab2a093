// Number systems: which type holds a length, a direction, an area. Formulas are written once over a system N.
//
// In a system of floats all of them are the same lane type and the conversions below do nothing. In a fixed-point system
// they are formats (Q4.27, Q1.30, 64-bit products), a product changes the format, and `as<To>` is where it is rounded.
// The kernels' templates call their system R: lanes of float, double, or a FixedNumbers<W>.
#pragma once

#include "core/numeric/formats.hpp"
#include "core/numeric/lane.hpp"

#include <concepts>
#include <limits>
#include <type_traits>

namespace zerkalo::inline ZERKALO_ISA {

/// What all lanes of R share: a double for double, else a float.
template <class R>
using UniformReal = std::conditional_t<std::same_as<R, double>, double, float>;

/// Lanes of float, or double. `Uniform` is the system of values that all lanes share, `Formats` that of the plan's
/// constants.
template <class R>
struct FloatNumbers {
    using Formats = FloatingFormats<UniformReal<R>>;
    using Length = R;
    using Direction = R;
    using Area = R;
    using Square = R;
    using Volume = R;
    using Moment = R;
    using Curvature = R;
    using Inverse = R;
    using Ratio = R;
    using Index = R;
    using Weight = R;
    using Radiance = R;
    using LightSum = R;
    using Exponent = R;
    using Share = R;
    using Phase = R;
    using Fraction = R;
    using Pixels = R;
    using View = R;
    using FarStep = R;
    using Mask = zerkalo::Mask<R>;
    using Uniform = FloatNumbers<UniformReal<R>>;
};

template <class R>
struct LaneTraits<FloatNumbers<R>> : LaneTraits<R> {};

/// The system that a type stands for: lanes of float are a system in which every quantity is such a lane, so is double,
/// a number of a fixed-point format belongs to the system of its width, and a system is its own.
template <class N>
struct SystemOf { using type = N; };
template <std::floating_point T>
struct SystemOf<T> { using type = FloatNumbers<T>; };
template <int W>
struct SystemOf<Lanes<W>> { using type = FloatNumbers<Lanes<W>>; };
template <class N>
using System = typename SystemOf<N>::type;

/// What names a system in the templates of the kernels: lanes of float or double themselves, or a fixed-point system.
template <class T>
struct NumbersOf { using type = System<T>; };
template <std::floating_point T>
struct NumbersOf<T> { using type = T; };
template <int W>
struct NumbersOf<Lanes<W>> { using type = Lanes<W>; };
template <class T>
using Numbers = typename NumbersOf<T>::type;

/// A mask in memory: smaller than in registers where a form for that exists.
template <class R>
struct StoredMaskOf { using type = Mask<R>; };
template <class R>
using StoredMask = typename StoredMaskOf<R>::type;

/// The system in which lengths are compared before they are rounded: N itself, or where that pays one of its own.
template <class N>
struct UnroundedOf { using type = N; };

template <class N>
using Formats = typename System<N>::Formats;
template <class N>
using Length = typename System<N>::Length;
template <class N>
using Direction = typename System<N>::Direction;
template <class N>
using Area = typename System<N>::Area;
/// Of a direction's component: what a discriminant without a unit of length is.
template <class N>
using Square = typename System<N>::Square;
template <class N>
using Volume = typename System<N>::Volume;
/// A length times a direction.
template <class N>
using Moment = typename System<N>::Moment;
template <class N>
using Curvature = typename System<N>::Curvature;
/// One over a length.
template <class N>
using Inverse = typename System<N>::Inverse;
/// Of refractive indices, and what they make of a cosine.
template <class N>
using Ratio = typename System<N>::Ratio;
/// Of solids, mirrors and faces.
template <class N>
using Index = typename System<N>::Index;
/// Shares of light, cosines among them: 0 to 1.
template <class N>
using Weight = typename System<N>::Weight;
template <class N>
using Radiance = typename System<N>::Radiance;
/// Weight times radiance, and sums of it.
template <class N>
using LightSum = typename System<N>::LightSum;
/// Of a cosine power.
template <class N>
using Exponent = typename System<N>::Exponent;
/// 1 / (n + 1) of an exponent n.
template <class N>
using Share = typename System<N>::Share;
/// Part of a turn.
template <class N>
using Phase = typename System<N>::Phase;
/// Part of a lobe's energy: 0 to 1.
template <class N>
using Fraction = typename System<N>::Fraction;
template <class N>
using Pixels = typename System<N>::Pixels;
template <class N>
using View = typename System<N>::View;
template <class N>
using FarStep = typename System<N>::FarStep;
template <class N>
using MaskOf = typename System<N>::Mask;
template <class N>
using Uniform = typename System<N>::Uniform;

/// The same value in another format; a float keeps its bits.
template <class To, class From>
ZERKALO_INLINE To as(From value) {
    return To(value);
}

/// as<To> of a value that is known to fit: in fixed point it is rounded alone, and not held at the ends of the format.
template <class To, class From>
ZERKALO_INLINE To rounded(From value) {
    return as<To>(value);
}

/// a + b and a - b that are known to fit: in fixed point they are not held at the ends of the format.
template <class A, class B>
ZERKALO_INLINE auto fitting_sum(A a, B b) {
    return a + b;
}
template <class A, class B>
ZERKALO_INLINE auto fitting_difference(A a, B b) {
    return a - b;
}

/// a / b in the format To. Division by zero follows IEEE 754 in float.
template <class To, class A, class B>
ZERKALO_INLINE To quotient(A a, B b) {
    return To(a) / To(b);
}

/// Two quotients by one divisor.
template <class To>
struct QuotientPair {
    To first, second;
};
template <class To, class A, class B>
ZERKALO_INLINE QuotientPair<To> quotients(A first, A second, B divisor) {
    return {quotient<To>(first, divisor), quotient<To>(second, divisor)};
}

/// a b in the format To, where the product has no format of its own.
template <class To, class A, class B>
ZERKALO_INLINE To product(A a, B b) {
    return To(a) * To(b);
}

/// The same where it is known to fit.
template <class To, class A, class B>
ZERKALO_INLINE To rounded_product(A a, B b) {
    return product<To>(a, b);
}

/// product() of numbers that are not negative.
template <class To, class A, class B>
ZERKALO_INLINE To share_product(A a, B b) {
    return product<To>(a, b);
}

/// Square root in the format To of a value >= 0.
template <class To, class A>
ZERKALO_INLINE To root(A a) {
    return sqrt(To(a));
}

/// a / 2; in fixed point with one fraction bit more, so exactly.
template <class R>
ZERKALO_INLINE R half_of(R a) {
    return a * R(0.5f);
}

/// The same answer in all lanes.
template <class N>
ZERKALO_INLINE MaskOf<N> mask_of(bool answer) {
    return MaskOf<N>(answer);
}

/// Number k of a solid, a mirror or a face.
template <class N>
ZERKALO_INLINE Index<N> index_of(int k) {
    if constexpr (Formats<N>::kFixed) {
        return Index<N>(k);
    } else {
        return Index<N>(float(k));
    }
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
