// The elementary functions of elementary.hpp in double, by the series of the functions themselves on the same ranges.
// Coefficients are made by the compiler; the stated bounds are tested.
#pragma once

#include "core/numeric/elementary.hpp"

#include <array>

namespace zerkalo::inline ZERKALO_ISA {

/// c[0] + c[1] x + ... by Horner, even and odd powers side by side: half as long to wait. n: even.
template <std::size_t n>
ZERKALO_INLINE double polynomial(const std::array<double, n>& c, double x) {
    static_assert(n % 2 == 0);
    const double z = x * x;
    double even = c[n - 2], odd = c[n - 1];
    for (std::size_t k = n - 2; k > 0; k -= 2) {
        even = even * z + c[k - 2];
        odd = odd * z + c[k - 1];
    }
    return odd * x + even;
}

/// Of x^(start + step k) in the series of e^x, k = 0, 1, ...; `alternating`: every other one is negative.
template <std::size_t n>
consteval std::array<double, n> inverse_factorials(int start, int step, bool alternating) {
    std::array<double, n> c{};
    double factorial = 1;
    for (int i = 2; i <= start; ++i) factorial *= i;
    for (std::size_t k = 0; k < n; ++k) {
        c[k] = (alternating && k % 2 == 1 ? -1 : 1) / factorial;
        for (int i = 0; i < step; ++i) factorial *= start + step * int(k) + i + 1;
    }
    return c;
}

/// Of s^(2k) in 2 artanh(s) / (s ln 2).
template <std::size_t n>
consteval std::array<double, n> log2_series() {
    std::array<double, n> c{};
    for (std::size_t k = 0; k < n; ++k) c[k] = 2 * 0x1.71547652b82fep+0 / double(2 * k + 1);
    return c;
}

constexpr auto kExpSeries = inverse_factorials<14>(1, 1, false);
constexpr auto kSineSeries = inverse_factorials<10>(1, 2, true);
constexpr auto kCosineSeries = inverse_factorials<10>(0, 2, true);
constexpr auto kLog2Series = log2_series<12>();

/// 2^x - 1 for |x| <= 1/2, relative error below 1e-15 also for tiny x.
template <>
ZERKALO_INLINE double exp2_minus_one(double x) {
    const double y = x * 0x1.62e42fefa39efp-1;
    return polynomial(kExpSeries, y) * y;
}

/// 2^x, relative error below 1e-15 for |x| <= 125; saturates at 2^-125 and 2^125, as in float.
template <>
ZERKALO_INLINE double exp2(double x) {
    const double clamped = max(min(x, 125.0), -125.0);
    const double shifted = clamped + kToWhole<double>;
    const double p = exp2_minus_one(clamped - (shifted - kToWhole<double>)) + 1;
    return from_bits(to_bits(p) + (to_bits(shifted) << 52));
}

/// log2(u + lost) for a normal u > 0 and a `lost` below half an ulp of u; relative error below 1e-15.
template <>
ZERKALO_INLINE double log2_of(double u, double lost) {
    // u = m 2^e with m in [sqrt(1/2), sqrt(2)); the quotient is 2 artanh's argument, as in elementary.hpp.
    constexpr std::uint64_t kRootOfHalf = 0x3fe6a09e667f3bcdu;
    const std::uint64_t offset = to_bits(u) + (0x3ff0000000000000u - kRootOfHalf);
    const double e = double(static_cast<std::int32_t>(offset >> 52) - 1023);
    const double m = from_bits((offset & 0x000fffffffffffffu) + kRootOfHalf);
    const double f = (m - 1) + lost;
    const double s = f / (2 + f);
    return polynomial(kLog2Series, s * s) * s + e;
}

/// Sine and cosine of 2 pi x for |x| <= 1, absolute error below 1e-15.
template <>
ZERKALO_INLINE SineCosine<double> sincos_turn(double x) {
    // Quarter turns: x = q/4 + f, |f| <= 1/8.
    const double shifted = x * 4 + kToWhole<double>;
    const double a = (x - (shifted - kToWhole<double>) * 0.25) * 0x1.921fb54442d18p+2;
    const double z = a * a;
    const double s = polynomial(kSineSeries, z) * a, c = polynomial(kCosineSeries, z);
    const std::uint64_t quadrant = to_bits(shifted);
    const bool odd = quadrant & 1;
    const std::uint64_t sine_sign = (quadrant & 2) << 62, cosine_sign = ((quadrant + 1) & 2) << 62;
    return {from_bits(to_bits(odd ? c : s) ^ sine_sign), from_bits(to_bits(odd ? s : c) ^ cosine_sign)};
}

}  // namespace zerkalo::inline ZERKALO_ISA
