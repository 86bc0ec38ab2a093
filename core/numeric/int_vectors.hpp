// Lanes of integers in the vector registers, by the compilers' own vector types: the moves between 32 and 64 bits, the
// widening product, and the float unit's division and root. The only file of fixed point that names instructions.
//
// W numbers of 32 bits fill a register, of 64 bits two, the even and the odd lanes: so the widening product of x86
// takes and gives them, and a change of width is a shift and a blend.
#pragma once

#include "core/numeric/fixed_lanes.hpp"

#if !defined(ZERKALO_INTEGERS_ONLY) && (defined(__SSE4_2__) || defined(__aarch64__))
#define ZERKALO_INT_VECTORS

#if defined(__aarch64__)
#include <arm_neon.h>
#else
#include <immintrin.h>
#endif

namespace zerkalo::inline ZERKALO_ISA {

template <class T, int n>
struct VectorOf {
    using type __attribute__((vector_size(n * sizeof(T)))) = T;
};
template <class T, int n>
using Vector = typename VectorOf<T, n>::type;

#if defined(__AVX512DQ__) && ZERKALO_WIDTH == 16
#define ZERKALO_512_BITS
constexpr int kVectorWidth = 16;
#elif defined(__AVX2__)
constexpr int kVectorWidth = 8;
#else
constexpr int kVectorWidth = 4;
#endif
constexpr int kPartLanes = kVectorWidth / 2;

using Words = Vector<std::int32_t, kVectorWidth>;
using UnsignedWords = Vector<std::uint32_t, kVectorWidth>;
using Quads = Vector<std::int64_t, kPartLanes>;
using UnsignedQuads = Vector<std::uint64_t, kPartLanes>;
using Doubles = Vector<double, kPartLanes>;

/// The registers of one number of 64 bits a lane: the even lanes and the odd ones.
template <class V>
struct PartsOf { V even, odd; };
using Longs = PartsOf<Quads>;
using UnsignedLongs = PartsOf<UnsignedQuads>;
using DoubleParts = PartsOf<Doubles>;

/// The same function of each register.
template <class F, class... X>
ZERKALO_INLINE auto each_part(F f, const X&... x) {
    return PartsOf<decltype(f(x.even...))>{f(x.even...), f(x.odd...)};
}

ZERKALO_INLINE Words all_words(std::int32_t x) { return Words{} + x; }
ZERKALO_INLINE Longs all_longs(std::int64_t x) {
    return each_part([x](Quads zero) ZERKALO_INLINE_LAMBDA { return zero + x; }, Longs{});
}

// What no expression of vectors gives, by instruction set:
//     low_product      the product of the low words of each lane, exactly, with a sign or without
//     square_root      correctly rounded
//     where_negative   a where the sign of m is set, b elsewhere
//     signs_of         bit k is the sign of lane k
//     larger           of two words
#if defined(__aarch64__)
ZERKALO_INLINE Quads low_product(Quads a, Quads b) { return Quads(vmull_s32(vmovn_s64(a), vmovn_s64(b))); }
ZERKALO_INLINE UnsignedQuads low_product(UnsignedQuads a, UnsignedQuads b) {
    return UnsignedQuads(vmull_u32(vmovn_u64(a), vmovn_u64(b)));
}
ZERKALO_INLINE Doubles square_root(Doubles a) { return Doubles(vsqrtq_f64(a)); }
ZERKALO_INLINE Words larger(Words a, Words b) { return Words(vmaxq_s32(a, b)); }
ZERKALO_INLINE Words where_negative(Words m, Words a, Words b) { return m < 0 ? a : b; }
ZERKALO_INLINE Quads where_negative(Quads m, Quads a, Quads b) { return m < 0 ? a : b; }
ZERKALO_INLINE std::uint32_t signs_of(Words m) {
    const uint32x4_t weights = {1, 2, 4, 8};
    return vaddvq_u32(vandq_u32(uint32x4_t(m < 0), weights));
}
#elif defined(ZERKALO_512_BITS)
ZERKALO_INLINE Quads low_product(Quads a, Quads b) { return Quads(_mm512_mul_epi32(__m512i(a), __m512i(b))); }
ZERKALO_INLINE UnsignedQuads low_product(UnsignedQuads a, UnsignedQuads b) {
    return UnsignedQuads(_mm512_mul_epu32(__m512i(a), __m512i(b)));
}
ZERKALO_INLINE Doubles square_root(Doubles a) { return Doubles(_mm512_sqrt_pd(__m512d(a))); }
ZERKALO_INLINE Words larger(Words a, Words b) { return Words(_mm512_max_epi32(__m512i(a), __m512i(b))); }
ZERKALO_INLINE Words where_negative(Words m, Words a, Words b) {
    return Words(_mm512_mask_blend_epi32(_mm512_movepi32_mask(__m512i(m)), __m512i(b), __m512i(a)));
}
ZERKALO_INLINE Quads where_negative(Quads m, Quads a, Quads b) {
    return Quads(_mm512_mask_blend_epi64(_mm512_movepi64_mask(__m512i(m)), __m512i(b), __m512i(a)));
}
ZERKALO_INLINE std::uint32_t signs_of(Words m) { return _mm512_movepi32_mask(__m512i(m)); }
#elif defined(__AVX2__)
ZERKALO_INLINE Quads low_product(Quads a, Quads b) { return Quads(_mm256_mul_epi32(__m256i(a), __m256i(b))); }
ZERKALO_INLINE UnsignedQuads low_product(UnsignedQuads a, UnsignedQuads b) {
    return UnsignedQuads(_mm256_mul_epu32(__m256i(a), __m256i(b)));
}
ZERKALO_INLINE Doubles square_root(Doubles a) { return Doubles(_mm256_sqrt_pd(__m256d(a))); }
ZERKALO_INLINE Words larger(Words a, Words b) { return Words(_mm256_max_epi32(__m256i(a), __m256i(b))); }
ZERKALO_INLINE Words where_negative(Words m, Words a, Words b) {
    return Words(_mm256_blendv_ps(__m256(b), __m256(a), __m256(m)));
}
ZERKALO_INLINE Quads where_negative(Quads m, Quads a, Quads b) {
    return Quads(_mm256_blendv_pd(__m256d(b), __m256d(a), __m256d(m)));
}
ZERKALO_INLINE std::uint32_t signs_of(Words m) { return static_cast<std::uint32_t>(_mm256_movemask_ps(__m256(m))); }
#else
ZERKALO_INLINE Quads low_product(Quads a, Quads b) { return Quads(_mm_mul_epi32(__m128i(a), __m128i(b))); }
ZERKALO_INLINE UnsignedQuads low_product(UnsignedQuads a, UnsignedQuads b) {
    return UnsignedQuads(_mm_mul_epu32(__m128i(a), __m128i(b)));
}
ZERKALO_INLINE Doubles square_root(Doubles a) { return Doubles(_mm_sqrt_pd(__m128d(a))); }
ZERKALO_INLINE Words larger(Words a, Words b) { return Words(_mm_max_epi32(__m128i(a), __m128i(b))); }
ZERKALO_INLINE Words where_negative(Words m, Words a, Words b) {
    return Words(_mm_blendv_ps(__m128(b), __m128(a), __m128(m)));
}
ZERKALO_INLINE Quads where_negative(Quads m, Quads a, Quads b) {
    return Quads(_mm_blendv_pd(__m128d(b), __m128d(a), __m128d(m)));
}
ZERKALO_INLINE std::uint32_t signs_of(Words m) { return static_cast<std::uint32_t>(_mm_movemask_ps(__m128(m))); }
#endif

/// Even lanes of a, odd lanes of b.
ZERKALO_INLINE Words alternating(Words a, Words b) {
#if defined(ZERKALO_512_BITS)
    return __builtin_shufflevector(a, b, 0, 17, 2, 19, 4, 21, 6, 23, 8, 25, 10, 27, 12, 29, 14, 31);
#elif defined(__AVX2__)
    return __builtin_shufflevector(a, b, 0, 9, 2, 11, 4, 13, 6, 15);
#else
    return __builtin_shufflevector(a, b, 0, 5, 2, 7);
#endif
}

/// Of even lanes and odd ones as they follow each other.
template <class Half>
ZERKALO_INLINE auto one_after_the_other(Half even, Half odd) {
#if defined(ZERKALO_512_BITS)
    return __builtin_shufflevector(even, odd, 0, 8, 1, 9, 2, 10, 3, 11, 4, 12, 5, 13, 6, 14, 7, 15);
#elif defined(__AVX2__)
    return __builtin_shufflevector(even, odd, 0, 4, 1, 5, 2, 6, 3, 7);
#else
    return __builtin_shufflevector(even, odd, 0, 2, 1, 3);
#endif
}

/// The odd lanes, each in the low word of its pair; what is above them means nothing. A shift on x86 would hide from
/// clang 14 that a product of such words takes one instruction.
ZERKALO_INLINE Quads odd_words(Words x) {
#if defined(__aarch64__)
    return Quads(UnsignedQuads(x) >> 32);
#elif defined(ZERKALO_512_BITS)
    return Quads(__builtin_shufflevector(x, x, 1, 1, 3, 3, 5, 5, 7, 7, 9, 9, 11, 11, 13, 13, 15, 15));
#elif defined(__AVX2__)
    return Quads(__builtin_shufflevector(x, x, 1, 1, 3, 3, 5, 5, 7, 7));
#else
    return Quads(__builtin_shufflevector(x, x, 1, 1, 3, 3));
#endif
}

/// All bits set where x < 0.
ZERKALO_INLINE Words sign_of(Words x) { return x >> 31; }
ZERKALO_INLINE Quads sign_of(Quads x) {
#if defined(__AVX512VL__) || defined(__aarch64__)
    return x >> 63;
#else
    return Quads(Quads{} > x);
#endif
}

/// x / 2^n, rounded down: AVX2 and before have no such shift.
template <int n>
ZERKALO_INLINE Quads shifted_right(Quads x) {
    static_assert(n > 0 && n < 64);
#if defined(__AVX512VL__) || defined(__aarch64__)
    return x >> n;
#else
    return Quads(UnsignedQuads(x) >> n) | Quads(UnsignedQuads(sign_of(x)) << (64 - n));
#endif
}

// Between lanes of 32 and of 64 bits. widened: with the sign; widened_unsigned: without; low_words, high_words: half of
// each lane; narrow_mask, wide_mask: all bits of a lane alike; full_product: a b, exactly.
ZERKALO_INLINE Longs widened(Words x) {
    const Words sign = sign_of(x);
    return {Quads(alternating(x, Words(UnsignedQuads(sign) << 32))),
            Quads(alternating(Words(UnsignedQuads(x) >> 32), sign))};
}
ZERKALO_INLINE UnsignedLongs widened_unsigned(UnsignedWords x) {
    return {UnsignedQuads(x) & 0xffffffffu, UnsignedQuads(x) >> 32};
}
ZERKALO_INLINE Words low_words(const Longs& x) {
    return alternating(Words(x.even), Words(UnsignedQuads(x.odd) << 32));
}
ZERKALO_INLINE Words high_words(const Longs& x) {
    return alternating(Words(UnsignedQuads(x.even) >> 32), Words(x.odd));
}
ZERKALO_INLINE Words narrow_mask(const Longs& m) { return alternating(Words(m.even), Words(m.odd)); }
ZERKALO_INLINE Longs wide_mask(Words m) {
    return {Quads(alternating(m, Words(UnsignedQuads(m) << 32))), Quads(alternating(Words(UnsignedQuads(m) >> 32), m))};
}
ZERKALO_INLINE Longs full_product(Words a, Words b) {
    return {low_product(Quads(a), Quads(b)), low_product(odd_words(a), odd_words(b))};
}
ZERKALO_INLINE Longs full_product(Words a, std::int32_t b) {
    const Quads same = Quads(all_words(b));
    return {low_product(Quads(a), same), low_product(odd_words(a), same)};
}
ZERKALO_INLINE Longs full_product(std::int32_t a, Words b) { return full_product(b, a); }

/// Into memory and from there as the registers are: the even lanes, then the odd ones (place_of_long).
ZERKALO_INLINE void store_longs(std::int64_t* target, const Longs& x) { __builtin_memcpy(target, &x, sizeof x); }
ZERKALO_INLINE Longs load_longs(const std::int64_t* source) {
    Longs x;
    __builtin_memcpy(&x, source, sizeof x);
    return x;
}

// To doubles, to nearest: of numbers >= 0, of any, and of those below 2^51.
#if defined(__AVX512DQ__) || defined(__aarch64__)
ZERKALO_INLINE Doubles double_of(UnsignedQuads x) { return __builtin_convertvector(x, Doubles); }
ZERKALO_INLINE Doubles double_of(Quads x) { return __builtin_convertvector(x, Doubles); }
ZERKALO_INLINE Doubles double_of_small(Quads x) { return double_of(x); }
#else
ZERKALO_INLINE Doubles double_of(UnsignedQuads x) {
    // Halves of 32 bits become the low bits of doubles near 2^84 and 2^52, and one sum rounds.
    const Doubles high = Doubles((x >> 32) | 0x4530000000000000u) - (0x1p84 + 0x1p52);
    return high + Doubles((x & 0xffffffffu) | 0x4330000000000000u);
}
ZERKALO_INLINE Doubles double_of(Quads x) {
    // As above, of x + 2^63.
    const UnsignedQuads above = UnsignedQuads(x) ^ 0x8000000000000000u;
    const Doubles high = Doubles((above >> 32) | 0x4530000000000000u) - (0x1p84 + 0x1p63 + 0x1p52);
    return high + Doubles((above & 0xffffffffu) | 0x4330000000000000u);
}
ZERKALO_INLINE Doubles double_of_small(Quads x) { return Doubles(x + 0x4338000000000000) - 0x1.8p52; }
#endif
/// The doubles of words.
ZERKALO_INLINE DoubleParts doubles_of(Words x) {
    // x + 2^31 as the low words of doubles near 2^52.
    const Words above = x ^ Words(all_words(std::numeric_limits<std::int32_t>::min())), near = all_words(0x43300000);
    const Words odd = Words(UnsignedQuads(above) >> 32);
    return {Doubles(alternating(above, near)) - (0x1p52 + 0x1p31), Doubles(alternating(odd, near)) - (0x1p52 + 0x1p31)};
}
ZERKALO_INLINE DoubleParts doubles_of(std::int32_t x) { return {Doubles{} + double(x), Doubles{} + double(x)}; }
/// The integer nearest to x, |x| < 2^31, in the low words; what is above them means nothing.
ZERKALO_INLINE Quads nearest_in_low_words(Doubles x) { return Quads(x + 0x1.8p52); }

}  // namespace zerkalo::inline ZERKALO_ISA
#endif
