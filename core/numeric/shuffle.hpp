// Lanes moved to other places, in the compilers' own vectors: the lane library has no such moves before version 9.
#pragma once

#include "core/numeric/lane.hpp"

#include <concepts>
#include <utility>

namespace zerkalo::inline ZERKALO_ISA {

/// From how many values pick() chooses; 0 where the instruction set has no such move.
template <class R>
constexpr int kPickable = std::same_as<Lanes<kWidth<R>>, R> && kWidth<R> >= 8 ? kWidth<R> : 0;

#if !defined(ZERKALO_INTEGERS_ONLY)
template <int n>
struct FloatVectorOf {
    using type __attribute__((vector_size(4 * n))) = float;
};
/// n floats as the compilers' vector; the same register as the intrinsics' and the lane library's.
template <int n>
using FloatVector = typename FloatVectorOf<n>::type;

template <int n>
ZERKALO_INLINE FloatVector<n> unaligned(const float* source) {
    FloatVector<n> a;
    __builtin_memcpy(&a, source, sizeof(a));
    return a;
}
template <int n>
ZERKALO_INLINE void set_unaligned(float* target, FloatVector<n> a) {
    __builtin_memcpy(target, &a, sizeof(a));
}

/// Lane k of the result is lane (k + distance) mod n of a.
template <int n, int distance, std::size_t... k>
ZERKALO_INLINE FloatVector<n> turned(FloatVector<n> a, std::index_sequence<k...>) {
    return __builtin_shufflevector(a, a, ((int(k) + distance) % n)...);
}

/// The largest lane, in log2(n) steps. No NaN.
template <int n, int distance = n / 2>
ZERKALO_INLINE float largest_of(FloatVector<n> a) {
    const FloatVector<n> b = turned<n, distance>(a, std::make_index_sequence<n>{});
    const FloatVector<n> larger = a > b ? a : b;
    if constexpr (distance == 1) {
        return larger[0];
    } else {
        return largest_of<n, distance / 2>(larger);
    }
}

ZERKALO_INLINE float largest_lane(float a) { return a; }

/// No NaN. For decisions about whole packets only: no lane's value may depend on another's.
template <int W>
ZERKALO_INLINE float largest_lane(Lanes<W> a) {
    return largest_of<W>(typename FloatBatch<W>::register_type(a.v));
}

/// table[index] of each lane. Index: a whole number below kPickable<R>; the table holds kPickable<R> values.
template <class R>
ZERKALO_INLINE R pick(const float* table, R index) {
    if constexpr (kPickable<R> > 0) {
        using Register = typename R::Batch::register_type;
        return R(typename R::Batch(native_pick(Register(load<R>(table).v), Register(index.v))));
    } else {
        return index;
    }
}

/// source[index[k]] of each lane k.
template <class R>
ZERKALO_INLINE R gather(const float* source, const std::uint8_t* index) {
#if defined(__AVX2__)
    if constexpr (kWidth<R> == 8) return R(typename R::Batch(native_gather_8(source, index)));
#endif
#if defined(__AVX512F__)
    if constexpr (kWidth<R> == 16) return R(typename R::Batch(native_gather_16(source, index)));
#endif
    alignas(64) float lanes[kWidth<R>];
    for (int lane = 0; lane < kWidth<R>; ++lane) lanes[lane] = source[index[lane]];
    return load<R>(lanes);
}

/// Of the three vectors that hold n interleaved triples, the one whose lane k belongs to the given channel.
constexpr int triple_vector(int n, int channel, int k) {
    int j = 0;
    while ((n * j + k) % 3 != channel) ++j;
    return j;
}

/// Channel values moved to the lanes that they have in whichever of the three vectors holds them. n is no multiple of
/// 3, so each lane serves each channel in exactly one of the vectors.
template <int n, int channel, std::size_t... k>
ZERKALO_INLINE FloatVector<n> placed(FloatVector<n> a, std::index_sequence<k...>) {
    return __builtin_shufflevector(a, a, ((n * triple_vector(n, channel, int(k)) + int(k)) / 3)...);
}

/// Vector j of the triples: each lane from the channel that it belongs to.
template <int n, int j, std::size_t... k>
ZERKALO_INLINE FloatVector<n> merged(FloatVector<n> r, FloatVector<n> g, FloatVector<n> b, std::index_sequence<k...>) {
    const FloatVector<n> rg = __builtin_shufflevector(r, g, ((n * j + int(k)) % 3 == 1 ? n + int(k) : int(k))...);
    return __builtin_shufflevector(rg, b, ((n * j + int(k)) % 3 == 2 ? n + int(k) : int(k))...);
}

/// Stores n triples r0 g0 b0 r1 g1 b1 ... from three channels. All unaligned.
template <int n>
ZERKALO_INLINE void store_triples(float* out, const float* r, const float* g, const float* b) {
    constexpr auto lanes = std::make_index_sequence<n>{};
    const FloatVector<n> x = placed<n, 0>(unaligned<n>(r), lanes);
    const FloatVector<n> y = placed<n, 1>(unaligned<n>(g), lanes);
    const FloatVector<n> z = placed<n, 2>(unaligned<n>(b), lanes);
    set_unaligned<n>(out, merged<n, 0>(x, y, z, lanes));
    set_unaligned<n>(out + n, merged<n, 1>(x, y, z, lanes));
    set_unaligned<n>(out + 2 * n, merged<n, 2>(x, y, z, lanes));
}
#endif

}  // namespace zerkalo::inline ZERKALO_ISA
