// The integer operations of fixed_lanes.hpp and integer_root.hpp on lanes in vector registers: the same integers, lane by
// lane. What has no form here is done one lane after the other, by each_lane().
//
// Quotients and roots start from the float unit's, which IEEE 754 defines to the last bit; both are then within 1/2 and
// a few 2^-20 of the exact value, and the remainder, an exact integer, decides.
#pragma once

#include "core/numeric/int_vectors.hpp"

#if defined(ZERKALO_INT_VECTORS)
namespace zerkalo::inline ZERKALO_ISA {

/// W integers, or W booleans: all bits of a word alike.
template <class T, int W>
struct VectorInts {
    static_assert(W == kVectorWidth && sizeof(T) <= 4);
    using Raw = std::conditional_t<std::same_as<T, std::uint32_t>, UnsignedWords, Words>;
    Raw v;

    VectorInts() = default;
    ZERKALO_INLINE explicit VectorInts(Raw raw) : v(raw) {}
    ZERKALO_INLINE explicit VectorInts(T uniform) : v(Raw{} + raw_of(uniform)) {}
    ZERKALO_INLINE T lane(int k) const {
        if constexpr (std::same_as<T, bool>) {
            return v[k] != 0;
        } else {
            return v[k];
        }
    }
    ZERKALO_INLINE void set_lane(int k, T x) { v[k] = raw_of(x); }

private:
    static ZERKALO_INLINE auto raw_of(T x) {
        if constexpr (std::same_as<T, bool>) {
            return x ? -1 : 0;
        } else {
            return x;
        }
    }
};
template <int W>
struct VectorInts<std::int64_t, W> {
    static_assert(W == kVectorWidth);
    Longs v;

    VectorInts() = default;
    ZERKALO_INLINE explicit VectorInts(const Longs& raw) : v(raw) {}
    ZERKALO_INLINE explicit VectorInts(std::int64_t uniform) : v(all_longs(uniform)) {}
#if defined(ZERKALO_ONE_PART)
    ZERKALO_INLINE std::int64_t lane(int k) const { return v.even[k]; }
    ZERKALO_INLINE void set_lane(int k, std::int64_t x) { v.even[k] = x; }
#else
    ZERKALO_INLINE std::int64_t lane(int k) const { return k & 1 ? v.odd[k >> 1] : v.even[k >> 1]; }
    ZERKALO_INLINE void set_lane(int k, std::int64_t x) { (k & 1 ? v.odd : v.even)[k >> 1] = x; }
#endif
};

/// VectorInts as FixedNumbers asks for them; a width of 1 is the integer itself.
template <class T, int W>
using Vectors = std::conditional_t<W == 1, T, VectorInts<T, (W == 1 ? kVectorWidth : W)>>;

}  // namespace zerkalo::inline ZERKALO_ISA

namespace zerkalo {
template <class T, int W>
struct IntLaneTraits<VectorInts<T, W>> {
    using Element = T;
    static constexpr int kWidth = W;
    static constexpr bool kInVectors = true;
    template <class U>
    using Like = VectorInts<U, W>;
};
}  // namespace zerkalo

namespace zerkalo::inline ZERKALO_ISA {

using VectorMask = VectorInts<bool, kVectorWidth>;
using VectorWords = VectorInts<std::int32_t, kVectorWidth>;
using VectorLongs = VectorInts<std::int64_t, kVectorWidth>;
using VectorBits = VectorInts<std::uint32_t, kVectorWidth>;

ZERKALO_INLINE VectorMask operator&(VectorMask a, VectorMask b) { return VectorMask(a.v & b.v); }
ZERKALO_INLINE VectorMask operator|(VectorMask a, VectorMask b) { return VectorMask(a.v | b.v); }
ZERKALO_INLINE VectorMask operator!(VectorMask a) { return VectorMask(~a.v); }
ZERKALO_INLINE std::uint32_t bits_of(VectorMask m) { return signs_of(m.v); }
ZERKALO_INLINE bool any(VectorMask m) { return bits_of(m) != 0; }
ZERKALO_INLINE bool none(VectorMask m) { return bits_of(m) == 0; }
ZERKALO_INLINE bool all(VectorMask m) { return bits_of(m) == (1u << kVectorWidth) - 1; }
ZERKALO_INLINE std::uint32_t count_of(VectorMask m) {
    return static_cast<std::uint32_t>(__builtin_popcount(bits_of(m)));
}

// Unsigned lanes wrap: phases and hashes.
ZERKALO_INLINE VectorBits operator+(VectorBits a, VectorBits b) { return VectorBits(a.v + b.v); }
ZERKALO_INLINE VectorBits operator*(VectorBits a, VectorBits b) { return VectorBits(a.v * b.v); }
ZERKALO_INLINE VectorBits operator^(VectorBits a, VectorBits b) { return VectorBits(a.v ^ b.v); }
ZERKALO_INLINE VectorBits operator&(VectorBits a, VectorBits b) { return VectorBits(a.v & b.v); }
ZERKALO_INLINE VectorBits operator|(VectorBits a, VectorBits b) { return VectorBits(a.v | b.v); }
ZERKALO_INLINE VectorBits operator<<(VectorBits a, int n) { return VectorBits(a.v << n); }
ZERKALO_INLINE VectorBits operator>>(VectorBits a, int n) { return VectorBits(a.v >> n); }

constexpr std::int32_t kMostWord = kLargest<std::int32_t>;
constexpr std::int64_t kMostLong = kLargest<std::int64_t>;

ZERKALO_INLINE Words chosen(Words m, Words a, Words b) { return where_negative(m, a, b); }
ZERKALO_INLINE Longs chosen(Words m, const Longs& a, const Longs& b) {
    return each_part([](Quads mask, Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return where_negative(mask, x, y); },
                     wide_mask(m), a, b);
}

ZERKALO_INLINE Words is_less(Words a, Words b) { return Words(a < b); }
ZERKALO_INLINE Words is_less(const Longs& a, const Longs& b) {
    return narrow_mask(each_part([](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return Quads(x < y); }, a, b));
}
ZERKALO_INLINE Words is_equal(Words a, Words b) { return Words(a == b); }
ZERKALO_INLINE Words is_equal(const Longs& a, const Longs& b) {
    return narrow_mask(each_part([](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return Quads(x == y); }, a, b));
}

/// Never the most negative integer.
ZERKALO_INLINE Words held(Words x) { return x > -kMostWord ? x : all_words(-kMostWord); }
ZERKALO_INLINE Quads held(Quads x) { return x - Quads(x == -kMostLong - 1); }

ZERKALO_INLINE Words negative(Words a) { return -a; }
ZERKALO_INLINE Longs negative(const Longs& a) {
    return each_part([](Quads x) ZERKALO_INLINE_LAMBDA { return -x; }, a);
}

// a + b and a - b, held at the ends of the type. Where the sum modulo 2^n has left the range, both terms have a sign that
// it has not.
ZERKALO_INLINE Words held_sum(Words a, Words b) {
    const Words sum = Words(UnsignedWords(a) + UnsignedWords(b));
    return held(where_negative((sum ^ a) & (sum ^ b), sign_of(a) ^ kMostWord, sum));
}
ZERKALO_INLINE Words held_difference(Words a, Words b) {
    const Words difference = Words(UnsignedWords(a) - UnsignedWords(b));
    return held(where_negative((difference ^ a) & (a ^ b), sign_of(a) ^ kMostWord, difference));
}
ZERKALO_INLINE Quads held_sum(Quads a, Quads b) {
    const Quads sum = Quads(UnsignedQuads(a) + UnsignedQuads(b));
    return held(where_negative((sum ^ a) & (sum ^ b), sign_of(a) ^ kMostLong, sum));
}
ZERKALO_INLINE Quads held_difference(Quads a, Quads b) {
    const Quads difference = Quads(UnsignedQuads(a) - UnsignedQuads(b));
    return held(where_negative((difference ^ a) & (a ^ b), sign_of(a) ^ kMostLong, difference));
}
ZERKALO_INLINE Longs held_sum(const Longs& a, const Longs& b) {
    return each_part([](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return held_sum(x, y); }, a, b);
}
ZERKALO_INLINE Longs held_difference(const Longs& a, const Longs& b) {
    return each_part([](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return held_difference(x, y); }, a, b);
}

/// a + b and a - b of two products of words, which 64 bits hold.
ZERKALO_INLINE Longs sum_of_products(const Longs& a, const Longs& b) {
    return each_part([](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return x + y; }, a, b);
}
ZERKALO_INLINE Longs difference_of_products(const Longs& a, const Longs& b) {
    return each_part([](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return x - y; }, a, b);
}

/// x / 2^Shift to nearest, ties away from zero.
template <int Shift>
ZERKALO_INLINE Longs rescaled_longs(const Longs& x) {
    static_assert(Shift > 1 && Shift < 63);
    return each_part(
        [](Quads y) ZERKALO_INLINE_LAMBDA {
            return shifted_right<1>(shifted_right<Shift - 1>(y + sign_of(y)) + 1);
        },
        x);
}
/// The same as words held at the ends.
template <int Shift>
ZERKALO_INLINE Words rescaled_words(const Longs& x) {
    static_assert(Shift > 1 && Shift < 62);
    constexpr std::int64_t kHalf = std::int64_t{1} << (Shift - 1);
#if defined(ZERKALO_ONE_PART)
    return held(narrowed(rescaled_longs<Shift>(x)));
#endif
    if constexpr (Shift > 32) {
        // The result fits; what rounding would carry out of 64 bits is held before it.
        const Longs rounded = each_part(
            [](Quads y) ZERKALO_INLINE_LAMBDA {
                constexpr std::int64_t kMost = kMostLong - kHalf;
                return (y > kMost ? Quads{} + kMost : y) + (sign_of(y) + kHalf);
            },
            x);
        return high_words(rounded) >> (Shift - 32);
    } else {
        const Longs rounded = each_part(
            [](Quads y) ZERKALO_INLINE_LAMBDA {
                return Quads(UnsignedQuads(y) + UnsignedQuads(sign_of(y) + kHalf));
            },
            x);
        const Words result = low_words(each_part(
            [](Quads y) ZERKALO_INLINE_LAMBDA { return Quads(UnsignedQuads(y) >> Shift); }, rounded));
        // Too large where the high word has more than Shift bits, and where rounding has reached 2^31.
        const Words high = high_words(x);
        const UnsignedWords above = UnsignedWords(high) + (1u << (Shift - 1));
        Words too_large = ~high & result;
        if constexpr (Shift < 32) too_large |= Words((above >> Shift) != 0);
        return held(where_negative(too_large, sign_of(high) ^ kMostWord, result));
    }
}

/// The same of words; a negative Shift multiplies.
template <int Shift>
ZERKALO_INLINE Words rescaled_words(Words x) {
    static_assert(Shift > -31 && Shift < 31 && Shift != 0 && Shift != 1);
    if constexpr (Shift > 0) {
        return (((x + sign_of(x)) >> (Shift - 1)) + 1) >> 1;
    } else {
        const Words result = Words(UnsignedWords(x) << -Shift);
        return held(where_negative(Words((result >> -Shift) != x), sign_of(x) ^ kMostWord, result));
    }
}
/// x 2^Up, which fits.
template <int Up>
ZERKALO_INLINE Longs raised_longs(Words x) {
    static_assert(Up >= 0 && Up <= 32);
    return each_part([](Quads y) ZERKALO_INLINE_LAMBDA { return Quads(UnsignedQuads(y) << Up); }, widened(x));
}

ZERKALO_INLINE UnsignedWords magnitude_of(Words x) {
    const Words sign = sign_of(x);
    return UnsignedWords((x ^ sign) - sign);
}
ZERKALO_INLINE UnsignedQuads magnitude_of(Quads x) {
    const Quads sign = sign_of(x);
    return UnsignedQuads((x ^ sign) - sign);
}

/// a / b to nearest, ties away from zero, held at the ends; of a / 0 the end of a's sign, of 0 / 0 the upper one.
ZERKALO_INLINE Words rounded_quotient(const Longs& a, Words b) {
    constexpr double kHeld = 0x1.fffffffbp+30;  // rounds to the largest word
    const auto whole = each_part([](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return double_of(x) / double_of_small(y); },
                                 a, widened(b));
    const Longs estimate = each_part([](Doubles q) ZERKALO_INLINE_LAMBDA { return nearest_in_low_words(q); }, whole);
    const Words fits = narrow_mask(each_part(
        [](Doubles q) ZERKALO_INLINE_LAMBDA { return Quads((q < kHeld) & (q > -kHeld)); }, whole));
    const Words q = low_words(estimate);
    // The rest is less than b; where nothing fits it means nothing.
    const Longs product = full_product(q, b);
    const Words rest = low_words(each_part(
        [](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return Quads(UnsignedQuads(x) - UnsignedQuads(y)); }, a, product));
    const Words sign = sign_of(high_words(a));
    // |rest / b| > 1/2, or = 1/2 and on the far side of q: 2 |rest| + 1 > |b| where the rest has a's sign.
    const UnsignedWords bound = (magnitude_of(b) + UnsignedWords(~sign_of(rest ^ sign))) >> 1;
    const Words step = Words(Words(magnitude_of(rest)) > Words(bound)) & (sign_of(rest ^ b) | 1);
    const Words end = sign_of(sign ^ b);
    return where_negative(fits, q + step, (end ^ kMostWord) - end);
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
    static_assert(Shift > 33 && Shift < 64);
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
ZERKALO_ONCE VectorInts<std::int32_t, kVectorWidth> long_quotient_words(const VectorInts<std::int64_t, kVectorWidth>& a,
                                                                        const VectorInts<std::int64_t, kVectorWidth>& b) {
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
