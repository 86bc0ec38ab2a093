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

/// All bits set where x is so near to halves that `whole`, the integer nearest to it, may not be that of the exact value:
/// x is off by 2^-21 at most.
ZERKALO_INLINE Quads near_halves(Doubles x, Doubles whole) {
    constexpr double kNearHalf = 0.5 - 0x1p-20;
    const Doubles off = x - whole;
    return Quads(Doubles(Quads(off) & kMostLong) > kNearHalf);
}

/// The integer nearest to a / b, ties away from zero, held at the ends; of a / 0 the end of a's sign, of 0 / 0 the
/// upper one. `quotient`: a / b, off by 2^-21 at most where it fits; `whole()`: a itself, asked for where that cannot
/// tell.
template <class Whole>
ZERKALO_INLINE Words settled_quotient(const DoubleParts& quotient, Words b, const Whole& whole) {
    constexpr double kMost = double(kMostWord);
    const DoubleParts within = each_part(
        [](Doubles q) ZERKALO_INLINE_LAMBDA {
            // 0 / 0 is no number, and not less than any.
            const Doubles below = q < kMost ? q : Doubles{} + kMost;
            return below > -kMost ? below : Doubles{} - kMost;
        },
        quotient);
    const DoubleParts rounded =
        each_part([](Doubles q) ZERKALO_INLINE_LAMBDA { return q + 0x1.8p52; }, within);
    const Longs close = each_part(
        [](Doubles q, Doubles r) ZERKALO_INLINE_LAMBDA { return near_halves(q, r - 0x1.8p52); }, within, rounded);
    const Words q = alternating(Words(rounded.even), Words(UnsignedQuads(rounded.odd) << 32));
    if (signs_of(Words(close.even | close.odd)) == 0) return q;
    return q + (last_step(whole(), b, q) & narrow_mask(close));
}
ZERKALO_INLINE Words rounded_quotient(const Longs& a, Words b) {
    const DoubleParts quotient = each_part(
        [](Quads x, Doubles y) ZERKALO_INLINE_LAMBDA { return double_of(x) / y; }, a, doubles_of(b));
    return settled_quotient(quotient, b, [&a]() ZERKALO_INLINE_LAMBDA { return a; });
}
/// a 2^Up / b, 0 <= Up <= 31.
template <int Up>
ZERKALO_INLINE Words rounded_quotient(Words a, Words b) {
    const DoubleParts quotient = each_part(
        [](Doubles x, Doubles y) ZERKALO_INLINE_LAMBDA { return x * double(std::int64_t{1} << Up) / y; }, doubles_of(a),
        doubles_of(b));
    return settled_quotient(quotient, b, [a]() ZERKALO_INLINE_LAMBDA { return raised_longs<Up>(a); });
}
/// Two of these by one divisor, with one division: a 2^Up / b as a times 2^Up / b is rounded twice.
struct WordPair {
    Words first, second;
};
template <int Up, class A>
ZERKALO_INLINE WordPair rounded_quotients(A first, A second, Words b) {
    const DoubleParts inverse = each_part(
        [](Doubles y) ZERKALO_INLINE_LAMBDA { return double(std::int64_t{1} << Up) / y; }, doubles_of(b));
    const auto one = [&](A a) ZERKALO_INLINE_LAMBDA {
        const DoubleParts quotient = each_part(
            [](Doubles x, Doubles y) ZERKALO_INLINE_LAMBDA { return x * y; }, doubles_of(a), inverse);
        return settled_quotient(quotient, b, [a]() ZERKALO_INLINE_LAMBDA { return raised_longs<Up>(Words{} + a); });
    };
    return {one(first), one(second)};
}

/// long_quotient() of a 2^33 / b as 64 bits. Quotients of 2^51 and more lane after lane.
ZERKALO_INLINE Longs long_quotient_longs(Words a, Words b) {
    struct Terms {
        UnsignedQuads dividend, divisor;
        Doubles quotient;
    };
    const auto terms = each_part(
        [](UnsignedQuads x, UnsignedQuads y) ZERKALO_INLINE_LAMBDA {
            // A dividend of 31 bits has room for 32 more.
            const UnsignedQuads drop = x >> 30;
            const UnsignedQuads dividend = (x << 33) >> drop, divisor = (y + drop) >> drop;
            return Terms{dividend, divisor, double_of(dividend) / double_of_small(Quads(divisor))};
        },
        widened_unsigned(magnitude_of(a)), widened_unsigned(magnitude_of(b)));
    const Longs large = each_part(
        [](const Terms& x) ZERKALO_INLINE_LAMBDA { return Quads(!(x.quotient < 0x1p51)); }, terms);
    if (signs_of(Words(large.even | large.odd)) != 0) {
        return each_lane([](std::int32_t x, std::int32_t y) { return long_quotient<std::int64_t, 33>(x, y); },
                         VectorWords(a), VectorWords(b)).v;
    }
    const Words sign = sign_of(a ^ b);
    return each_part(
        [](const Terms& x, Quads s) ZERKALO_INLINE_LAMBDA {
            const UnsignedQuads estimate = UnsignedQuads(x.quotient + 0x1.8p52) - 0x4338000000000000u;
            const UnsignedQuads product =
                low_product(estimate, x.divisor) + (low_product(estimate >> 32, x.divisor) << 32);
            const Quads rest = Quads(x.dividend + (x.divisor >> 1) - product);
            const Quads size = Quads(estimate) + Quads(rest < 0) - Quads(rest >= Quads(x.divisor));
            return (size ^ s) - s;
        },
        terms, wide_mask(sign));
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

/// p q is low modulo 2^32 and two 2^32 + top 2^64 above it: the high half of `two` is still to be carried.
struct WideLimbs {
    UnsignedQuads low, two, top;
};
ZERKALO_INLINE WideLimbs limbs_of_product(UnsignedQuads p, UnsignedQuads q) {
    const UnsignedQuads low = low_product(p, q);
    const UnsignedQuads one = low_product(p >> 32, q) + (low >> 32);
    return {low, low_product(p, q >> 32) + (one & 0xffffffffu), low_product(p >> 32, q >> 32) + (one >> 32)};
}

/// rescaled_wide_product() to 64 bits of two numbers >= 0.
template <int Shift>
ZERKALO_INLINE Quads rescaled_wide_product(Quads a, Quads b) {
    static_assert(Shift > 0 && Shift < 64);
    auto [low, two, top] = limbs_of_product(UnsignedQuads(a), UnsignedQuads(b));
    UnsignedQuads rest{};
    if constexpr (Shift > 32) {
        // The half that rounds is of the second word and upwards; there is room for it.
        two += std::uint64_t{1} << (Shift - 33);
        rest = (two & 0xffffffffu) >> (Shift - 32);
    } else {
        const UnsignedQuads rounded = (low & 0xffffffffu) + (std::uint64_t{1} << (Shift - 1));
        two += rounded >> 32;
        rest = ((two << 32) | (rounded & 0xffffffffu)) >> Shift;
    }
    const UnsignedQuads high = top + (two >> 32);
    const Quads whole = Quads((high << (64 - Shift)) | rest);
    return where_negative(Quads(high >> (Shift - 1) != 0), Quads{} + kMostLong, whole);
}
template <int Shift>
ZERKALO_INLINE Longs rescaled_wide_product(const Longs& a, const Longs& b) {
    return each_part(
        [](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return rescaled_wide_product<Shift>(x, y); }, a, b);
}

/// The same as words from more than 64 bits down, with signs.
template <int Shift>
ZERKALO_INLINE Words rescaled_wide_product_words(const Longs& a, const Longs& b) {
    static_assert(Shift > 64 && Shift < 128);
    const Words sign = sign_of(high_words(a) ^ high_words(b));
    const Longs size = each_part(
        [](Quads x, Quads y) ZERKALO_INLINE_LAMBDA {
            const WideLimbs limbs = limbs_of_product(magnitude_of(x), magnitude_of(y));
            const UnsignedQuads high = limbs.top + (limbs.two >> 32);
            const Quads whole = Quads((high + (std::uint64_t{1} << (Shift - 65))) >> (Shift - 64));
            return whole > kMostWord ? Quads{} + kMostWord : whole;
        },
        a, b);
    return (low_words(size) ^ sign) - sign;
}

}  // namespace zerkalo::inline ZERKALO_ISA
#endif
