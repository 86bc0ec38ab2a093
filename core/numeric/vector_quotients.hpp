// Quotients, roots and wide products of fixed_lanes.hpp and integer_root.hpp on lanes in vector registers: the same
// integers, lane by lane.
//
// Quotients and roots start from the float unit's, which IEEE 754 defines to the last bit; both are then within 1/2 and
// a few 2^-20 of the exact value, and where that cannot tell the remainder, an exact integer, decides.
#pragma once

#include "core/numeric/vector_lanes.hpp"

#if defined(ZERKALO_INT_VECTORS)
namespace zerkalo::inline ZERKALO_ISA {

ZERKALO_INLINE UnsignedWords magnitude_of(Words x) {
    const Words sign = sign_of(x);
    return UnsignedWords((x ^ sign) - sign);
}
ZERKALO_INLINE UnsignedQuads magnitude_of(Quads x) {
    const Quads sign = sign_of(x);
    return UnsignedQuads((x ^ sign) - sign);
}

/// The step from the float unit's quotient q of a by b, rounded, to the integer nearest to a / b, ties away from zero.
/// Where |a / b| is 2^31 or more it means nothing.
ZERKALO_ONCE Words last_step(const Longs& a, Words b, Words q) {
    // The rest is less than b.
    const Longs product = full_product(q, b);
    const Words rest = low_words(each_part(
        [](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return Quads(UnsignedQuads(x) - UnsignedQuads(y)); }, a, product));
    const Words sign = sign_of(high_words(a));
    // |rest / b| > 1/2, or = 1/2 and on the far side of q: 2 |rest| + 1 > |b| where the rest has a's sign.
    const UnsignedWords bound = (magnitude_of(b) + UnsignedWords(~sign_of(rest ^ sign))) >> 1;
    return Words(Words(magnitude_of(rest)) > Words(bound)) & (sign_of(rest ^ b) | 1);
}

/// a / b to nearest, ties away from zero, held at the ends; of a / 0 the end of a's sign, of 0 / 0 the upper one.
/// `dividend`: the doubles nearest to a; `whole()`: a itself, asked for where these cannot tell.
template <class Whole>
ZERKALO_INLINE Words rounded_quotient(const DoubleParts& dividend, Words b, const Whole& whole) {
    // Dividend and quotient, below 2^31, are each rounded by 2^-22 at most.
    constexpr double kMost = double(kMostWord), kNearHalf = 0.5 - 0x1p-20;
    struct Answer {
        Quads quotient, close;
    };
    const auto answer = each_part(
        [](Doubles x, Quads y) ZERKALO_INLINE_LAMBDA {
            // 0 / 0 is no number, and not less than any.
            const Doubles q = x / double_of_small(y);
            const Doubles below = q < kMost ? q : Doubles{} + kMost;
            const Doubles within = below > -kMost ? below : Doubles{} - kMost;
            const Doubles rounded = within + 0x1.8p52, off = within - (rounded - 0x1.8p52);
            return Answer{Quads(rounded), Quads((off > kNearHalf) | (off < -kNearHalf))};
        },
        dividend, widened(b));
    const Words q = low_words(each_part([](const Answer& x) ZERKALO_INLINE_LAMBDA { return x.quotient; }, answer));
    const Words close = narrow_mask(each_part([](const Answer& x) ZERKALO_INLINE_LAMBDA { return x.close; }, answer));
    return signs_of(close) == 0 ? q : q + (last_step(whole(), b, q) & close);
}
ZERKALO_INLINE Words rounded_quotient(const Longs& a, Words b) {
    const DoubleParts dividend = each_part([](Quads x) ZERKALO_INLINE_LAMBDA { return double_of(x); }, a);
    return rounded_quotient(dividend, b, [&a]() ZERKALO_INLINE_LAMBDA { return a; });
}
/// a 2^Up / b, 0 <= Up <= 31.
template <int Up>
ZERKALO_INLINE Words rounded_quotient(Words a, Words b) {
    const DoubleParts dividend = each_part(
        [](Quads x) ZERKALO_INLINE_LAMBDA { return double_of_small(x) * double(std::int64_t{1} << Up); }, widened(a));
    return rounded_quotient(dividend, b, [a]() ZERKALO_INLINE_LAMBDA { return raised_longs<Up>(a); });
}

/// The integer nearest to the square root of x; 0 for x < 0. As 64 bits: the root may have 32.
ZERKALO_INLINE Quads nearest_root(UnsignedQuads x) {
    // From 1/2 on, so that the estimate is at least 1, and the rest of x = 0 negative.
    const Doubles wide = double_of(x);
    const Doubles estimate = square_root(wide > 0.5 ? wide : Doubles{} + 0.5) + 0x1p52;
    const UnsignedQuads root = UnsignedQuads(estimate) & 0xffffffffu;
    // |sqrt(x) - root| < 1/2 + 2^-19, and (root +- 1/2)^2 lies between integers.
    const Quads rest = Quads(x - low_product(root, root));
    return Quads(root) - Quads(rest > Quads(root)) + Quads(rest + Quads(root) < 1);
}
ZERKALO_INLINE Words nearest_root(const Longs& x) {
    const Longs root = each_part(
        [](Quads y) ZERKALO_INLINE_LAMBDA {
            const Quads r = nearest_root(UnsignedQuads(y & ~sign_of(y)));
            return r > kMostWord ? Quads{} + kMostWord : r;
        },
        x);
    return low_words(root);
}

/// a b / 2^Shift of the exact 96-bit product as in rescaled_product(): words from more than 32 bits down.
template <int Shift>
ZERKALO_INLINE Words rescaled_product_words(Words a, const Longs& b) {
    static_assert(Shift > 32 && Shift < 64);
    const Words sign = sign_of(a ^ high_words(b));
    const Longs size = each_part(
        [](UnsignedQuads x, Quads y) ZERKALO_INLINE_LAMBDA {
            constexpr std::uint64_t kHalf = std::uint64_t{1} << (Shift - 33);
            const UnsignedQuads z = magnitude_of(y);
            const UnsignedQuads high = low_product(x, z >> 32) + (low_product(x, z) >> 32);
            const Quads whole = Quads((high + kHalf) >> (Shift - 32));
            return whole > kMostWord ? Quads{} + kMostWord : whole;
        },
        widened_unsigned(magnitude_of(a)), b);
    return (low_words(size) ^ sign) - sign;
}

/// The same to 64 bits and by at most 32, of a product that fits.
template <int Shift>
ZERKALO_INLINE Longs rescaled_product_longs(Words a, const Longs& b) {
    static_assert(Shift > 0 && Shift <= 32);
    const Longs sign = wide_mask(sign_of(a ^ high_words(b)));
    return each_part(
        [](UnsignedQuads x, Quads y, Quads s) ZERKALO_INLINE_LAMBDA {
            constexpr std::uint64_t kHalf = std::uint64_t{1} << (Shift - 1);
            const UnsignedQuads z = magnitude_of(y);
            const UnsignedQuads low = low_product(x, z);
            const UnsignedQuads high = low_product(x, z >> 32) + (low >> 32);
            const UnsignedQuads rest = ((low & 0xffffffffu) + kHalf) >> Shift;
            const Quads whole = Quads((high << (32 - Shift)) + rest);
            const Quads size = where_negative(Quads(high >> (30 + Shift) == 0) & ~whole, whole, Quads{} + kMostLong);
            return (size ^ s) - s;
        },
        widened_unsigned(magnitude_of(a)), b, sign);
}

ZERKALO_INLINE UnsignedQuads low_half(UnsignedQuads a, UnsignedQuads b) {
    // a b modulo 2^64.
    return low_product(a, b) + ((low_product(a, b >> 32) + low_product(a >> 32, b)) << 32);
}

/// long_quotient() as words.
template <int Shift>
ZERKALO_ONCE VectorWords long_quotient_words(const VectorLongs& a, const VectorLongs& b) {
    struct Answer {
        Quads quotient, fits;
    };
    const auto answer = each_part(
        [](Quads x_signed, Quads y_signed) ZERKALO_INLINE_LAMBDA {
            const UnsignedQuads x = magnitude_of(x_signed), y = magnitude_of(y_signed);
            // 2^e is the largest power of two in x, which has room for 62 - e more bits.
            const Quads room = 1023 + 62 - Quads(UnsignedQuads(double_of(x & ~(x >> 1))) >> 52);
            const UnsignedQuads up = UnsignedQuads(room < Shift ? room : Quads{} + Shift);
            const UnsignedQuads down = Shift - up;
            const UnsignedQuads dividend = x << up, divisor = (y + (((UnsignedQuads{} + 1u) << down) >> 1)) >> down;
            constexpr double kHeld = 0x1.fffffffbp+30;
            const Doubles q = double_of(dividend) / double_of(divisor);
            const UnsignedQuads estimate = UnsignedQuads(nearest_in_low_words(q)) & 0xffffffffu;
            const Quads rest = Quads(dividend + (divisor >> 1) - low_half(estimate, divisor));
            const Quads exact = Quads(estimate) + Quads(rest < 0) - Quads(rest >= Quads(divisor));
            return Answer{exact, Quads(q < kHeld)};
        },
        a.v, b.v);
    const Words end = sign_of(high_words(a.v) ^ high_words(b.v));
    const Words size = low_words(each_part([](const Answer& x) ZERKALO_INLINE_LAMBDA { return x.quotient; }, answer));
    const Words fits = narrow_mask(each_part([](const Answer& x) ZERKALO_INLINE_LAMBDA { return x.fits; }, answer));
    return VectorWords((where_negative(fits, size, all_words(kMostWord)) ^ end) - end);
}

/// rescaled_wide_product() to 64 bits of two numbers >= 0.
template <int Shift>
ZERKALO_INLINE Longs rescaled_wide_product(const Longs& a, const Longs& b) {
    static_assert(Shift > 0 && Shift < 64);
    return each_part(
        [](Quads x, Quads y) ZERKALO_INLINE_LAMBDA {
            const UnsignedQuads p = UnsignedQuads(x), q = UnsignedQuads(y);
            const UnsignedQuads low = low_product(p, q);
            const UnsignedQuads one = low_product(p >> 32, q) + (low >> 32);
            const UnsignedQuads two = low_product(p, q >> 32) + (one & 0xffffffffu);
            const UnsignedQuads bottom = (two << 32) | (low & 0xffffffffu);
            UnsignedQuads high = low_product(p >> 32, q >> 32) + (one >> 32) + (two >> 32);
            const UnsignedQuads rounded = bottom + (std::uint64_t{1} << (Shift - 1));
            // A carry goes up: the rounded number is then the smaller one.
            high += UnsignedQuads(rounded < bottom) & 1u;
            const Quads whole = Quads((high << (64 - Shift)) | (rounded >> Shift));
            return where_negative(Quads(high >> (Shift - 1) != 0), Quads{} + kMostLong, whole);
        },
        a, b);
}

}  // namespace zerkalo::inline ZERKALO_ISA
#endif
