// A run of lattice points of one lobe, computed once for all the packets that share it.
#pragma once

#include "core/optics/lattice.hpp"
#include "core/render/packet.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Points first, first + 1, ... and the rest of the last packet.
template <class R>
ZERKALO_INLINE void fill_chunk(LatticeChunk& chunk, const Sampling& sampling, const LobeData& lobe, std::int32_t first,
                                std::int32_t samples) {
    chunk.count = samples - first < kChunk ? samples - first : kChunk;
    const Bits<R> lane = load_bits<R>(kLaneNumbers.bits);
    for (std::int32_t i = 0; i < chunk.count; i += kWidth<R>) {
        const Bits<R> index = lane + Bits<R>(static_cast<std::uint32_t>(first + i));
        const LobePoint<R> point = lattice_point<R>(sampling, index, samples, R(lobe.inverse_exponent));
        store(chunk.side + i, point.side);
        store(chunk.up + i, point.up);
        store(chunk.forward + i, point.forward);
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
