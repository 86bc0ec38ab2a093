// One lane of float, width 1 of lane.hpp: a real width, and what all widths share. One lane of double, which has no
// wider form.
//
// The serial renderer that one steps through in a debugger is the SIMD renderer at width 1. It names no vector library,
// so that the fixed-point kernel can be built for processors without vector and float units (ZERKALO_INTEGERS_ONLY).
#pragma once

#include "core/numeric/isa.hpp"

#include <bit>
#include <cstdint>

namespace zerkalo::inline ZERKALO_ISA {

/// W > 1 floats: lane.hpp.
template <int W>
struct Lanes;

template <class R>
struct LaneTraits;
template <>
struct LaneTraits<float> {
    using Mask = bool;
    using Bits = std::uint32_t;
    static constexpr int kWidth = 1;
};
/// `Bits` are those of phases and hashes, 32 as in every other lane; to_bits() of a double gives 64.
template <>
struct LaneTraits<double> {
    using Mask = bool;
    using Bits = std::uint32_t;
    static constexpr int kWidth = 1;
};
template <int W>
struct RealOf { using type = Lanes<W>; };
template <>
struct RealOf<1> { using type = float; };

/// W floats: float itself at width 1.
template <int W>
using Real = typename RealOf<W>::type;
template <class R>
using Mask = typename LaneTraits<R>::Mask;
template <class R>
using Bits = typename LaneTraits<R>::Bits;
template <class R>
constexpr int kWidth = LaneTraits<R>::kWidth;

ZERKALO_INLINE bool any(bool m) { return m; }
ZERKALO_INLINE bool all(bool m) { return m; }
ZERKALO_INLINE bool none(bool m) { return !m; }
ZERKALO_INLINE std::uint32_t bits_of(bool m) { return m ? 1u : 0u; }
ZERKALO_INLINE float select(bool m, float a, float b) { return m ? a : b; }
ZERKALO_INLINE bool select(bool m, bool a, bool b) { return m ? a : b; }
ZERKALO_INLINE float sqrt(float a) { return __builtin_sqrtf(a); }
ZERKALO_INLINE float min(float a, float b) { return a < b ? a : b; }
ZERKALO_INLINE float max(float a, float b) { return a > b ? a : b; }
ZERKALO_INLINE std::uint32_t to_bits(float a) { return std::bit_cast<std::uint32_t>(a); }
ZERKALO_INLINE float from_bits(std::uint32_t a) { return std::bit_cast<float>(a); }

ZERKALO_INLINE double select(bool m, double a, double b) { return m ? a : b; }
ZERKALO_INLINE double sqrt(double a) { return __builtin_sqrt(a); }
ZERKALO_INLINE double min(double a, double b) { return a < b ? a : b; }
ZERKALO_INLINE double max(double a, double b) { return a > b ? a : b; }
ZERKALO_INLINE std::uint64_t to_bits(double a) { return std::bit_cast<std::uint64_t>(a); }
ZERKALO_INLINE double from_bits(std::uint64_t a) { return std::bit_cast<double>(a); }

/// Unaligned: `source` holds kWidth<R> floats.
template <class R>
ZERKALO_INLINE R load(const float* source) {
    if constexpr (kWidth<R> == 1) {
        return *source;
    } else {
        return R(R::Batch::load_unaligned(source));
    }
}
ZERKALO_INLINE void store(float* target, float a) { *target = a; }
template <class R>
ZERKALO_INLINE R load(const double* source) { return *source; }
ZERKALO_INLINE void store(double* target, double a) { *target = a; }
template <class R>
ZERKALO_INLINE Bits<R> load_bits(const std::uint32_t* source) {
    if constexpr (kWidth<R> == 1) {
        return *source;
    } else {
        return Bits<R>(Bits<R>::Batch::load_unaligned(source));
    }
}

/// The same bits with the sign flipped where `sign` is negative (also -0).
template <class R>
ZERKALO_INLINE R flip_sign(R a, R sign) {
    return from_bits(to_bits(a) ^ (to_bits(sign) & Bits<R>(0x80000000u)));
}
/// The sign bit of -a.
template <class R>
ZERKALO_INLINE Bits<R> opposite_sign(R a) {
    return (to_bits(a) & Bits<R>(0x80000000u)) ^ Bits<R>(0x80000000u);
}
template <class R>
ZERKALO_INLINE R absolute(R a) {
    return from_bits(to_bits(a) & Bits<R>(0x7fffffffu));
}

constexpr std::uint64_t kSignOfDouble = std::uint64_t{1} << 63;
ZERKALO_INLINE double flip_sign(double a, double sign) {
    return from_bits(to_bits(a) ^ (to_bits(sign) & kSignOfDouble));
}
ZERKALO_INLINE std::uint64_t opposite_sign(double a) { return (to_bits(a) & kSignOfDouble) ^ kSignOfDouble; }
ZERKALO_INLINE double absolute(double a) { return from_bits(to_bits(a) & ~kSignOfDouble); }

ZERKALO_INLINE float first_lane(float a) { return a; }
/// Number of lanes set in the mask.
template <class M>
ZERKALO_INLINE std::uint32_t count_of(M mask) {
    const std::uint32_t bits = bits_of(mask);
#if defined(__POPCNT__)
    return static_cast<std::uint32_t>(__builtin_popcount(bits));
#else
    // Widths without a population count have at most four lanes: sixteen answers of four bits each.
    return static_cast<std::uint32_t>(0x4332322132212110u >> (4 * bits)) & 15u;
#endif
}

}  // namespace zerkalo::inline ZERKALO_ISA
