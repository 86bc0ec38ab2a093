// The other rules by which lobe rays are placed: sets of points in the unit square, one coordinate the share u of the
// lobe's energy that lies farther out, the other the azimuth.
//
//     random    independent points: Monte Carlo
//     jittered  one point in each of N cells of equal area: ceil(sqrt N) rings of u, as many cells in each, or one more
//     sobol     the first two dimensions of Sobol's sequence, Owen-scrambled: a (0,2)-net wherever N is a power of two
//     r2        steps by 1/p and 1/p^2 of a turn, p^3 = p + 1, from a random start
//
// The pixels of a tile share one set, picked by a key: tiles, camera samples and rotations are independent. The lattice
// classes of a tile (lattice.hpp) turn it, and the odd ones move each point half-way along u, or along its cell: the
// errors of neighbours tend to cancel, and no tile stands out. Integers make each point; in float u and azimuth keep 23
// bits. u lies in 2^-24 .. 1 - 2^-24.
// Sources: Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020, with the permutation of Laine and Karras,
// "Stratified Sampling for Stochastic Transparency", CGF 30(4), 2011; Roberts, "The Unreasonable Effectiveness of
// Quasirandom Sequences", 2018; cells of equal area: Mitchell, "Consequences of Stratified Sampling", SIGGRAPH 1996.
#pragma once

#include "core/numeric/integer_root.hpp"
#include "core/optics/lattice.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Where in the lobe a ray goes: lobe_point() gives its direction.
template <class R>
struct SetPoint {
    Fraction<R> u;
    Phase<R> turn;
};

/// Which of a rule's sets: a tile's key, and 2^31 for the classes that move half-way along u, else 0.
template <class B>
struct SetChoice {
    B key, half;
};

ZERKALO_INLINE SetChoice<std::uint32_t> set_of_class(const Sampling& sampling, std::uint32_t tile_hash,
                                                     int lattice_class, std::uint32_t camera_sample) {
    // Hashed twice, for tile_hash and turn are hashes of small numbers too: sums of equals would meet.
    const std::uint32_t place = hash_bits(hash_bits(sampling.turn ^ (camera_sample + 1)));
    return {hash_bits(tile_hash ^ place), static_cast<std::uint32_t>(lattice_class) << 31};
}

/// A key for the azimuth, as good as independent of the one for u.
template <class B>
ZERKALO_INLINE B second_key(B key) {
    return hash_bits(key + B(kGoldenTurn));
}

template <class R>
ZERKALO_INLINE SetPoint<R> random_point(Bits<R> index, const SetChoice<Bits<R>>& set) {
    const Bits<R> one = hash_bits(set.key ^ index);
    return {fraction_of_bits<R>(one ^ set.half), phase_of<R>(second_key(one))};
}

/// The rings of `count` cells: the first `wider` of them hold cells + 1, the others `cells`.
struct Rings {
    std::int32_t cells, wider;
};
ZERKALO_INLINE Rings rings_of(std::int32_t count) {
    auto rings = static_cast<std::int32_t>(nearest_root_of(static_cast<std::uint64_t>(count)));
    if (rings * rings < count) ++rings;
    return {count / rings, count % rings};
}

/// Cell `index`: its ring begins at cell `start` and has `cells` of them; u = (start + cells a) / N and the turn
/// (index - start + b) / cells are uniform in it.
template <class R>
ZERKALO_INLINE SetPoint<R> jittered_point(Bits<R> index, std::int32_t count, const SetChoice<Bits<R>>& set) {
    const Rings rings = rings_of(count);
    const std::int32_t in_wider = rings.wider * (rings.cells + 1);
    const Bits<R> random = hash_bits(set.key ^ index), one = random ^ set.half, two = second_key(random);
    if constexpr (Formats<R>::kFixed) {
        const auto start_of = [=](std::uint32_t i) {
            const auto at = static_cast<std::int32_t>(i);
            return at < in_wider ? at - at % (rings.cells + 1) : at - (at - in_wider) % rings.cells;
        };
        const auto cells_at = [=](std::uint32_t i) {
            return std::int64_t{rings.cells} + (static_cast<std::int32_t>(i) < in_wider ? 1 : 0);
        };
        constexpr int kMiddle = 1 << 8;  // of the last place that float keeps
        const auto share = [=](std::uint32_t i, std::uint32_t a) {
            const std::int64_t way = (std::int64_t{start_of(i)} << 32) + cells_at(i) * ((a & ~511u) + kMiddle);
            const std::int64_t u = rounded_quotient<std::int64_t, 8>(way, count) << 20;
            constexpr std::int64_t kLeast = std::int64_t{1} << 36, kMost = (std::int64_t{1} << 60) - kLeast;
            return u < kLeast ? kLeast : u < kMost ? u : kMost;
        };
        const auto turn = [=](std::uint32_t i, std::uint32_t b) {
            const std::int64_t at = static_cast<std::int64_t>(i) - start_of(i);
            return static_cast<std::uint32_t>(((at << 32) + ((b & ~511u) + kMiddle)) / cells_at(i)) ^ 0x80000000u;
        };
        return {with_format<Fraction<R>::kFormat>(each_lane(share, index, one)), each_lane(turn, index, two)};
    } else {
        constexpr auto kWhole = kToWhole<UniformReal<R>>;
        // Exact for index < 2^23: the low bits of a float in [2^23, 2^24).
        const R i = from_bits(index | Bits<R>(0x4b000000u)) - R(8388608.0f);
        const auto in_narrow = i >= R(float(in_wider));
        const R cells = R(float(rings.cells + 1)) - select(in_narrow, R(1), R(0));
        const R first = select(in_narrow, R(float(in_wider)), R(0));
        const R ring = (((i - first) + R(0.5f)) / cells - R(0.5f) + R(kWhole)) - R(kWhole);
        const R start = first + ring * cells;
        const R u = (start + cells * fraction_of_bits<R>(one)) / R(float(count));
        const R turn = ((i - start) + fraction_of_bits<R>(two)) / cells - R(0.5f);
        return {min(max(u, R(0x1p-24f)), R(1 - 0x1p-24f)), turn};
    }
}

template <class B>
ZERKALO_INLINE B reversed_bits(B x) {
    x = (x >> 16) | (x << 16);
    x = ((x >> 8) & B(0x00ff00ffu)) | ((x & B(0x00ff00ffu)) << 8);
    x = ((x >> 4) & B(0x0f0f0f0fu)) | ((x & B(0x0f0f0f0fu)) << 4);
    x = ((x >> 2) & B(0x33333333u)) | ((x & B(0x33333333u)) << 2);
    return ((x >> 1) & B(0x55555555u)) | ((x & B(0x55555555u)) << 1);
}

/// The second dimension of Sobol's sequence, bits reversed: bit r is the sum modulo 2 of those bits c of the index with
/// C(c, r) odd, whose numbers contain the bits of r.
template <class B>
ZERKALO_INLINE B reversed_second_dimension(B index) {
    index = index ^ ((index >> 1) & B(0x55555555u));
    index = index ^ ((index >> 2) & B(0x33333333u));
    index = index ^ ((index >> 4) & B(0x0f0f0f0fu));
    index = index ^ ((index >> 8) & B(0x00ff00ffu));
    return index ^ (index >> 16);
}

/// Owen's scrambling of a number whose bits are reversed: a bit is flipped by a hash of those before it.
template <class B>
ZERKALO_INLINE B scrambled(B x, B key) {
    x = x + key;
    x = x ^ (x * B(0x6c50b47cu));
    x = x ^ (x * B(0xb82f1e52u));
    x = x ^ (x * B(0xc7afe638u));
    x = x ^ (x * B(0x8d22f6e6u));
    return reversed_bits(x);
}

template <class R>
ZERKALO_INLINE SetPoint<R> sobol_point(Bits<R> index, const SetChoice<Bits<R>>& set) {
    return {fraction_of_bits<R>(scrambled(index, set.key) ^ set.half),
            phase_of<R>(scrambled(reversed_second_dimension(index), second_key(set.key)))};
}

template <class R>
ZERKALO_INLINE SetPoint<R> r2_point(Bits<R> index, const SetChoice<Bits<R>>& set) {
    return {fraction_of_bits<R>((set.key ^ set.half) + index * Bits<R>(kPlasticTurn)),
            phase_of<R>(second_key(set.key) + index * Bits<R>(kPlasticTurn2))};
}

/// Point `index` of the `count` that a keyed rule places.
template <class R>
ZERKALO_ONCE SetPoint<R> set_point(Estimator estimator, Bits<R> index, std::int32_t count,
                                   const SetChoice<Bits<R>>& set) {
    switch (estimator) {
        case Estimator::random: return random_point<R>(index, set);
        case Estimator::jittered: return jittered_point<R>(index, count, set);
        case Estimator::sobol: return sobol_point<R>(index, set);
        default: return r2_point<R>(index, set);
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
