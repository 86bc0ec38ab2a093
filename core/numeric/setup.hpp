// Elementary functions in double for set-up, where a few ulp matter more than speed. Own series: libm differs by
// machine, and the constants of a frame must have the same bits everywhere.
#pragma once

#include "core/numeric/isa.hpp"

#include <bit>
#include <cstdint>

namespace zerkalo::inline ZERKALO_ISA {

constexpr double kPi = 0x1.921fb54442d18p+1;

/// Correctly rounded square root of x >= 0.
ZERKALO_INLINE double square_root(double x) { return __builtin_sqrt(x); }

ZERKALO_INLINE double magnitude(double x) { return x < 0 ? -x : x; }

/// The integer nearest to x, |x| < 2^51.
ZERKALO_INLINE double nearest_integer(double x) {
    const double shifted = x + 0x1.8p+52;
    return shifted - 0x1.8p+52;
}

struct SetupSineCosine {
    double sine, cosine;
};

/// Angle in radians, |x| < 1e6; error below 1e-15.
inline SetupSineCosine sine_cosine(double x) {
    // x = k pi/2 + r, |r| <= pi/4; pi/2 in three parts whose first products with k are exact.
    const double k = nearest_integer(x * (2 / kPi));
    const double r = ((x - k * 0x1.921fb544p+0) - k * 0x1.0b4611a6p-34) - k * 0x1.3198a2e037073p-69;
    const double z = r * r;
    double s = 0, c = 0;
    // Taylor's series by Horner: sin = r (1 - z/(2 3) (1 - z/(4 5) (...))), cos = 1 - z/(1 2) (1 - z/(3 4) (...)).
    for (int n = 18; n >= 2; n -= 2) {
        s = (1 - s) * z / double(n * (n + 1));
        c = (1 - c) * z / double(n * (n - 1));
    }
    s = r * (1 - s);
    c = 1 - c;
    const auto quadrant = static_cast<std::int64_t>(k) & 3;
    if (quadrant == 0) return {s, c};
    if (quadrant == 1) return {c, -s};
    if (quadrant == 2) return {-s, -c};
    return {-c, s};
}

/// Natural logarithm of a normal x > 0; relative error below 1e-15.
inline double natural_log(double x) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    // x = m 2^e, m in [sqrt(1/2), sqrt(2)).
    const std::uint64_t offset = bits + (0x3ff0000000000000u - 0x3fe6a09e667f3bcdu);
    const double e = double(static_cast<std::int64_t>(offset >> 52) - 1023);
    const double m = std::bit_cast<double>((offset & 0x000fffffffffffffu) + 0x3fe6a09e667f3bcdu);
    const double s = (m - 1) / (m + 1);
    const double z = s * s;
    double p = 0;
    for (int n = 27; n >= 1; n -= 2) p = p * z + 1.0 / n;
    return 2 * s * p + e * 0x1.62e42fefa39efp-1;
}

/// e^x for -700 < x < 700; relative error below 1e-15 times max(1, |x|).
inline double exponential(double x) {
    const double k = nearest_integer(x * 0x1.71547652b82fep+0);
    const double r = (x - k * 0x1.62e42fefap-1) - k * 0x1.cf79abc9e3b3ap-40;
    double p = 0;
    for (int n = 18; n >= 1; --n) p = (1 + p) * r / n;
    const auto scale = static_cast<std::uint64_t>(static_cast<std::int64_t>(k) + 1023) << 52;
    return (1 + p) * std::bit_cast<double>(scale);
}

}  // namespace zerkalo::inline ZERKALO_ISA
