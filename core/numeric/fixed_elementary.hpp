// log2, exp2, sine and cosine of fixed-point numbers by tables and short series, in integers only; each error is stated
// and tested. Tables are made by the compiler.
#pragma once

#include "core/numeric/elementary.hpp"
#include "core/numeric/fixed.hpp"

#include <array>

namespace zerkalo::inline ZERKALO_ISA {

constexpr std::int64_t kOne60 = std::int64_t{1} << 60;

/// The integer nearest to x 2^bits of a constant x >= 0 in double.
consteval std::uint64_t scaled_constant(double x, int bits) {
    for (int k = 0; k < bits; ++k) x += x;
    return static_cast<std::uint64_t>(x + 0.5);
}

/// log2(x) of a constant x near 1, by 2 artanh(s) / ln 2.
consteval double log2_constant(double x) {
    const double s = (x - 1) / (x + 1);
    double sum = 0;
    for (int n = 41; n >= 1; n -= 2) sum = sum * s * s + 1.0 / n;
    return 2 * s * sum * 0x1.71547652b82fep+0;
}

/// 2^-x of a constant x in 0..1, by the series of e^y.
consteval double exp2_constant(double x) {
    const double y = -x * 0x1.62e42fefa39efp-1;
    double sum = 1;
    for (int n = 24; n >= 1; --n) sum = 1 + sum * y / n;
    return sum;
}

constexpr int kLeastStop = 45, kMostStop = 91;  // 64 / sqrt(2) to 64 sqrt(2)

/// Stops k / 64 of the logarithm: 1 / k, times 2^68, and the logarithm's size, times 2^57.
struct LogStops {
    std::array<std::uint64_t, kMostStop - kLeastStop + 1> inverse, log2_size;
};
consteval LogStops log_stops() {
    LogStops stops{};
    for (std::uint64_t k = kLeastStop; k <= kMostStop; ++k) {
        // 2^68 / k in two steps of long division.
        constexpr std::uint64_t kHalfWay = std::uint64_t{1} << 63;
        const double log2 = log2_constant(double(k) / 64);
        stops.inverse[k - kLeastStop] = ((kHalfWay / k) << 5) + ((kHalfWay % k << 5) + k / 2) / k;
        stops.log2_size[k - kLeastStop] = scaled_constant(log2 < 0 ? -log2 : log2, 57);
    }
    return stops;
}
constexpr LogStops kLogStops = log_stops();

/// -log2(y), times 2^57, of y 2^60 with 0 < y <= 1. Error below 2^-29 of the result, also near y = 1, and 2^-55.
ZERKALO_INLINE constexpr std::int64_t minus_log2_of(std::int64_t y) {
    if (y >= kOne60) return 0;
    const int zeros = leading_zeros(static_cast<std::uint64_t>(y));
    // y = m / 2^63 * 2^(3 - zeros), 1 <= m / 2^63 < 2.
    const std::uint64_t m = checked_shift(static_cast<std::uint64_t>(y), zeros, "log2");
    // v = m / 2^63 or half of it, in sqrt(1/2) .. sqrt(2); the nearest stop k / 64; d = (64 v - k) 2^58.
    const bool halved = m >= 0xb504f333f9de6484u;
    const int wide = halved ? 58 : 57;
    const auto k = static_cast<std::int64_t>(((m >> (wide - 1)) + 1) >> 1);
    const std::int64_t off = static_cast<std::int64_t>(m - (static_cast<std::uint64_t>(k) << wide));
    const std::int64_t d = halved ? off : off + off;
    const auto stop = static_cast<std::size_t>(k - kLeastStop);
    // f = v / (k / 64) - 1 in 2^-66; |f| <= 1/90.
    const auto inverse = static_cast<std::int64_t>(kLogStops.inverse[stop]);
    const std::int64_t f = rescaled_wide_product<std::int64_t, 60>(d, inverse);
    // log2(1 + f) = f / ln 2 (1 - f/2 + f^2/3 - f^3/4 + f^4/5), the bracket in 2^-30.
    const std::int64_t g = rescaled<std::int64_t, 36>(f);
    constexpr std::int64_t kOne = std::int64_t{1} << 30;
    std::int64_t bracket = kOne / 4 - rescaled<std::int64_t, 30>(g * (kOne / 5));
    bracket = kOne / 3 - rescaled<std::int64_t, 30>(g * bracket);
    bracket = kOne / 2 - rescaled<std::int64_t, 30>(g * bracket);
    bracket = kOne - rescaled<std::int64_t, 30>(g * bracket);
    constexpr auto kInverseLn2 = static_cast<std::int64_t>(scaled_constant(0x1.71547652b82fep+0, 32));
    const std::int64_t slope = rescaled<std::int64_t, 30>(bracket * kInverseLn2);
    const std::int64_t part = rescaled_wide_product<std::int64_t, 41>(f, slope);  // 66 + 32 - 57
    const auto size = static_cast<std::int64_t>(kLogStops.log2_size[stop]);
    const std::int64_t whole = std::int64_t{zeros - 3 - (halved ? 1 : 0)} << 57;
    return whole - (k < 64 ? -size : size) - part;
}

/// 2^-(i / 64), times 2^62.
consteval std::array<std::uint64_t, 64> exp_stops() {
    std::array<std::uint64_t, 64> stops{};
    for (std::uint64_t i = 0; i < 64; ++i) stops[i] = scaled_constant(exp2_constant(double(i) / 64), 62);
    return stops;
}
constexpr std::array<std::uint64_t, 64> kExpStops = exp_stops();

/// 1 - 2^-e, times 2^60, of e 2^57 with e >= 0. Error below 2^-29 of the result, also for tiny e, and 2^-57.
ZERKALO_INLINE constexpr std::int64_t one_minus_exp2_of(std::int64_t e) {
    const auto whole = checked_narrow<int>(e >> 57, "exp2");
    if (whole >= 60) return kOne60;
    const auto stop = static_cast<std::size_t>((e >> 51) & 63);
    const std::int64_t r = e & ((std::int64_t{1} << 51) - 1);  // r / 2^57 < 1/64
    // 1 - 2^-r = y (1 - y/2 (1 - y/3 (1 - y/4))), y = r ln 2; y in 2^-67, the bracket in 2^-40.
    constexpr auto kLn2 = static_cast<std::int64_t>(scaled_constant(0x1.62e42fefa39efp-1, 62));
    const std::int64_t y = rescaled_wide_product<std::int64_t, 52>(r, kLn2);
    const std::int64_t z = rescaled<std::int64_t, 37>(y);  // in 2^-30
    constexpr std::int64_t kOne = std::int64_t{1} << 30;
    std::int64_t bracket = kOne - z / 4;
    bracket = kOne - ((z * bracket) >> 30) / 3;
    bracket = kOne - ((z * bracket) >> 30) / 2;
    const std::int64_t q = rescaled_wide_product<std::int64_t, 37>(y, bracket);  // 67 + 30 - 60
    const std::uint64_t scale = kExpStops[stop];
    const std::uint64_t lost = rescaled_wide<62>(scale, checked_narrow<std::uint64_t>(q, "exp2"));
    const auto rest = checked_narrow<std::uint64_t>(static_cast<std::int64_t>((scale + 2) >> 2) -
                                                        checked_narrow<std::int64_t>(lost, "exp2"),
                                                    "exp2");  // 2^-(fraction of e), times 2^60
    const std::uint64_t half = whole == 0 ? 0 : std::uint64_t{1} << (whole - 1);
    return kOne60 - static_cast<std::int64_t>((rest + half) >> whole);
}

struct IntegerSineCosine {
    std::int32_t sine, cosine;
};

/// Sine and cosine, times 2^30, of a phase whose turn is 2^32. Absolute error below 2^-28.
ZERKALO_INLINE constexpr IntegerSineCosine sine_cosine_of_phase(std::uint32_t phase) {
    const std::uint32_t quarter = (phase + 0x20000000u) >> 30;
    const auto f = static_cast<std::int32_t>(phase - (quarter << 30));  // at most an eighth of a turn
    constexpr auto kTwoPi = static_cast<std::int64_t>(scaled_constant(0x1.921fb54442d18p+2, 30));
    const std::int64_t a = rescaled<std::int64_t, 31>(f * kTwoPi);  // radians in 2^-31
    const std::int64_t z = rescaled<std::int64_t, 31>(a * a);
    constexpr std::int64_t kOne = std::int64_t{1} << 31;
    // Taylor's series by Horner, as in setup.hpp.
    std::int64_t s = 0, c = 0;
    for (int n = 10; n >= 2; n -= 2) {
        s = (((kOne - s) * z) >> 31) / (n * (n + 1));
        c = (((kOne - c) * z) >> 31) / (n * (n - 1));
    }
    const auto sine = checked_narrow<std::int32_t>(rescaled<std::int64_t, 32>(a * (kOne - s)), "sine");
    const auto cosine = checked_narrow<std::int32_t>((kOne - c + 1) >> 1, "cosine");
    switch (quarter & 3) {
        case 0: return {sine, cosine};
        case 1: return {cosine, -sine};
        case 2: return {-sine, -cosine};
        default: return {-cosine, sine};
    }
}

/// As sincos_turn() in elementary.hpp, of a wrapping phase.
template <class D, class P>
    requires std::same_as<LaneElement<P>, std::uint32_t>
ZERKALO_INLINE SineCosine<D> sincos_turn(P phase) {
    SineCosine<D> result{};
    for (int k = 0; k < kLanesOf<P>; ++k) {
        const IntegerSineCosine one = sine_cosine_of_phase(lane_of(phase, k));
        set_lane(result.sine.raw, k, one.sine);
        set_lane(result.cosine.raw, k, one.cosine);
    }
    return result;
}

/// 1 - u^s of u, s in 0..1: 1 - cos(theta) of a lobe's ray, without cancellation near u = 1.
template <class A, Format F, class B, Format FS>
ZERKALO_INLINE auto one_minus_power(Fixed<A, F> u, Fixed<B, FS> s) {
    static_assert(F.fraction == 60);
    return with_format<60>(each_lane(
        [](std::int64_t x, std::int64_t y) {
            return one_minus_exp2_of(rescaled_wide_product<std::int64_t, FS.fraction>(minus_log2_of(x), y));
        },
        u.raw, s.raw));
}

/// (1 - x)^n for 0 <= x as in elementary.hpp. Error below 2^-27 and n 2^-57, the steps of 1 - x and of its logarithm.
template <class A, class B, Format FN>
ZERKALO_INLINE auto power_of_one_minus(Fixed<A, 61> x, Fixed<B, FN> n) {
    return with_format<60>(each_lane(
        [](std::int64_t a, std::int64_t b) {
            const std::int64_t y = kOne60 - rescaled<std::int64_t, 1>(a);
            if (y <= 0) return std::int64_t{0};
            return kOne60 - one_minus_exp2_of(rescaled_wide_product<std::int64_t, FN.fraction>(minus_log2_of(y), b));
        },
        x.raw, n.raw));
}

/// x / sqrt(x^2 + y^2 + z^2) and so on in 2^-30, and the root: the components share one exponent, so that short vectors
/// keep their digits. Error of a component below 2^-29.
struct IntegerUnit {
    std::int32_t x, y, z;
    std::int64_t length;
};
ZERKALO_INLINE IntegerUnit unit_of_integers(std::int64_t x, std::int64_t y, std::int64_t z) {
    const std::uint64_t largest = magnitude_of(x) | magnitude_of(y) | magnitude_of(z);
    if (largest == 0) return {0, 0, 0, 0};
    // The largest component gets 31 bits.
    const int up = leading_zeros(largest) - 33;
    const auto shifted = [up](std::int64_t a) {
        if (up >= 0) return a * (std::int64_t{1} << up);
        const std::uint64_t size = checked_sum(magnitude_of(a), std::uint64_t{1} << (-up - 1), "unit") >> -up;
        return a < 0 ? -static_cast<std::int64_t>(size) : static_cast<std::int64_t>(size);
    };
    const std::int64_t a = shifted(x), b = shifted(y), c = shifted(z);
    const auto square = [](std::int64_t size) { return static_cast<std::uint64_t>(size * size); };
    const std::uint64_t length =
        nearest_root_of(checked_sum(checked_sum(square(a), square(b), "unit"), square(c), "unit"));
    const auto inverse = static_cast<std::int64_t>(((std::uint64_t{1} << 62) + length / 2) / length);
    const auto share = [inverse](std::int64_t size) { return rescaled<std::int32_t, 32>(size * inverse); };
    const std::uint64_t whole =
        up > 0 ? (length + (std::uint64_t{1} << (up - 1))) >> up : checked_shift(length, -up, "unit");
    return {share(a), share(b), share(c), saturated<std::int64_t>(whole, false)};
}

}  // namespace zerkalo::inline ZERKALO_ISA
