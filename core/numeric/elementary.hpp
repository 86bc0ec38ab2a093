// log2, exp2, sine and cosine in lanes, and the power that every lobe needs. Own polynomials: libm differs by machine.
// Coefficients: Chebyshev fits in 40 digits, rounded to float; the stated bounds are tested.
#pragma once

#include "core/numeric/lane.hpp"

#include <limits>

namespace zerkalo::inline ZERKALO_ISA {

/// 1.5 times the T from which on all are whole: adding it leaves the nearest whole number in the low bits.
template <class T>
constexpr T kToWhole = T(3) / std::numeric_limits<T>::epsilon() / 2;

/// 2^x - 1 for |x| <= 1/2, relative error below 1.4e-7 also for tiny x.
template <class R>
ZERKALO_INLINE R exp2_minus_one(R x) {
    R p = R(0x1.44138ap-13f);
    p = p * x + R(0x1.5f0890p-10f);
    p = p * x + R(0x1.3b2a54p-7f);
    p = p * x + R(0x1.c6af6cp-5f);
    p = p * x + R(0x1.ebfbe0p-3f);
    p = p * x + R(0x1.62e430p-1f);
    return p * x;
}

/// 2^x, relative error below 1e-7 for |x| <= 125; saturates at 2^-125 and 2^125.
template <class R>
ZERKALO_INLINE R exp2(R x) {
    const R clamped = max(min(x, R(125)), R(-125));
    // Adding 1.5 * 2^23 leaves the nearest integer in the low bits.
    const R shifted = clamped + R(kToWhole<float>);
    const R f = clamped - (shifted - R(kToWhole<float>));
    const R p = exp2_minus_one(f) + R(1);
    return from_bits(to_bits(p) + (to_bits(shifted) << 23));
}

/// log2(u + lost) for a normal u > 0 and a `lost` below half an ulp of u; relative error below 2.5e-7.
template <class R>
ZERKALO_INLINE R log2_of(R u, R lost) {
    // u = m 2^e with m in [sqrt(1/2), sqrt(2)).
    const Bits<R> offset = to_bits(u) + Bits<R>(0x3f800000u - 0x3f3504f3u);
    const R e = from_bits((offset >> 23) | Bits<R>(0x4b000000u)) - R(8388608.0f + 127.0f);
    const R m = from_bits((offset & Bits<R>(0x007fffffu)) + Bits<R>(0x3f3504f3u));
    const R f = (m - R(1)) + lost;
    // log2(1 + f) = (2 / ln 2) artanh(s), s = f / (2 + f).
    const R s = f / (R(2) + f);
    const R z = s * s;
    R p = R(0x1.ba1f7cp-2f);
    p = p * z + R(0x1.274702p-1f);
    p = p * z + R(0x1.ec70e6p-1f);
    p = p * z + R(0x1.715476p+1f);
    return p * s + e;
}

/// log2(1 - x) for 0 <= x < 1, relative error below 2.5e-7 also for tiny x: the rounding of 1 - x is put back.
template <class R>
ZERKALO_INLINE R log2_one_minus(R x) {
    const R u = R(1) - x;
    return log2_of(u, (R(1) - u) - x);
}

/// Sine and cosine of 2 pi x for |x| <= 1, absolute error below 1e-7.
template <class R>
struct SineCosine {
    R sine, cosine;
};
template <class R>
ZERKALO_INLINE SineCosine<R> sincos_turn(R x) {
    // Quarter turns: x = q/4 + f, |f| <= 1/8.
    const R shifted = x * R(4) + R(kToWhole<float>);
    const R f = x - (shifted - R(kToWhole<float>)) * R(0.25f);
    const R z = f * f;
    R s = R(-0x1.2d9b40p+6f);
    s = s * z + R(0x1.465ec4p+6f);
    s = s * z + R(-0x1.4abbbap+5f);
    s = (s * z + R(0x1.921fb6p+2f)) * f;
    R c = R(0x1.db6492p+5f);
    c = c * z + R(-0x1.55cb98p+6f);
    c = c * z + R(0x1.03c1eap+6f);
    c = c * z + R(-0x1.3bd3ccp+4f);
    c = c * z + R(1);
    const Bits<R> quadrant = to_bits(shifted);
    const Bits<R> odd = (quadrant & Bits<R>(1u)) << 31;
    const auto swap = from_bits(odd | Bits<R>(0x3f800000u)) < R(0);
    const Bits<R> sine_sign = (quadrant & Bits<R>(2u)) << 30;
    const Bits<R> cosine_sign = ((quadrant + Bits<R>(1u)) & Bits<R>(2u)) << 30;
    return {from_bits(to_bits(select(swap, c, s)) ^ sine_sign), from_bits(to_bits(select(swap, s, c)) ^ cosine_sign)};
}

/// A quarter of a turn on: the bits that sincos_turn(x + 1/4) has, but where x lies in the middle of an eighth.
template <class R>
ZERKALO_INLINE SineCosine<R> quarter_turned(SineCosine<R> a) {
    return {a.cosine, -a.sine};
}

/// (1 - x)^n for 0 <= x: a cosine power from the chord between two unit vectors, x = |a - b|^2 / 2, exact in shape for
/// n up to 1e6 where a power of the dot product has lost all digits. Zero for x >= 1. n = 0 gives 1 for x < 1.
template <class R>
ZERKALO_INLINE R power_of_one_minus(R x, R n) {
    const auto inside = x < R(1);
    const R exponent = n * log2_one_minus(select(inside, x, R(0.5f)));
    return select(inside & (exponent > R(-125)), exp2(exponent), R(0));
}

}  // namespace zerkalo::inline ZERKALO_ISA
