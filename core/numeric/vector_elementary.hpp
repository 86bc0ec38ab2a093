// power_of_one_minus() of fixed_elementary.hpp on lanes in vector registers: the same integers, lane by lane. Numbers
// and steps are those that stand there.
#pragma once

#include "core/numeric/fixed_elementary.hpp"
#include "core/numeric/fixed_vectors.hpp"

#if defined(ZERKALO_INT_VECTORS)
namespace zerkalo::inline ZERKALO_ISA {

/// x / 2^Shift to nearest, ties away from zero; only the low words count.
template <int Shift>
ZERKALO_INLINE Quads rounded_low(Quads x) {
    const UnsignedQuads sum = UnsignedQuads(x) + (std::uint64_t{1} << (Shift - 1)) - (UnsignedQuads(x) >> 63);
    // Beyond half of the bits signs come down too.
    return Shift > 32 ? shifted_right<Shift>(Quads(sum)) : Quads(sum >> Shift);
}

/// rescaled_wide_product() by a b >= 0, with a sign.
template <int Shift>
ZERKALO_INLINE Quads rescaled_signed_product(Quads a, Quads b) {
    const Quads sign = sign_of(a);
    const Quads size = rescaled_wide_product<Shift>(Quads(magnitude_of(a)), b);
    return (size ^ sign) - sign;
}

template <std::size_t n>
ZERKALO_INLINE Quads entries_of(const std::array<std::uint64_t, n>& table, Quads index) {
    Quads entries;
    for (int k = 0; k < kPartLanes; ++k) {
        entries[k] = static_cast<std::int64_t>(table[static_cast<std::size_t>(index[k])]);
    }
    return entries;
}

/// minus_log2_of() of y > 0.
ZERKALO_INLINE Quads minus_log2_of(Quads y) {
    const Quads zeros = 1023 + 63 - Quads(UnsignedQuads(double_of(UnsignedQuads(y & ~(y >> 1)))) >> 52);
    const UnsignedQuads m = UnsignedQuads(y) << UnsignedQuads(zeros);
    // All have the highest bit, and compare alike as numbers with a sign.
    const Quads halved = Quads(Quads(m) >= Quads(UnsignedQuads{} + 0xb504f333f9de6484u));
    const UnsignedQuads wide = UnsignedQuads(57 - halved);
    const UnsignedQuads k = ((m >> (wide - 1)) + 1) >> 1;
    const Quads off = Quads(m - (k << wide));
    const Quads d = off + (off & ~halved);
    const Quads stop = Quads(k) - kLeastStop;
    const Quads f = rescaled_signed_product<60>(d, entries_of(kLogStops.inverse, stop));
    const Quads g = rounded_low<36>(f);
    constexpr std::int64_t kOne = std::int64_t{1} << 30;
    Quads bracket = kOne / 4 - rounded_low<30>(low_product(g, Quads{} + kOne / 5));
    bracket = kOne / 3 - rounded_low<30>(low_product(g, bracket));
    bracket = kOne / 2 - rounded_low<30>(low_product(g, bracket));
    bracket = kOne - rounded_low<30>(low_product(g, bracket));
    // 1 / ln 2 in 2^-32 has 33 bits.
    constexpr std::uint64_t kInverseLn2 = scaled_constant(0x1.71547652b82fep+0, 32);
    const UnsignedQuads whole_bracket = UnsignedQuads(bracket) & 0xffffffffu;
    const UnsignedQuads product =
        low_product(whole_bracket, UnsignedQuads{} + (kInverseLn2 & 0xffffffffu)) + (whole_bracket << 32);
    static_assert(kInverseLn2 >> 32 == 1);
    const Quads slope = Quads((product + (std::uint64_t{1} << 29)) >> 30);
    const Quads part = rescaled_signed_product<41>(f, slope);
    const Quads size = entries_of(kLogStops.log2_size, stop);
    const Quads whole = Quads(UnsignedQuads(zeros - 3 + halved) << 57);
    const Quads log2 = whole - where_negative(Quads(k) - 64, -size, size) - part;
    return log2 & Quads(y < kOne60);
}

/// one_minus_exp2_of().
ZERKALO_INLINE Quads one_minus_exp2_of(Quads e) {
    const UnsignedQuads whole = UnsignedQuads(e) >> 57;
    const Quads stop = (e >> 51) & 63;
    const Quads r = e & ((std::int64_t{1} << 51) - 1);
    constexpr auto kLn2 = static_cast<std::int64_t>(scaled_constant(0x1.62e42fefa39efp-1, 62));
    const Quads y = rescaled_wide_product<52>(r, Quads{} + kLn2);
    const UnsignedQuads z = UnsignedQuads(rounded_low<37>(y));
    constexpr std::uint64_t kOne = std::uint64_t{1} << 30, kThird = 0xaaaaaaabu;  // of words, in 2^-33
    UnsignedQuads bracket = kOne - (z >> 2);
    bracket = kOne - (low_product(low_product(z, bracket) >> 30, UnsignedQuads{} + kThird) >> 33);
    bracket = kOne - (low_product(z, bracket) >> 31);
    const Quads q = rescaled_wide_product<37>(y, Quads(bracket));
    const Quads scale = entries_of(kExpStops, stop);
    const Quads lost = rescaled_wide_product<62>(scale, q);
    const UnsignedQuads rest = UnsignedQuads((scale + 2) >> 2) - UnsignedQuads(lost);
    const UnsignedQuads half = ((UnsignedQuads{} + 1u) << whole) >> 1;
    const Quads exp2 = Quads((rest + half) >> whole);
    return kOne60 - (exp2 & Quads(whole < 60));
}

template <class A, class B, Format FN>
    requires InVectors<A, B>
ZERKALO_ONCE auto power_of_one_minus(Fixed<A, 61> x, Fixed<B, FN> n) {
    return fixed_of<60>(each_part(
        [](Quads a, Quads b) ZERKALO_INLINE_LAMBDA {
            const Quads y = kOne60 - Quads(UnsignedQuads(a + 1) >> 1);
            const Quads within = y > 0 ? y : Quads{} + 1;
            const Quads power =
                kOne60 - one_minus_exp2_of(rescaled_wide_product<FN.fraction>(minus_log2_of(within), b));
            return power & Quads(y > 0);
        },
        registers_of(x.raw), registers_of(n.raw)));
}

}  // namespace zerkalo::inline ZERKALO_ISA
#endif
