// Fixed point: numbers that are an integer times 2^-FracBits, the format a part of the type.
//
//     Q4.27  lengths      -16 .. 16, step 7.5e-9     Q1.30  directions    -2 .. 2, step 9.3e-10
//     Q9.54  areas       -512 .. 512                 Q3.60  squares of directions     -8 .. 8
//
// A product of 32-bit numbers has 64 bits and the sum of their fractions, exactly; `as<To>` rounds it to nearest, ties
// away from zero, so that every result changes sign with its operands. Sums stay in their format. Nothing wraps: what
// leaves a format's range stays at its end, as a float's infinity does, and quotients by zero are at that end.
// Formats do not mix, and floats do not convert: each change of format is written down.
// Range of a scene: coordinates within +-4 keep differences of points within +-8 and products within their formats;
// a distance of far_away() or more is no hit.
// Source: Heinly, Recker, Bensema, Porch, Gribble, "Integer Ray Tracing", JGT 14(4), 2009.
#pragma once

#include "core/numeric/fixed_lanes.hpp"
#include "core/numeric/number.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Rep: std::int32_t, std::int64_t or lanes of them. The raw integers never hold the most negative value.
template <class Rep, int FracBits>
struct Fixed {
    using Element = LaneElement<Rep>;
    static constexpr int kFraction = FracBits;
    static constexpr int kValueBits = std::numeric_limits<Element>::digits;
    static_assert(std::same_as<Element, std::int32_t> || std::same_as<Element, std::int64_t>);
    static_assert(FracBits >= 0 && FracBits < kValueBits);

    Rep raw;

    Fixed() = default;
    /// A whole number, the same in all lanes, held at the ends of the format.
    template <std::same_as<int> Whole>
    ZERKALO_INLINE constexpr explicit Fixed(Whole whole)
        : raw(in_all_lanes<Rep>(rescaled<Element, -FracBits>(whole))) {}
    /// A uniform number of the same format in all lanes.
    template <std::same_as<LaneElement<Rep>> U>
        requires(kLanesOf<Rep> > 1)
    ZERKALO_INLINE constexpr Fixed(Fixed<U, FracBits> uniform) : raw(in_all_lanes<Rep>(uniform.raw)) {}

    /// The number with this integer; the most negative integer stands for the one above it.
    static ZERKALO_INLINE constexpr Fixed from_raw(Rep raw) {
        Fixed result{};
        result.raw = each_lane([](Element r) { return r < -kLargest<Element> ? -kLargest<Element> : r; }, raw);
        return result;
    }
    static ZERKALO_INLINE constexpr Fixed far_away() { return from_raw(in_all_lanes<Rep>(kLargest<Element>)); }
};

template <class A, class B>
concept SameWidth = kLanesOf<A> == 1 || kLanesOf<B> == 1 || kLanesOf<A> == kLanesOf<B>;
template <class A, class B>
concept SameElement = std::same_as<LaneElement<A>, LaneElement<B>> && SameWidth<A, B>;
template <class A>
concept SingleWord = std::same_as<LaneElement<A>, std::int32_t>;

/// The format that a per-lane function on raw integers answers in.
template <int FracBits, class Rep>
ZERKALO_INLINE constexpr Fixed<Rep, FracBits> with_fraction(Rep raw) {
    Fixed<Rep, FracBits> result{};
    result.raw = raw;
    return result;
}

template <class A, class B, int F>
    requires SameElement<A, B>
ZERKALO_INLINE constexpr auto operator+(Fixed<A, F> a, Fixed<B, F> b) {
    using T = LaneElement<A>;
    return with_fraction<F>(each_lane([](T x, T y) { return saturated_sum<T>(x, y); }, a.raw, b.raw));
}
template <class A, int F>
[[gnu::const]] ZERKALO_INLINE constexpr Fixed<A, F> operator-(Fixed<A, F> a) {
    using T = LaneElement<A>;
    return with_fraction<F>(each_lane([](T x) { return static_cast<T>(-x); }, a.raw));
}
template <class A, class B, int F>
    requires SameElement<A, B>
ZERKALO_INLINE constexpr auto operator-(Fixed<A, F> a, Fixed<B, F> b) { return a + -b; }

/// Exact: twice the bits, and the fractions add up.
template <class A, int FA, class B, int FB>
    requires SingleWord<A> && SingleWord<B> && SameWidth<A, B>
ZERKALO_INLINE constexpr auto operator*(Fixed<A, FA> a, Fixed<B, FB> b) {
    static_assert(FA + FB < 62, "the product of two whole numbers must fit");
    return with_fraction<FA + FB>(
        each_lane([](std::int32_t x, std::int32_t y) { return std::int64_t{x} * y; }, a.raw, b.raw));
}

// Free of side effects, and said to be: at width 1 their answers are joined by & and |, which clang asks about.
template <class A, class B, int F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator<(Fixed<A, F> a, Fixed<B, F> b) {
    using T = LaneElement<A>;
    return each_lane([](T x, T y) { return x < y; }, a.raw, b.raw);
}
template <class A, class B, int F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator>(Fixed<A, F> a, Fixed<B, F> b) { return b < a; }
template <class A, class B, int F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator<=(Fixed<A, F> a, Fixed<B, F> b) { return !(b < a); }
template <class A, class B, int F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator>=(Fixed<A, F> a, Fixed<B, F> b) { return !(a < b); }
template <class A, class B, int F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator==(Fixed<A, F> a, Fixed<B, F> b) {
    using T = LaneElement<A>;
    return each_lane([](T x, T y) { return x == y; }, a.raw, b.raw);
}
template <class A, class B, int F>
    requires SameElement<A, B>
[[gnu::const]] ZERKALO_INLINE constexpr auto operator!=(Fixed<A, F> a, Fixed<B, F> b) { return !(a == b); }

template <class M, class A, class B, int F>
    requires SameElement<A, B> && std::same_as<LaneElement<M>, bool>
ZERKALO_INLINE constexpr auto select(M mask, Fixed<A, F> a, Fixed<B, F> b) {
    using T = LaneElement<A>;
    return with_fraction<F>(each_lane([](bool m, T x, T y) { return m ? x : y; }, mask, a.raw, b.raw));
}
template <class A, class B, int F>
ZERKALO_INLINE constexpr auto min(Fixed<A, F> a, Fixed<B, F> b) { return select(a < b, a, b); }
template <class A, class B, int F>
ZERKALO_INLINE constexpr auto max(Fixed<A, F> a, Fixed<B, F> b) { return select(a > b, a, b); }

/// a, negated where `sign` is negative.
template <class A, int F>
ZERKALO_INLINE constexpr Fixed<A, F> flip_sign(Fixed<A, F> a, Fixed<A, F> sign) {
    return select(sign < Fixed<A, F>(0), -a, a);
}

/// Rounded to nearest, ties away from zero, and held at the ends of the format.
template <class To, class A, int F>
ZERKALO_INLINE constexpr To as(Fixed<A, F> value) {
    if constexpr (std::same_as<To, Fixed<A, F>>) {
        return value;
    } else {
        using T = typename To::Element;
        constexpr int kShift = F - To::kFraction;
        return with_fraction<To::kFraction>(
            each_lane([](std::int64_t x) { return rescaled<T, kShift>(x); }, value.raw));
    }
}

/// The exact product of a 32-bit and a 64-bit number, rounded once.
template <class To, class A, int FA, class B, int FB>
    requires SingleWord<A>
ZERKALO_INLINE constexpr To product(Fixed<A, FA> a, Fixed<B, FB> b) {
    using T = typename To::Element;
    constexpr int kShift = FA + FB - To::kFraction;
    return with_fraction<To::kFraction>(each_lane(
        [](std::int32_t x, std::int64_t y) { return rescaled_product<T, kShift>(x, y); }, a.raw, b.raw));
}

/// a / b rounded to nearest, ties away from zero. Division by zero is the end of the format on the side of a; 0 / 0 is
/// the upper end, so that a ray in the plane of a slab's upper face is inside and in that of the lower face outside.
template <class To, class A, int FA, class B, int FB>
ZERKALO_INLINE constexpr To quotient(Fixed<A, FA> a, Fixed<B, FB> b) {
    using T = typename To::Element;
    constexpr int kShift = To::kFraction - FA + FB;
    static_assert(kShift >= 0 && Fixed<A, FA>::kValueBits + kShift <= 63, "the shifted dividend must fit in 64 bits");
    return with_fraction<To::kFraction>(each_lane(
        [](std::int64_t x, std::int64_t y) { return rounded_quotient<T, kShift>(x, y); }, a.raw, b.raw));
}

/// Square root rounded to nearest (a root of an integer is never half-way between two).
template <class To, class A, int F>
ZERKALO_INLINE constexpr To root(Fixed<A, F> a) {
    using T = typename To::Element;
    static_assert(F == 2 * To::kFraction, "a root has half the fraction bits");
    return with_fraction<To::kFraction>(
        each_lane([](std::int64_t x) { return saturated<T>(nearest_root(x), false); }, a.raw));
}

/// A root of an equation that was divided out as `along`, at distance t: beyond t_min, and not at the end of the range.
template <class A, class B, int F>
ZERKALO_INLINE constexpr auto ahead_of(Fixed<B, F> t_min, Fixed<A, F> t, Fixed<A, F> along) {
    using T = LaneElement<A>;
    constexpr T kFar = kLargest<T>;
    return each_lane([](T least, T x, T root) { return x > least && x < kFar && root < kFar && root > -kFar; },
                     t_min.raw, t.raw, along.raw);
}

/// The fixed-point system of one width, as FloatNumbers is that of float.
template <int W>
struct FixedNumbers {
    using Length = Fixed<Ints<std::int32_t, W>, 27>;
    using Direction = Fixed<Ints<std::int32_t, W>, 30>;
    using Area = Fixed<Ints<std::int64_t, W>, 54>;
    using Square = Fixed<Ints<std::int64_t, W>, 60>;
    using Curvature = Fixed<Ints<std::int32_t, W>, 27>;
    using Index = Fixed<Ints<std::int32_t, W>, 0>;
    using Mask = Ints<bool, W>;
    using Uniform = FixedNumbers<1>;
};

}  // namespace zerkalo::inline ZERKALO_ISA
