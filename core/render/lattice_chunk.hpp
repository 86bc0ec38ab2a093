// A run of points of one lobe, computed once for all the packets that share it.
#pragma once

#include "core/optics/point_sets.hpp"
#include "core/render/packet.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// What `point_at` gives for the indices first, first + 1, ... and the rest of the last packet.
template <class R, class PointAt>
ZERKALO_INLINE void fill_points(LatticeChunk& chunk, std::int32_t first, std::int32_t samples, PointAt point_at) {
    chunk.count = samples - first < kChunk ? samples - first : kChunk;
    chunk.rim = 0;
    const Bits<R> lane = load_bits<R>(kLaneNumbers.bits);
    for (std::int32_t i = 0; i < chunk.count; i += kWidth<R>) {
        const LobePoint<R> point = point_at(lane + Bits<R>(static_cast<std::uint32_t>(first + i)));
        store(chunk.side + i, point.side);
        store(chunk.up + i, point.up);
        store(chunk.forward + i, point.forward);
    }
}

/// Of a part of the lattice that all tiles share.
template <class R>
ZERKALO_INLINE void fill_chunk(LatticeChunk& chunk, const LatticePart& part, const LobeData& lobe, std::int32_t first,
                               std::int32_t samples) {
    fill_points<R>(chunk, first, samples, [&](Bits<R> index) ZERKALO_INLINE_LAMBDA {
        return lattice_point<R>(part, index, samples, R(lobe.inverse_exponent));
    });
    const std::int32_t rim = rays_at_rim(Estimator::fibonacci, samples) - first;
    for (; chunk.rim < chunk.count && chunk.rim < rim; ++chunk.rim) {
        chunk.weight[chunk.rim] = weight_at_rim<float>(first + chunk.rim, samples);
    }
}

/// Even points of the unit disc, at most kChunk.
template <class R>
ZERKALO_INLINE void fill_disc(LatticeChunk& chunk, std::int32_t samples) {
    fill_points<R>(chunk, 0, samples,
                   [&](Bits<R> index) ZERKALO_INLINE_LAMBDA { return disc_point<R>(index, samples); });
}

/// Of a tile's own set.
template <class R>
ZERKALO_INLINE void fill_keyed_chunk(LatticeChunk& chunk, const Sampling& sampling, const LobeData& lobe,
                                     const SetChoice<std::uint32_t>& set, std::int32_t first, std::int32_t samples) {
    const SetChoice<Bits<R>> lanes{Bits<R>(set.key), Bits<R>(set.half)};
    fill_points<R>(chunk, first, samples, [&](Bits<R> index) ZERKALO_INLINE_LAMBDA {
        const SetPoint<R> point = set_point<R>(sampling.estimator, index, samples, lanes);
        return lobe_point(point.u, point.turn, R(lobe.inverse_exponent));
    });
}

}  // namespace zerkalo::inline ZERKALO_ISA
