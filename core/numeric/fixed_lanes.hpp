// Lanes of integers for fixed point: W values in an array, and loops over them.
//
// One lane is a plain integer, and every operation is written for one lane: `each_lane` repeats it over the others. So
// all widths give the same bits by construction, on any target, also on one without a vector unit or a float unit.
// vector_lanes.hpp has most operations a second time, for lanes in vector registers.
#pragma once

#include "core/numeric/formats.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Lane k; a plain integer is the same in all lanes.
template <class X>
ZERKALO_INLINE constexpr LaneElement<X> lane_of(const X& x, int k) {
    if constexpr (kLanesOf<X> == 1) {
        return x;
    } else if constexpr (IntLaneTraits<X>::kInVectors) {
        return x.lane(k);
    } else {
        return x.v[k];
    }
}

template <class X>
ZERKALO_INLINE constexpr void set_lane(X& x, int k, LaneElement<X> value) {
    if constexpr (kLanesOf<X> == 1) {
        x = value;
    } else if constexpr (IntLaneTraits<X>::kInVectors) {
        x.set_lane(k, value);
    } else {
        x.v[k] = value;
    }
}

/// The first of the types that has more than one lane.
template <class X, class... Rest>
struct WideOf { using type = X; };
template <class X, class... Rest>
    requires(kLanesOf<X> == 1 && sizeof...(Rest) > 0)
struct WideOf<X, Rest...> : WideOf<Rest...> {};

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
        using T = decltype(f(lane_of(x, 0)...));
        typename IntLaneTraits<typename WideOf<X...>::type>::template Like<T> result{};
        for (int k = 0; k < kWidth; ++k) set_lane(result, k, f(lane_of(x, k)...));
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

template <int W>
ZERKALO_INLINE constexpr IntLanes<bool, W> select(IntLanes<bool, W> m, IntLanes<bool, W> a, IntLanes<bool, W> b) {
    return each_lane([](bool p, bool x, bool y) { return p ? x : y; }, m, a, b);
}
/// Bit k is lane k.
template <int W>
ZERKALO_INLINE constexpr std::uint32_t bits_of(IntLanes<bool, W> m) {
    std::uint32_t bits = 0;
    for (int k = 0; k < W; ++k) bits |= (m.v[k] ? 1u : 0u) << k;
    return bits;
}
/// Number of lanes set in the mask, at any width.
template <int W>
ZERKALO_INLINE constexpr std::uint32_t count_of(IntLanes<bool, W> m) {
    std::uint32_t count = 0;
    for (int k = 0; k < W; ++k) count += m.v[k];
    return count;
}

// Unsigned lanes wrap: phases and hashes.
template <int W>
ZERKALO_INLINE constexpr auto operator+(IntLanes<std::uint32_t, W> a, IntLanes<std::uint32_t, W> b) {
    return each_lane([](std::uint32_t x, std::uint32_t y) { return x + y; }, a, b);
}
template <int W>
ZERKALO_INLINE constexpr auto operator*(IntLanes<std::uint32_t, W> a, IntLanes<std::uint32_t, W> b) {
    return each_lane([](std::uint32_t x, std::uint32_t y) { return x * y; }, a, b);
}
template <int W>
ZERKALO_INLINE constexpr auto operator^(IntLanes<std::uint32_t, W> a, IntLanes<std::uint32_t, W> b) {
    return each_lane([](std::uint32_t x, std::uint32_t y) { return x ^ y; }, a, b);
}
template <int W>
ZERKALO_INLINE constexpr auto operator&(IntLanes<std::uint32_t, W> a, IntLanes<std::uint32_t, W> b) {
    return each_lane([](std::uint32_t x, std::uint32_t y) { return x & y; }, a, b);
}
template <int W>
ZERKALO_INLINE constexpr auto operator|(IntLanes<std::uint32_t, W> a, IntLanes<std::uint32_t, W> b) {
    return each_lane([](std::uint32_t x, std::uint32_t y) { return x | y; }, a, b);
}
template <int W>
ZERKALO_INLINE constexpr auto operator<<(IntLanes<std::uint32_t, W> a, int n) {
    return each_lane([n](std::uint32_t x) { return x << n; }, a);
}
template <int W>
ZERKALO_INLINE constexpr auto operator>>(IntLanes<std::uint32_t, W> a, int n) {
    return each_lane([n](std::uint32_t x) { return x >> n; }, a);
}

/// |x|, exact also for the most negative integer.
ZERKALO_INLINE constexpr std::uint64_t magnitude_of(std::int64_t x) {
    return x < 0 ? 0u - static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x);
}

/// The integer of that magnitude and sign, at most the largest of its type.
template <std::signed_integral T>
ZERKALO_INLINE constexpr T saturated(std::uint64_t magnitude, bool negative) {
    constexpr auto kLimit = static_cast<std::uint64_t>(kLargest<T>);
    const T x = checked_narrow<T>(magnitude < kLimit ? magnitude : kLimit, "saturated");
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
        size = checked_sum(size, std::uint64_t{1} << (Shift - 1), "rescaled") >> Shift;
    } else if constexpr (Shift < 0) {
        constexpr std::uint64_t kFits = ~std::uint64_t{0} >> -Shift;
        size = size > kFits ? ~std::uint64_t{0} : checked_shift(size, -Shift, "rescaled");
    }
    return saturated<To>(size, x < 0);
}

/// x / 2^Shift to nearest, ties away from zero, of an x for which it fits.
template <std::signed_integral To, int Shift>
ZERKALO_INLINE constexpr To rounded_shift(std::int64_t x) {
    static_assert(Shift > 0 && Shift < 63);
    // A half less for a negative x: its ties go down.
    const std::int64_t half = (std::int64_t{1} << (Shift - 1)) - (x < 0 ? 1 : 0);
    return checked_narrow<To>(checked_sum<std::int64_t>(x, half, "rounded") >> Shift, "rounded");
}

/// a b / 2^Shift of the exact 96-bit product, to nearest, ties away from zero, held at the ends of To.
template <std::signed_integral To, int Shift>
ZERKALO_INLINE constexpr To rescaled_product(std::int32_t a, std::int64_t b) {
    static_assert(Shift > 0 && Shift < 96);
    const std::uint64_t x = magnitude_of(a), y = magnitude_of(b);
    const std::uint64_t low = checked_product(x, y & 0xffffffffu, "rescaled_product");
    const std::uint64_t carried = checked_product(x, y >> 32, "rescaled_product");
    const std::uint64_t high = checked_sum(carried, low >> 32, "rescaled_product");
    const bool negative = (a < 0) != (b < 0);
    if constexpr (Shift > 32) {
        constexpr std::uint64_t kHalf = std::uint64_t{1} << (Shift - 33);
        return saturated<To>(checked_sum(high, kHalf, "rescaled_product") >> (Shift - 32), negative);
    } else {
        const std::uint64_t rest = ((low & 0xffffffffu) + (std::uint64_t{1} << (Shift - 1))) >> Shift;
        const bool fits = high >> (30 + Shift) == 0;
        if (!fits) return saturated<To>(~std::uint64_t{0}, negative);
        const std::uint64_t whole = checked_shift(high, 32 - Shift, "rescaled_product");
        return saturated<To>(checked_sum(whole, rest, "rescaled_product"), negative);
    }
}

/// An unsigned number of 128 bits.
struct Wide {
    std::uint64_t high, low;
};
ZERKALO_INLINE constexpr Wide wide_product(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t kHalf = 0xffffffffu;
    const std::uint64_t low = (a & kHalf) * (b & kHalf);
    const std::uint64_t one = checked_sum((a >> 32) * (b & kHalf), low >> 32, "wide_product");
    const std::uint64_t two = checked_sum((a & kHalf) * (b >> 32), one & kHalf, "wide_product");
    const std::uint64_t high = checked_sum((a >> 32) * (b >> 32), (one >> 32) + (two >> 32), "wide_product");
    return {high, (two << 32) | (low & kHalf)};
}

/// a b / 2^Shift of the exact 128-bit product, to nearest, ties upwards; all bits set where 64 are too few.
template <int Shift>
ZERKALO_INLINE constexpr std::uint64_t rescaled_wide(std::uint64_t a, std::uint64_t b) {
    static_assert(Shift > 0 && Shift != 64 && Shift < 128);
    Wide wide = wide_product(a, b);
    if constexpr (Shift > 64) {
        return checked_sum(wide.high, std::uint64_t{1} << (Shift - 65), "rescaled_wide") >> (Shift - 64);
    } else {
        const std::uint64_t low = wide.low + (std::uint64_t{1} << (Shift - 1));
        wide.high += low < wide.low;
        return wide.high >> Shift == 0 ? (wide.high << (64 - Shift)) | (low >> Shift) : ~std::uint64_t{0};
    }
}

/// The same for numbers with a sign, ties away from zero, held at the ends of To.
template <std::signed_integral To, int Shift>
ZERKALO_INLINE constexpr To rescaled_wide_product(std::int64_t a, std::int64_t b) {
    return saturated<To>(rescaled_wide<Shift>(magnitude_of(a), magnitude_of(b)), (a < 0) != (b < 0));
}

/// a b / 2^Shift to nearest, ties away from zero, where it fits.
template <int Shift>
ZERKALO_INLINE constexpr std::int64_t rounded_product(std::int32_t a, std::int64_t b) {
    static_assert(Shift > 1 && Shift < 32);
    const std::int64_t low = std::int64_t{a} * static_cast<std::uint32_t>(b & 0xffffffff), high = a * (b >> 32);
    const std::int64_t half = (std::int64_t{1} << (Shift - 1)) - ((a < 0) != (b < 0) ? 1 : 0);
    const auto above = checked_product<std::int64_t>(high, std::int64_t{1} << (32 - Shift), "rounded_product");
    const auto below = checked_sum<std::int64_t>(low, half, "rounded_product") >> Shift;
    return checked_sum<std::int64_t>(above, below, "rounded_product");
}

/// Leading zeros of x > 0.
ZERKALO_INLINE constexpr int leading_zeros(std::uint64_t x) { return __builtin_clzll(x); }

/// a 2^Shift / b to nearest, ties away from zero, held at the ends of To. Division by zero: the end of a's sign.
template <std::signed_integral To, int Shift>
ZERKALO_INLINE constexpr To rounded_quotient(std::int64_t a, std::int64_t b) {
    const std::uint64_t divisor = magnitude_of(b);
    const std::uint64_t dividend = checked_shift(magnitude_of(a), Shift, "rounded_quotient");
    if (divisor == 0) return saturated<To>(std::numeric_limits<std::uint64_t>::max(), a < 0);
    return saturated<To>(checked_sum(dividend, divisor / 2, "rounded_quotient") / divisor, (a < 0) != (b < 0));
}

/// a 2^Shift / b where the shifted dividend need not fit into 64 bits: off by at most one step and 2^-30 of the
/// quotient.
template <std::signed_integral To, int Shift>
ZERKALO_INLINE constexpr To long_quotient(std::int64_t a, std::int64_t b) {
    const std::uint64_t x = magnitude_of(a), y = magnitude_of(b);
    const bool negative = (a < 0) != (b < 0);
    if (x == 0 && y != 0) return 0;
    if (x == 0 || y == 0) return saturated<To>(~std::uint64_t{0}, a < 0);
    const int room = leading_zeros(x) - 1;
    const int up = room < Shift ? room : Shift;
    // Bits of the divisor for which the dividend has no room: they count only where the quotient is out of range.
    const std::uint64_t half = up == Shift ? 0 : std::uint64_t{1} << (Shift - up - 1);
    const std::uint64_t divisor = checked_sum(y, half, "long_quotient") >> (Shift - up);
    if (divisor == 0) return saturated<To>(~std::uint64_t{0}, negative);
    const std::uint64_t dividend = checked_shift(x, up, "long_quotient");
    return saturated<To>(checked_sum(dividend, divisor / 2, "long_quotient") / divisor, negative);
}

/// 2^Shift / x for x >= 0 with a relative error below 2^-30, and one step; held at the end of To.
template <std::signed_integral To, int Shift>
ZERKALO_INLINE constexpr To integer_reciprocal(std::int64_t x) {
    if (x <= 0) return kLargest<To>;
    const int zeros = leading_zeros(static_cast<std::uint64_t>(x));
    // x is nearly m 2^(32 - zeros), with 32 bits of m.
    const std::uint64_t m = checked_shift(static_cast<std::uint64_t>(x), zeros, "integer_reciprocal") >> 32;
    const std::uint64_t inverse = (std::uint64_t{1} << 63) / m;
    const int up = Shift - 95 + zeros;
    if (up > 31) return kLargest<To>;
    if (up >= 0) return saturated<To>(checked_shift(inverse, up, "integer_reciprocal"), false);
    return saturated<To>(up < -33 ? 0 : (inverse + (std::uint64_t{1} << (-up - 1))) >> -up, false);
}

}  // namespace zerkalo::inline ZERKALO_ISA
