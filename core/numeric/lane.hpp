// Lanes of float: W values that one instruction works on. The only file that names the vendor library.
//
// Width 1 is a real width: `Real<1>` is float itself, and the free functions below exist for it too (one_lane.hpp).
// Float contract (equal bits everywhere): + - * / sqrt, compare, select and bit operations only. No fused multiply-add,
// no reciprocal estimates, no sums across lanes; min and max are compare and select.
#pragma once

#include "core/numeric/one_lane.hpp"

#if !defined(ZERKALO_INTEGERS_ONLY)
#include "core/numeric/native_order.hpp"

#include <xsimd/xsimd.hpp>
#if defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace zerkalo::inline ZERKALO_ISA {

template <int W>
struct ArchOf;
#if defined(__aarch64__)
template <>
struct ArchOf<4> { using type = xsimd::neon64; };
#elif defined(__SSE2__)
#if defined(__SSE4_2__)
template <>
struct ArchOf<4> { using type = xsimd::sse4_2; };
#else
template <>
struct ArchOf<4> { using type = xsimd::sse2; };
#endif
#if defined(__AVX2__)
template <>
struct ArchOf<8> { using type = xsimd::avx2; };
#endif
#if defined(__AVX512BW__) && defined(__AVX512DQ__)
template <>
struct ArchOf<16> { using type = xsimd::avx512bw; };
#endif
#endif

template <int W>
using FloatBatch = xsimd::batch<float, typename ArchOf<W>::type>;
template <int W>
using BitsBatch = xsimd::batch<std::uint32_t, typename ArchOf<W>::type>;

/// One boolean a lane.
template <int W>
struct LaneMask {
    using Batch = xsimd::batch_bool<float, typename ArchOf<W>::type>;
    Batch v;

    LaneMask() = default;
    ZERKALO_INLINE LaneMask(Batch b) : v(b) {}
    ZERKALO_INLINE LaneMask(bool uniform) : v(uniform) {}
    friend ZERKALO_INLINE LaneMask operator&(LaneMask a, LaneMask b) { return Batch(a.v & b.v); }
    friend ZERKALO_INLINE LaneMask operator|(LaneMask a, LaneMask b) { return Batch(a.v | b.v); }
    friend ZERKALO_INLINE LaneMask operator!(LaneMask a) { return Batch(~a.v); }
};

/// W floats. A float converts to all lanes alike.
template <int W>
struct Lanes {
    using Batch = FloatBatch<W>;
    Batch v;

    Lanes() = default;
    ZERKALO_INLINE Lanes(float uniform) : v(uniform) {}
    ZERKALO_INLINE explicit Lanes(Batch b) : v(b) {}
    friend ZERKALO_INLINE Lanes operator+(Lanes a, Lanes b) { return Lanes(Batch(a.v + b.v)); }
    friend ZERKALO_INLINE Lanes operator-(Lanes a, Lanes b) { return Lanes(Batch(a.v - b.v)); }
    friend ZERKALO_INLINE Lanes operator*(Lanes a, Lanes b) { return Lanes(Batch(a.v * b.v)); }
    friend ZERKALO_INLINE Lanes operator/(Lanes a, Lanes b) {
#if defined(__aarch64__)
        // The library refines an estimate here, off by an ulp or two; the instruction is exact.
        return Lanes(Batch(vdivq_f32(a.v, b.v)));
#else
        return Lanes(Batch(a.v / b.v));
#endif
    }
    friend ZERKALO_INLINE Lanes operator-(Lanes a) {
#if defined(__AVX512F__)
        // The library subtracts from zero here, and so makes +0 of +0.
        return flip_sign(a, Lanes(-1.0f));
#else
        return Lanes(Batch(-a.v));
#endif
    }
    friend ZERKALO_INLINE LaneMask<W> operator<(Lanes a, Lanes b) { return a.v < b.v; }
    friend ZERKALO_INLINE LaneMask<W> operator>(Lanes a, Lanes b) { return a.v > b.v; }
    friend ZERKALO_INLINE LaneMask<W> operator<=(Lanes a, Lanes b) { return a.v <= b.v; }
    friend ZERKALO_INLINE LaneMask<W> operator>=(Lanes a, Lanes b) { return a.v >= b.v; }
    friend ZERKALO_INLINE LaneMask<W> operator==(Lanes a, Lanes b) { return a.v == b.v; }
    /// True where either is NaN. The library's AVX and AVX-512 forms say false there.
    friend ZERKALO_INLINE LaneMask<W> operator!=(Lanes a, Lanes b) { return !(a == b); }
};

/// The bit patterns of W floats, or W unsigned integers; arithmetic wraps.
template <int W>
struct LaneBits {
    using Batch = BitsBatch<W>;
    Batch v;

    LaneBits() = default;
    ZERKALO_INLINE LaneBits(std::uint32_t uniform) : v(uniform) {}
    ZERKALO_INLINE explicit LaneBits(Batch b) : v(b) {}
    friend ZERKALO_INLINE LaneBits operator+(LaneBits a, LaneBits b) { return LaneBits(Batch(a.v + b.v)); }
    friend ZERKALO_INLINE LaneBits operator-(LaneBits a, LaneBits b) { return LaneBits(Batch(a.v - b.v)); }
    friend ZERKALO_INLINE LaneBits operator*(LaneBits a, LaneBits b) { return LaneBits(Batch(a.v * b.v)); }
    friend ZERKALO_INLINE LaneBits operator&(LaneBits a, LaneBits b) { return LaneBits(Batch(a.v & b.v)); }
    friend ZERKALO_INLINE LaneBits operator|(LaneBits a, LaneBits b) { return LaneBits(Batch(a.v | b.v)); }
    friend ZERKALO_INLINE LaneBits operator^(LaneBits a, LaneBits b) { return LaneBits(Batch(a.v ^ b.v)); }
    friend ZERKALO_INLINE LaneBits operator<<(LaneBits a, int n) { return LaneBits(Batch(a.v << n)); }
    friend ZERKALO_INLINE LaneBits operator>>(LaneBits a, int n) { return LaneBits(Batch(a.v >> n)); }
};

template <int W>
struct LaneTraits<Lanes<W>> {
    using Mask = LaneMask<W>;
    using Bits = LaneBits<W>;
    static constexpr int kWidth = W;
};
template <int W>
ZERKALO_INLINE bool any(LaneMask<W> m) { return xsimd::any(m.v); }
template <int W>
ZERKALO_INLINE bool all(LaneMask<W> m) { return xsimd::all(m.v); }
template <int W>
ZERKALO_INLINE bool none(LaneMask<W> m) { return !xsimd::any(m.v); }

/// Bit k is lane k.
template <int W>
ZERKALO_INLINE std::uint32_t bits_of(LaneMask<W> m) {
#if defined(__aarch64__)
    const uint32x4_t weights = {1, 2, 4, 8};
    return vaddvq_u32(vandq_u32(m.v, weights));
#else
    if constexpr (W == 4) {
        return static_cast<std::uint32_t>(_mm_movemask_ps(m.v));
    } else if constexpr (W == 8) {
#if defined(__AVX2__)
        return static_cast<std::uint32_t>(_mm256_movemask_ps(m.v));
#endif
    } else {
        return static_cast<std::uint32_t>(static_cast<typename LaneMask<W>::Batch::register_type>(m.v));
    }
#endif
}

template <int W>
ZERKALO_INLINE Lanes<W> select(LaneMask<W> m, Lanes<W> a, Lanes<W> b) { return Lanes<W>(xsimd::select(m.v, a.v, b.v)); }
template <int W>
ZERKALO_INLINE Lanes<W> select(LaneMask<W> m, Lanes<W> a, float b) { return select(m, a, Lanes<W>(b)); }
template <int W>
ZERKALO_INLINE Lanes<W> select(LaneMask<W> m, float a, Lanes<W> b) { return select(m, Lanes<W>(a), b); }
template <int W>
ZERKALO_INLINE LaneMask<W> select(LaneMask<W> m, LaneMask<W> a, LaneMask<W> b) { return (m & a) | ((!m) & b); }

template <int W>
ZERKALO_INLINE Lanes<W> sqrt(Lanes<W> a) {
#if defined(__aarch64__)
    return Lanes<W>(FloatBatch<W>(vsqrtq_f32(a.v)));
#else
    return Lanes<W>(xsimd::sqrt(a.v));
#endif
}

/// a < b ? a : b, so b where either is NaN.
template <int W>
ZERKALO_INLINE Lanes<W> min(Lanes<W> a, Lanes<W> b) {
    using Register = typename FloatBatch<W>::register_type;
    return Lanes<W>(FloatBatch<W>(native_min(Register(a.v), Register(b.v))));
}

/// a > b ? a : b, so b where either is NaN.
template <int W>
ZERKALO_INLINE Lanes<W> max(Lanes<W> a, Lanes<W> b) {
    using Register = typename FloatBatch<W>::register_type;
    return Lanes<W>(FloatBatch<W>(native_max(Register(a.v), Register(b.v))));
}
template <int W>
ZERKALO_INLINE Lanes<W> min(Lanes<W> a, float b) { return min(a, Lanes<W>(b)); }
template <int W>
ZERKALO_INLINE Lanes<W> max(Lanes<W> a, float b) { return max(a, Lanes<W>(b)); }

// Version 10 of the library and later name a cast's target by its element, earlier ones by its batch.
#if XSIMD_VERSION_MAJOR < 10
template <class Element, class Batch>
using CastTarget = Batch;
#else
template <class Element, class Batch>
using CastTarget = Element;
#endif
template <int W>
ZERKALO_INLINE LaneBits<W> to_bits(Lanes<W> a) {
    return LaneBits<W>(xsimd::bitwise_cast<CastTarget<std::uint32_t, BitsBatch<W>>>(a.v));
}
template <int W>
ZERKALO_INLINE Lanes<W> from_bits(LaneBits<W> a) {
    return Lanes<W>(xsimd::bitwise_cast<CastTarget<float, FloatBatch<W>>>(a.v));
}

template <int W>
ZERKALO_INLINE void store(float* target, Lanes<W> a) { a.v.store_unaligned(target); }

template <int W>
ZERKALO_INLINE float first_lane(Lanes<W> a) { return typename FloatBatch<W>::register_type(a.v)[0]; }

}  // namespace zerkalo::inline ZERKALO_ISA
#endif
