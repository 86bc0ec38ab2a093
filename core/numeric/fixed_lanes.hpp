// Lanes of integers for fixed point: W values in an array, and loops over them that the compiler turns into vectors.
//
// One lane is a plain integer, and every operation is written for one lane: `each_lane` repeats it over the others. So
// all widths give the same bits by construction, on any target, also on one without a vector unit or a float unit.
#pragma once

#include "core/numeric/isa.hpp"

#include <concepts>
#include <cstdint>
#include <limits>

namespace zerkalo::inline ZERKALO_ISA {

/// W integers, or W booleans. A width of 1 is the integer itself, never this.
template <class T, int W>
struct IntLanes {
    static_assert(W > 1);
    T v[W];
};

template <class X>
struct IntLaneTraits {
    using Element = X;
    static constexpr int kWidth = 1;
};
template <class T, int W>
struct IntLaneTraits<IntLanes<T, W>> {
    using Element = T;
    static constexpr int kWidth = W;
};
template <class X>
using LaneElement = typename IntLaneTraits<X>::Element;
template <class X>
constexpr int kLanesOf = IntLaneTraits<X>::kWidth;

template <class T, int W>
struct IntLanesOf { using type = IntLanes<T, W>; };
template <class T>
struct IntLanesOf<T, 1> { using type = T; };

/// W values of type T: T itself at width 1.
template <class T, int W>
using Ints = typename IntLanesOf<T, W>::type;

/// Lane k; a plain integer is the same in all lanes.
template <class X>
ZERKALO_INLINE constexpr LaneElement<X> lane_of(const X& x, int k) {
    if constexpr (kLanesOf<X> == 1) {
        return x;
    } else {
        return x.v[k];
    }
}

/// A plain integer in all lanes.
template <class X>
ZERKALO_INLINE constexpr X in_all_lanes(LaneElement<X> uniform) {
    if constexpr (kLanesOf<X> == 1) {
        return uniform;
    } else {
        X result{};
        for (int k = 0; k < kLanesOf<X>; ++k) result.v[k] = uniform;
        return result;
    }
}

/// The same function for every lane. Widths are equal, or 1.
template <class F, class... X>
ZERKALO_INLINE constexpr auto each_lane(F f, const X&... x) {
    constexpr int kWidth = [] {
        int widest = 1;
        ((widest = kLanesOf<X> > widest ? kLanesOf<X> : widest), ...);
        return widest;
    }();
    static_assert(((kLanesOf<X> == 1 || kLanesOf<X> == kWidth) && ...), "lanes of different widths do not mix");
    if constexpr (kWidth == 1) {
        return f(x...);
    } else {
        IntLanes<decltype(f(lane_of(x, 0)...)), kWidth> result{};
        for (int k = 0; k < kWidth; ++k) result.v[k] = f(lane_of(x, k)...);
        return result;
    }
}

template <int W>
ZERKALO_INLINE constexpr IntLanes<bool, W> operator&(IntLanes<bool, W> a, IntLanes<bool, W> b) {
    return each_lane([](bool p, bool q) { return p && q; }, a, b);
}
template <int W>
ZERKALO_INLINE constexpr IntLanes<bool, W> operator|(IntLanes<bool, W> a, IntLanes<bool, W> b) {
    return each_lane([](bool p, bool q) { return p || q; }, a, b);
}
template <int W>
ZERKALO_INLINE constexpr IntLanes<bool, W> operator!(IntLanes<bool, W> a) {
    return each_lane([](bool p) { return !p; }, a);
}
template <int W>
ZERKALO_INLINE constexpr bool any(IntLanes<bool, W> m) {
    bool found = false;
    for (int k = 0; k < W; ++k) found = found || m.v[k];
    return found;
}
template <int W>
ZERKALO_INLINE constexpr bool none(IntLanes<bool, W> m) { return !any(m); }
template <int W>
ZERKALO_INLINE constexpr bool all(IntLanes<bool, W> m) { return !any(!m); }

/// The largest value that a format of this type holds; the smallest is its negative, so that -x always exists.
template <std::signed_integral T>
constexpr T kLargest = std::numeric_limits<T>::max();

/// |x|, exact also for the most negative integer.
ZERKALO_INLINE constexpr std::uint64_t magnitude_of(std::int64_t x) {
    return x < 0 ? 0u - static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x);
}

/// The integer of that magnitude and sign, at most the largest of its type.
template <std::signed_integral T>
ZERKALO_INLINE constexpr T saturated(std::uint64_t magnitude, bool negative) {
    constexpr auto kLimit = static_cast<std::uint64_t>(kLargest<T>);
    const T x = static_cast<T>(magnitude < kLimit ? magnitude : kLimit);
    return negative ? static_cast<T>(-x) : x;
}

/// a + b, held at the ends of the type.
template <std::signed_integral T>
ZERKALO_INLINE constexpr T saturated_sum(T a, T b) {
    if constexpr (sizeof(T) < sizeof(std::int64_t)) {
        const std::int64_t sum = std::int64_t{a} + b;
        return saturated<T>(magnitude_of(sum), sum < 0);
    } else {
        // The sum modulo 2^64 has left the range where both terms have a sign that it has not.
        const auto sum = static_cast<T>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
        const bool left = ((sum ^ a) & (sum ^ b)) < 0;
        return left ? (a < 0 ? -kLargest<T> : kLargest<T>) : (sum < -kLargest<T> ? -kLargest<T> : sum);
    }
}

/// x / 2^Shift to nearest, ties away from zero (x * 2^-Shift where Shift is negative), held at the ends of To.
template <std::signed_integral To, int Shift>
ZERKALO_INLINE constexpr To rescaled(std::int64_t x) {
    static_assert(Shift > -63 && Shift < 63);
    std::uint64_t size = magnitude_of(x);
    if constexpr (Shift > 0) {
        size = (size + (std::uint64_t{1} << (Shift - 1))) >> Shift;
    } else if constexpr (Shift < 0) {
        constexpr std::uint64_t kFits = ~std::uint64_t{0} >> -Shift;
        size = size > kFits ? ~std::uint64_t{0} : size << -Shift;
    }
    return saturated<To>(size, x < 0);
}

/// a b / 2^Shift of the exact 96-bit product, to nearest, ties away from zero, held at the ends of To.
template <std::signed_integral To, int Shift>
ZERKALO_INLINE constexpr To rescaled_product(std::int32_t a, std::int64_t b) {
    static_assert(Shift > 32 && Shift < 96, "the low half of the product must lie below the rounding bit");
    const std::uint64_t x = magnitude_of(a), y = magnitude_of(b);
    const std::uint64_t low = x * (y & 0xffffffffu);
    const std::uint64_t high = x * (y >> 32) + (low >> 32);
    const std::uint64_t size = (high + (std::uint64_t{1} << (Shift - 33))) >> (Shift - 32);
    return saturated<To>(size, (a < 0) != (b < 0));
}

/// a 2^Shift / b to nearest, ties away from zero, held at the ends of To. Division by zero: the end of a's sign.
template <std::signed_integral To, int Shift>
ZERKALO_INLINE constexpr To rounded_quotient(std::int64_t a, std::int64_t b) {
    const std::uint64_t divisor = magnitude_of(b);
    const std::uint64_t dividend = magnitude_of(a) << Shift;
    if (divisor == 0) return saturated<To>(std::numeric_limits<std::uint64_t>::max(), a < 0);
    return saturated<To>((dividend + divisor / 2) / divisor, (a < 0) != (b < 0));
}

/// The integer nearest to the square root of x; 0 for x < 0. One bit a step: the same on every target.
ZERKALO_INLINE constexpr std::uint64_t nearest_root(std::int64_t x) {
    std::uint64_t rest = x < 0 ? 0 : static_cast<std::uint64_t>(x);
    std::uint64_t result = 0;
    for (std::uint64_t bit = std::uint64_t{1} << 62; bit != 0; bit >>= 2) {
        const std::uint64_t trial = result + bit;
        const bool fits = rest >= trial;
        rest -= fits ? trial : 0;
        result = (result >> 1) + (fits ? bit : 0);
    }
    // x = result^2 + rest, and (result + 1/2)^2 lies between the integers result^2 + result and the next one.
    return result + (rest > result ? 1u : 0u);
}

}  // namespace zerkalo::inline ZERKALO_ISA
