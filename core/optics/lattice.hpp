// Where the lobe rays of an unpolished mirror go: a Fibonacci lattice in lobe coordinates, rotated in azimuth only.
//
// Point i of N: u in the middle of share i of the lobe's energy (shares.hpp), azimuth = frac(i g), g the golden ratio's
// inverse. In a lobe cos^n the ray at u has cos(theta) = u^(1/(n+1)). The azimuth is periodic, so a rotation per pixel
// costs no accuracy and decorrelates neighbours. Any N. Every function is pure in (pixel, index). Frames that are
// rotations of one another (Settings::rotation) also move u within its share: their mean is the integral.
//
// Rotations come in four classes, one of each in every block of 2x2 pixels, in an order that a hash picks: the eye
// averages four lattices at once, and pixels of a class, whose rays run side by side, share packets.
// Source: Marques et al., "Spherical Fibonacci Point Sets for Illumination Integrals", CGF 32(8), 2013.
#pragma once

#include "core/numeric/elementary.hpp"
#include "core/numeric/double_elementary.hpp"
#include "core/numeric/fixed_elementary.hpp"
#include "core/optics/optics_data.hpp"
#include "core/optics/shares.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// A turn as a fraction -1/2..1/2 of itself, from a phase that wraps at 2^32.
template <class R>
ZERKALO_INLINE R turn_of_phase(Bits<R> phase) {
    if constexpr (std::same_as<R, double>) {
        return double(phase) * 0x1p-32 - 0.5;
    } else {
        // 23 bits become a float in [1, 2).
        return from_bits((phase >> 9) | Bits<R>(0x3f800000u)) - R(1.5f);
    }
}

/// The same as a phase of the system R: in fixed point the phase itself, half a turn on, as the float's is.
template <class R>
ZERKALO_INLINE Phase<R> phase_of(Bits<R> bits) {
    if constexpr (Formats<R>::kFixed) {
        return bits ^ Bits<R>(0x80000000u);
    } else {
        return turn_of_phase<Phase<R>>(bits);
    }
}

/// kWidth<R> phases of an array.
template <class R>
ZERKALO_INLINE Phase<R> load_phases(const Phase<Uniform<R>>* source) {
    if constexpr (Formats<R>::kFixed) {
        return load_bits<R>(source);
    } else {
        return load<R>(source);
    }
}

/// Well mixed bits of a 32-bit key. Source: Wellons, "Prospecting for Hash Functions" (lowbias32), 2018.
template <class B>
ZERKALO_INLINE B hash_bits(B key) {
    key = (key ^ (key >> 16)) * B(0x7feb352du);
    key = (key ^ (key >> 15)) * B(0x846ca68bu);
    return key ^ (key >> 16);
}

/// Rotation 0 is the lattice as it is; the others are independent of it and of each other.
ZERKALO_INLINE Sampling sampling_of(Estimator estimator, std::uint32_t rotation) {
    if (rotation == 0) return {estimator, 0, kShareSteps / 2};
    const auto step = static_cast<std::int32_t>(hash_bits(~rotation) >> 23);  // of kShareSteps, 2^9
    // Hashed twice: camera samples and paths are picked by sums with a hash of their number.
    return {estimator, hash_bits(hash_bits(rotation)), step | 1};
}

/// The two bits of the class of each pixel of an 8x8 tile; bit p of a mask is pixel p, row-major.
struct LatticeClasses {
    std::uint64_t low, high;
};

/// One bit of each block of 2x2 pixels (even bits, block rows of a byte) given to all four pixels of the block.
constexpr std::uint64_t pixels_of_blocks(std::uint32_t blocks) {
    std::uint64_t rows = (blocks & 0x55555555u) * 3ull;
    rows = (rows | rows << 16) & 0x0000ffff0000ffffull;
    rows = (rows | rows << 8) & 0x00ff00ff00ff00ffull;
    return rows | rows << 8;
}

/// A pixel's class: its corner in the block, turned by the block's two bits of the tile's hash.
constexpr LatticeClasses lattice_classes(std::uint32_t tile_hash) {
    constexpr std::uint64_t kRightColumns = 0xaaaaaaaaaaaaaaaaull, kLowerRows = 0xff00ff00ff00ff00ull;
    return {kRightColumns ^ pixels_of_blocks(tile_hash), kLowerRows ^ pixels_of_blocks(tile_hash >> 1)};
}

constexpr std::uint64_t pixels_of_class(const LatticeClasses& classes, int c) {
    return (c & 1 ? classes.low : ~classes.low) & (c & 2 ? classes.high : ~classes.high);
}
constexpr int class_of_pixel(const LatticeClasses& classes, int pixel) {
    return static_cast<int>(classes.low >> pixel & 1) | static_cast<int>(classes.high >> pixel & 1) << 1;
}

/// By how much of a turn a class is rotated.
ZERKALO_INLINE std::uint32_t phase_of_class(const Sampling& sampling, int lattice_class) {
    return hash_bits(1u) + sampling.turn + (static_cast<std::uint32_t>(lattice_class) << 30);
}
ZERKALO_INLINE float turn_of_class(const Sampling& sampling, int lattice_class) {
    return turn_of_phase<float>(phase_of_class(sampling, lattice_class));
}

/// The phase of point `index` of a part, before its class turns it.
template <class B>
ZERKALO_INLINE B phase_in_part(const LatticePart& part, B index) {
    return index * B(kGoldenTurn) + B(part.turn);
}

/// A fraction strictly between 0 and 1 of 23 bits: (k + 1/2) / 2^23.
template <class R>
ZERKALO_INLINE Fraction<R> fraction_of_bits(Bits<R> bits) {
    if constexpr (Formats<R>::kFixed) {
        return with_format<Fraction<R>::kFormat>(each_lane(
            [](std::uint32_t b) { return static_cast<std::int64_t>((std::uint64_t{b >> 9} * 2 + 1) << 36); }, bits));
    } else if constexpr (std::same_as<R, double>) {
        return (double(bits >> 9) + 0.5) * 0x1p-23;
    } else {
        return turn_of_phase<R>(bits) + R(0.5f + 0x1p-24f);
    }
}

/// A direction in the lobe's frame: `forward` along the axis, `side` and `up` across.
template <class R>
struct LobePoint {
    Direction<R> side, up, forward;
};

/// u in (0, 1): the share of the lobe's energy farther out than this point.
template <class R>
ZERKALO_INLINE LobePoint<R> lobe_point(R u, R turn, R inverse_exponent) {
    // 1 - cos(theta) = 1 - u^(1/(n+1)) without cancellation, so that a lobe of n = 1e9 keeps its width.
    const R e = log2_of(u, R(0)) * inverse_exponent;
    const auto narrow = e > R(-0.5f);
    const R from_axis = select(narrow, -exp2_minus_one(select(narrow, e, R(0))), R(1) - exp2(e));
    const R radius = sqrt(from_axis * (R(2) - from_axis));
    const SineCosine<R> azimuth = sincos_turn(turn);
    return {radius * azimuth.cosine, radius * azimuth.sine, R(1) - from_axis};
}

/// The part of a point that does not turn, in fixed point.
template <class R>
struct LobePolar {
    Direction<R> radius, forward;
};
template <class A, Format F, class B, Format FS>
ZERKALO_INLINE auto lobe_polar(Fixed<A, F> u, Fixed<B, FS> inverse_exponent) {
    using Part = decltype(one_minus_power(u, inverse_exponent));
    using N = Numbers<Part>;
    using D = Direction<N>;
    const Part from_axis = one_minus_power(u, inverse_exponent);
    const D radius = root<D>(product<Square<N>>(from_axis, Part(2) - from_axis));
    return LobePolar<N>{radius, D(1) - as<D>(from_axis)};
}
/// `turn` wraps.
template <class R, class P>
ZERKALO_INLINE auto at_azimuth(const LobePolar<R>& polar, P turn) {
    using N = std::conditional_t<kWidth<R> == 1, typename FixedNumbersOf<P>::type, R>;
    using D = Direction<N>;
    const SineCosine<D> azimuth = sincos_turn<D>(turn);
    return LobePoint<N>{as<D>(polar.radius * azimuth.cosine), as<D>(polar.radius * azimuth.sine), polar.forward};
}

/// The same in fixed point.
template <class A, Format F, class P, class B, Format FS>
ZERKALO_INLINE auto lobe_point(Fixed<A, F> u, P turn, Fixed<B, FS> inverse_exponent) {
    return at_azimuth(lobe_polar(u, inverse_exponent), turn);
}

/// Whole numbers below 2^23 as floats: the low bits of a float in [2^23, 2^24).
template <class R>
ZERKALO_INLINE R real_of_index(Bits<R> index) {
    return from_bits(index | Bits<R>(0x4b000000u)) - R(8388608.0f);
}

/// Points index, index + 1, ... of the `count` of a part, one a lane, before their class turns them.
template <class R>
ZERKALO_INLINE LobePoint<R> lattice_point(const LatticePart& part, Bits<R> index, std::int32_t count,
                                          R inverse_exponent) {
    const R n = R(float(count)), even = R(place_in_share(part, 0)), odd = R(place_in_share(part, 1));
    const EnergyShare<R> share = energy_share<R>(real_of_index<R>(index), n);
    const R place = even + (odd - even) * real_of_index<R>(index & Bits<R>(1u));
    const R u = (share.begin + share.size * place) / whole_lobe(n);
    return lobe_point(u, turn_of_phase<R>(phase_in_part(part, index)), inverse_exponent);
}

/// Point index, ... of `count` even points of the unit disc.
template <class R>
ZERKALO_INLINE LobePoint<R> disc_point(Bits<R> index, std::int32_t count) {
    constexpr float kInverseExponent = 0.5f;  // the lobe cos a, seen along its axis
    const R u = (real_of_index<R>(index) + R(0.5f)) / R(float(count));
    return lobe_point(u, turn_of_phase<R>(index * Bits<R>(kGoldenTurn)), R(kInverseExponent));
}

/// max-Phong: min(1, cos_i / cos_o), nothing from below.
template <class R>
ZERKALO_INLINE R lobe_weight(R cosine, R inverse_cosine_out) {
    return max(min(cosine * inverse_cosine_out, R(1)), R(0));
}

/// The same from the cosine of the way out itself.
template <class W>
ZERKALO_INLINE W lobe_weight_of(W cosine, W cosine_out) {
    if constexpr (Formats<W>::kFixed) {
        return max(min(quotient<W>(cosine, cosine_out), W(1)), W(0));
    } else {
        return lobe_weight(cosine, W(W(1) / cosine_out));
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
