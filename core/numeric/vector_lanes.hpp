// The integer operations of fixed_lanes.hpp on lanes in vector registers: sums, comparisons, changes of format. They
// give the same integers, lane by lane. What has no form here or in vector_quotients.hpp is done one lane after the
// other, by each_lane().
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
    ZERKALO_INLINE std::int64_t lane(int k) const { return k & 1 ? v.odd[k >> 1] : v.even[k >> 1]; }
    ZERKALO_INLINE void set_lane(int k, std::int64_t x) { (k & 1 ? v.odd : v.even)[k >> 1] = x; }
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
ZERKALO_INLINE Words held(Words x) { return larger(x, all_words(-kMostWord)); }
ZERKALO_INLINE Quads held(Quads x) { return x - Quads(x == -kMostLong - 1); }

ZERKALO_INLINE Words negative(Words a) { return -a; }
ZERKALO_INLINE Longs negative(const Longs& a) {
    return each_part([](Quads x) ZERKALO_INLINE_LAMBDA { return -x; }, a);
}

// a + b and a - b, held at the ends of the type. Where the sum modulo 2^n has left the range, both terms have a sign
// that it has not.
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

// a + b and a - b that fit. (What lies in lanes that mean nothing may wrap.)
ZERKALO_INLINE Words fitting_sum(Words a, Words b) { return Words(UnsignedWords(a) + UnsignedWords(b)); }
ZERKALO_INLINE Words fitting_difference(Words a, Words b) { return Words(UnsignedWords(a) - UnsignedWords(b)); }
ZERKALO_INLINE Longs fitting_sum(const Longs& a, const Longs& b) {
    return each_part(
        [](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return Quads(UnsignedQuads(x) + UnsignedQuads(y)); }, a, b);
}
ZERKALO_INLINE Longs fitting_difference(const Longs& a, const Longs& b) {
    return each_part(
        [](Quads x, Quads y) ZERKALO_INLINE_LAMBDA { return Quads(UnsignedQuads(x) - UnsignedQuads(y)); }, a, b);
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
    if constexpr (Shift > 32) {
        // The result fits. Halves are added last, where there is room for them.
        const Longs down = each_part([](Quads y) ZERKALO_INLINE_LAMBDA { return y + sign_of(y); }, x);
        const Words twice = high_words(down) >> (Shift - 33);
        return (twice >> 1) + (twice & 1);
    } else {
        return low_words(each_part(
            [](Quads y) ZERKALO_INLINE_LAMBDA {
                constexpr std::int64_t kMost = std::int64_t{kMostWord} << Shift;
                const Quads below = y > kMost ? Quads{} + kMost : y;
                const Quads within = below < -kMost ? Quads{} - kMost : below;
                return Quads(UnsignedQuads(within + (sign_of(within) + kHalf)) >> Shift);
            },
            x));
    }
}

/// The same of numbers that fit.
template <int Shift>
ZERKALO_INLINE Words rounded_words(const Longs& x) {
    static_assert(Shift > 1 && Shift < 63);
    // A half less for a negative number: its ties go down.
    const Longs sum = each_part(
        [](Quads y) ZERKALO_INLINE_LAMBDA {
            return Quads(UnsignedQuads(y) + (std::uint64_t{1} << (Shift - 1)) - (UnsignedQuads(y) >> 63));
        },
        x);
    if constexpr (Shift > 32) {
        return high_words(sum) >> (Shift - 32);
    } else {
        return alternating(Words(UnsignedQuads(sum.even) >> Shift), Words(UnsignedQuads(sum.odd) << (32 - Shift)));
    }
}

/// As rescaled_words(); of words, and a negative Shift multiplies.
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

}  // namespace zerkalo::inline ZERKALO_ISA
#endif
