// The pixels of a tile that wait for their lobe rays, sorted by lattice class so that packets are full, and their sums.
#pragma once

#include "core/numeric/shuffle.hpp"
#include "core/optics/lattice.hpp"
#include "core/render/tile.hpp"

namespace zerkalo::inline ZERKALO_ISA {

constexpr int kClassPixels = kTilePixels / kLatticeClasses;  // each block of 2x2 pixels has one of each

/// What the pixels of a tile see at the mirror: the point and the mirror direction, by pixel.
struct GlossPoints {
    alignas(64) float px[kTilePixels], py[kTilePixels], pz[kTilePixels];
    alignas(64) float mx[kTilePixels], my[kTilePixels], mz[kTilePixels];
};

/// Pixels of one lattice class that wait for their lobe rays, and the sums of these.
struct GlossQueue {
    alignas(64) float r[kClassPixels], g[kClassPixels], b[kClassPixels];
    alignas(64) float weight[kClassPixels];
    std::uint8_t pixel[kClassPixels];
    std::int32_t count;
};

/// The pixels of a tile that wait, and the queues that they are sorted into.
struct GlossQueues {
    GlossPoints points;
    GlossQueue of_class[kLatticeClasses];
    std::uint8_t slot[kTilePixels];  // where in the queues a waiting pixel is, counted in floats
    std::uint64_t waiting;           // bit p: pixel p
    std::uint32_t tile;              // its hash
};
constexpr int kQueueFloats = sizeof(GlossQueue) / sizeof(float);
static_assert((kLatticeClasses - 1) * kQueueFloats + kClassPixels <= 256, "a slot fits into a byte");

/// The same sums apart for every kSpreadParts-th lobe ray: how far these parts lie from one another tells the error.
struct GlossParts {
    using OfClasses = float[kLatticeClasses][kSpreadParts][kClassPixels];
    OfClasses *r, *g, *b, *weight;
};

/// The sums in the caller's memory, cleared.
ZERKALO_INLINE GlossParts parts_in(TileSpread& spread) {
    for (auto& channel : spread.parts) {
        for (float& sum : channel) sum = 0;
    }
    using OfClasses = GlossParts::OfClasses;
    return {reinterpret_cast<OfClasses*>(spread.parts[0]), reinterpret_cast<OfClasses*>(spread.parts[1]),
            reinterpret_cast<OfClasses*>(spread.parts[2]), reinterpret_cast<OfClasses*>(spread.parts[3])};
}

template <class R>
ZERKALO_INLINE void add_to(float* sums, R x) {
    store(sums, load<R>(sums) + x);
}

/// Notes the packet's points and lets the lanes of the mask wait.
template <class R>
ZERKALO_INLINE void enqueue(GlossQueues& queues, Mask<R> mask, Vec3<R> p, Vec3<R> m, int first) {
    GlossPoints& points = queues.points;
    store(points.px + first, p.x), store(points.py + first, p.y), store(points.pz + first, p.z);
    store(points.mx + first, m.x), store(points.my + first, m.y), store(points.mz + first, m.z);
    queues.waiting |= std::uint64_t{bits_of(mask)} << first;
}

/// Fills the queue of class c with its pixels, its last packet with copies of the last one, and clears the sums.
template <class R>
ZERKALO_INLINE void fill_queue(GlossQueues& queues, int c, std::uint64_t pixels, bool weighted) {
    GlossQueue& queue = queues.of_class[c];
    std::int32_t count = 0;
    for (; pixels != 0; pixels &= pixels - 1) {
        const int pixel = first_of(pixels);
        queues.slot[pixel] = static_cast<std::uint8_t>(c * kQueueFloats + count);
        queue.pixel[count++] = static_cast<std::uint8_t>(pixel);
    }
    queue.count = count;
    if (count == 0) return;
    std::int32_t padded = count;
    for (; padded % kWidth<R> != 0; ++padded) queue.pixel[padded] = queue.pixel[count - 1];
    for (std::int32_t at = 0; at < padded; at += kWidth<R>) {
        store(queue.r + at, R(0)), store(queue.g + at, R(0)), store(queue.b + at, R(0));
        if (weighted) store(queue.weight + at, R(0));
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
