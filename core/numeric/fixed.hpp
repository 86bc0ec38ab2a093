// Fixed point: numbers that are an integer times 2^-F, the format, F and the quantity, a part of the type.
//
//     Q4.27  lengths      -16 .. 16, step 7.5e-9     Q1.30  directions    -2 .. 2, step 9.3e-10
//     Q9.54  areas       -512 .. 512                 Q3.60  squares of directions     -8 .. 8
// and the others of FixedFormats and FixedNumbers: colours, exponents, phases.
//
// A product of 32-bit numbers has 64 bits and the sum of their fractions, exactly; `as<To>` rounds it to nearest, ties
// away from zero, so that every result changes sign with its operands. Sums stay in their format. Nothing wraps: what
// leaves a format's range stays at its end, as a float's infinity does, and quotients by zero are at that end.
// Formats do not mix, and floats do not convert: each change of format is written down. Nor do two quantities mix that
// have the same bits, a length and a ratio. A product has no name (with light it is light) until `as<To>` says what
// it is; between formats of the same bits that is all that `as` does. Sums, the smaller of two, -x, |x|, x / 2 and
// multiples stay what they are; roots, quotients and rounded products are what was asked for.
// Range of a scene: coordinates within +-8 and ways within 15 (render/fit.hpp) keep differences of points and products
// within their formats; a distance of far_away() or more is no hit.
// Source: Heinly, Recker, Bensema, Porch, Gribble, "Integer Ray Tracing", JGT 14(4), 2009.
#pragma once

#include "core/numeric/integer_root.hpp"
#include "core/numeric/number.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class A, class B>
concept SameWidth = kLanesOf<A> == 1 || kLanesOf<B> == 1 || kLanesOf<A> == kLanesOf<B>;
template <class A, class B>
concept SameElement = std::same_as<LaneElement<A>, LaneElement<B>> && SameWidth<A, B>;
template <class A>
concept SingleWord = std::same_as<LaneElement<A>, std::int32_t>;

/// The format that a per-lane function on raw integers answers in.
template <Format F, class Rep>
ZERKALO_INLINE constexpr Fixed<Rep, F> with_format(Rep raw) {
    Fixed<Rep, F> result{};
    result.raw = raw;
    return result;
}

template <class A, class B, Format F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator+(Fixed<A, F> a, Fixed<B, F> b) {
    using T = LaneElement<A>;
    return with_format<F>(each_lane([](T x, T y) { return saturated_sum<T>(x, y); }, a.raw, b.raw));
}
template <class A, Format F>
[[gnu::const]] ZERKALO_INLINE constexpr Fixed<A, F> operator-(Fixed<A, F> a) {
    using T = LaneElement<A>;
    return with_format<F>(each_lane([](T x) { return checked_product<T>(x, -1, "-x"); }, a.raw));
}
template <class A, class B, Format F>
    requires SameElement<A, B>
ZERKALO_INLINE constexpr auto operator-(Fixed<A, F> a, Fixed<B, F> b) { return a + -b; }

/// Exact: twice the bits, and the fractions add up.
template <class A, Format FA, class B, Format FB>
    requires SingleWord<A> && SingleWord<B> && SameWidth<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator*(Fixed<A, FA> a, Fixed<B, FB> b) {
    static_assert((FA + FB).fraction < 62, "the product of two whole numbers must fit");
    return with_format<FA + FB>(
        each_lane([](std::int32_t x, std::int32_t y) { return std::int64_t{x} * y; }, a.raw, b.raw));
}

// Free of side effects, and said to be, as sums and products are: at width 1 their answers are joined by & and |, which
// clang asks about.
template <class A, class B, Format F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator<(Fixed<A, F> a, Fixed<B, F> b) {
    using T = LaneElement<A>;
    return each_lane([](T x, T y) { return x < y; }, a.raw, b.raw);
}
template <class A, class B, Format F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator>(Fixed<A, F> a, Fixed<B, F> b) { return b < a; }
template <class A, class B, Format F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator<=(Fixed<A, F> a, Fixed<B, F> b) { return !(b < a); }
template <class A, class B, Format F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator>=(Fixed<A, F> a, Fixed<B, F> b) { return !(a < b); }
template <class A, class B, Format F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator==(Fixed<A, F> a, Fixed<B, F> b) {
    using T = LaneElement<A>;
    return each_lane([](T x, T y) { return x == y; }, a.raw, b.raw);
}
template <class A, class B, Format F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator!=(Fixed<A, F> a, Fixed<B, F> b) { return !(a == b); }

// At width 1 masks that & joins are ints.
template <class M, class A, class B, Format F>
    requires SameElement<A, B> && (std::same_as<LaneElement<M>, bool> || std::same_as<M, int>)
ZERKALO_INLINE constexpr auto select(M mask, Fixed<A, F> a, Fixed<B, F> b) {
    using T = LaneElement<A>;
    return with_format<F>(each_lane([](bool m, T x, T y) { return m ? x : y; }, mask, a.raw, b.raw));
}
template <class A, class B, Format F>
ZERKALO_INLINE constexpr auto min(Fixed<A, F> a, Fixed<B, F> b) { return select(a < b, a, b); }
template <class A, class B, Format F>
ZERKALO_INLINE constexpr auto max(Fixed<A, F> a, Fixed<B, F> b) { return select(a > b, a, b); }

template <class A, Format F>
ZERKALO_INLINE constexpr Fixed<A, F> absolute(Fixed<A, F> a) { return select(a < Fixed<A, F>(0), -a, a); }

/// a, negated where `sign` is negative.
template <class A, Format F>
ZERKALO_INLINE constexpr Fixed<A, F> flip_sign(Fixed<A, F> a, Fixed<A, F> sign) {
    return select(sign < Fixed<A, F>(0), -a, a);
}

/// Rounded to nearest, ties away from zero, and held at the ends of the format.
template <class To, class A, Format F>
ZERKALO_INLINE constexpr To as(Fixed<A, F> value) {
    if constexpr (std::same_as<typename To::Representation, A> && To::kFraction == F.fraction) {
        return with_format<To::kFormat>(value.raw);
    } else {
        using T = typename To::Element;
        constexpr int kShift = F.fraction - To::kFraction;
        return with_format<To::kFormat>(
            each_lane([](std::int64_t x) { return rescaled<T, kShift>(x); }, value.raw));
    }
}

/// The same of a number that fits: a checked build watches that it does. Of several lanes some do not count and may hold
/// anything: those are held.
template <class To, class A, Format F>
ZERKALO_INLINE constexpr To rounded(Fixed<A, F> value) {
    if constexpr (kLanesOf<A> > 1) {
        return as<To>(value);
    } else {
        using T = typename To::Element;
        constexpr int kShift = F.fraction - To::kFraction;
        static_assert(kShift > 0);
        return To::from_raw(rounded_shift<T, kShift>(value.raw));
    }
}
template <class A, class B, Format F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto fitting_sum(Fixed<A, F> a, Fixed<B, F> b) {
    if constexpr (kLanesOf<A> > 1 || kLanesOf<B> > 1) {
        return a + b;
    } else {
        return with_format<F>(checked_sum<LaneElement<A>>(a.raw, b.raw, "a sum"));
    }
}
template <class A, class B, Format F>
    requires SameElement<A, B>
ZERKALO_INLINE constexpr auto fitting_difference(Fixed<A, F> a, Fixed<B, F> b) { return fitting_sum(a, -b); }

/// The exact product, rounded once.
template <class To, class A, Format FA, class B, Format FB>
ZERKALO_INLINE constexpr To product(Fixed<A, FA> a, Fixed<B, FB> b) {
    using T [[maybe_unused]] = typename To::Element;
    if constexpr (SingleWord<A> && SingleWord<B>) {
        return as<To>(a * b);
    } else if constexpr (SingleWord<A>) {
        constexpr int kShift = (FA + FB).fraction - To::kFraction;
        return with_format<To::kFormat>(each_lane(
            [](std::int32_t x, std::int64_t y) { return rescaled_product<T, kShift>(x, y); }, a.raw, b.raw));
    } else if constexpr (SingleWord<B>) {
        return product<To>(b, a);
    } else {
        constexpr int kShift = (FA + FB).fraction - To::kFraction;
        return with_format<To::kFormat>(each_lane(
            [](std::int64_t x, std::int64_t y) { return rescaled_wide_product<T, kShift>(x, y); }, a.raw, b.raw));
    }
}

/// The same of 64 bits times a word, known to fit.
template <class To, class A, Format FA, class B, Format FB>
ZERKALO_INLINE constexpr To rounded_product(Fixed<A, FA> a, Fixed<B, FB> b) {
    if constexpr (kLanesOf<A> == 1 && kLanesOf<B> == 1) {
        return with_format<To::kFormat>(rounded_product<(FA + FB).fraction - To::kFraction>(b.raw, a.raw));
    } else {
        return product<To>(a, b);
    }
}

/// a / b rounded to nearest, ties away from zero. Division by zero is the end of the format on the side of a; 0 / 0 is
/// the upper end, so that a ray in the plane of a slab's upper face is inside and in that of the lower face outside.
/// Where the shifted dividend may exceed 64 bits, off by at most one step and 2^-30 of the quotient.
template <class To, class A, Format FA, class B, Format FB>
ZERKALO_INLINE constexpr To quotient(Fixed<A, FA> a, Fixed<B, FB> b) {
    using T = typename To::Element;
    constexpr int kShift = To::kFraction - FA.fraction + FB.fraction;
    static_assert(kShift >= 0);
    constexpr bool kFits = Fixed<A, FA>::kValueBits + kShift <= 63;
    return with_format<To::kFormat>(each_lane(
        [](std::int64_t x, std::int64_t y) {
            if constexpr (kFits) return rounded_quotient<T, kShift>(x, y);
            else return long_quotient<T, kShift>(x, y);
        },
        a.raw, b.raw));
}

/// 1 / a in the format To for a >= 0, relative error below 2^-30; the end of the format for 0.
template <class To, class A, Format F>
ZERKALO_INLINE constexpr To reciprocal(Fixed<A, F> a) {
    using T = typename To::Element;
    return with_format<To::kFormat>(
        each_lane([](std::int64_t x) { return integer_reciprocal<T, To::kFraction + F.fraction>(x); }, a.raw));
}

/// Square root rounded to nearest (a root of an integer is never half-way between two).
template <class To, class A, Format F>
ZERKALO_INLINE constexpr To root(Fixed<A, F> a) {
    using T = typename To::Element;
    static_assert(F.fraction == 2 * To::kFraction, "a root has half the fraction bits");
    return with_format<To::kFormat>(
        each_lane([](std::int64_t x) { return saturated<T>(nearest_root(x), false); }, a.raw));
}

/// A root of an equation that was divided out as `along`, at distance t: beyond t_min, and not at the end of the range.
template <class A, class B, Format F>
ZERKALO_INLINE constexpr auto ahead_of(Fixed<B, F> t_min, Fixed<A, F> t, Fixed<A, F> along) {
    using T = LaneElement<A>;
    constexpr T kFar = kLargest<T>;
    return each_lane([](T least, T x, T root) { return x > least && x < kFar && root < kFar && root > -kFar; },
                     t_min.raw, t.raw, along.raw);
}

/// a n for whole n >= 0 where the product is known to fit.
template <class A, Format F>
ZERKALO_INLINE constexpr Fixed<A, F> times(Fixed<A, F> a, std::int32_t n) {
    using T = LaneElement<A>;
    return with_format<F>(each_lane([n](T x) { return static_cast<T>(x * n); }, a.raw));
}

/// The same number with one bit less before the point: half of it, exactly.
template <class A, Format F>
ZERKALO_INLINE constexpr auto half_of(Fixed<A, F> a) {
    return with_format<Format{F.fraction + 1, F.quantity}>(a.raw);
}

/// The fixed-point system of one width, as FloatNumbers is that of float. I: how the lanes are held.
template <int W, template <class, int> class I = Ints>
struct FixedNumbers {
    using Formats = FixedFormats;
    template <class F>
    using Lanes = Fixed<I<typename F::Element, W>, F::kFormat>;

    using Length = Lanes<FixedFormats::Length>;
    using Direction = Lanes<FixedFormats::Direction>;
    using Area = Lanes<FixedFormats::Area>;
    using Square = Fixed<I<std::int64_t, W>, 60>;
    using Volume = Fixed<I<std::int64_t, W>, 48>;
    using Moment = Fixed<I<std::int64_t, W>, 57>;
    using Curvature = Lanes<FixedFormats::Curvature>;
    using Inverse = Lanes<FixedFormats::Inverse>;
    using Ratio = Lanes<FixedFormats::Ratio>;
    using Index = Lanes<FixedFormats::Index>;
    using Weight = Lanes<FixedFormats::Weight>;
    using Radiance = Lanes<FixedFormats::Radiance>;
    using LightSum = decltype(Weight{} * Radiance{});  // and sums of them: exact
    using Exponent = Lanes<FixedFormats::Exponent>;
    using Share = Lanes<FixedFormats::Share>;
    using Phase = I<std::uint32_t, W>;               // a turn is 2^32 and wraps
    using Fraction = Fixed<I<std::int64_t, W>, Format{60, Quantity::fraction}>;  // of a lobe's energy
    using Pixels = Fixed<I<std::int32_t, W>, 14>;
    using View = Lanes<FixedFormats::View>;
    using FarStep = Lanes<FixedFormats::FarStep>;
    using Mask = I<bool, W>;
    using Uniform = FixedNumbers<1>;
};

/// kWidth<R> values of an array, as lanes: bits, or phases.
template <class R>
    requires(Formats<R>::kFixed)
ZERKALO_INLINE Bits<R> load_bits(const std::uint32_t* source) {
    Bits<R> result{};
    for (int k = 0; k < kWidth<R>; ++k) set_lane(result, k, source[k]);
    return result;
}

template <int W, template <class, int> class I>
struct LaneTraits<FixedNumbers<W, I>> {
    using Mask = I<bool, W>;
    using Bits = I<std::uint32_t, W>;
    static constexpr int kWidth = W;
};
/// The system whose lanes are held like this.
template <class Rep>
struct FixedNumbersOf { using type = FixedNumbers<kLanesOf<Rep>>; };
template <class Rep, Format F>
struct LaneTraits<Fixed<Rep, F>> : LaneTraits<typename FixedNumbersOf<Rep>::type> {};
template <class Rep, Format F>
struct SystemOf<Fixed<Rep, F>> { using type = typename FixedNumbersOf<Rep>::type; };

}  // namespace zerkalo::inline ZERKALO_ISA
