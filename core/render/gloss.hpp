// The unpolished mirror: the average over a lobe about the mirror direction (seed: the mirror that is not ideal).
//
//     I = background W + (1/N) sum over lattice rays i that meet a solid of  w_i (L_i - background)
//
// with w_i the lobe's weight and W their mean: 1 for the seed's Phong lobe (rays below the horizon see the background),
// min(1, cos_i / cos_o) for max-Phong. Where no ray can meet a solid the sum is empty: the answer is exact without a ray.
// Pixels that do need rays wait in a queue, so that packets are full; the lattice is computed once a tile.
// Source of max-Phong: Neumann, Neumann, Szirmay-Kalos, "Compact Metallic Reflectance Models", CGF 18(3), 1999.
#pragma once

#include "core/render/lobe_aim.hpp"
#include "core/render/tile.hpp"

namespace zerkalo::inline ZERKALO_ISA {


constexpr int kClassPixels = kTilePixels / kLatticeClasses;  // each block of 2x2 pixels has one of each

/// Mirror points of one lattice class that wait for their lobe rays, one entry a pixel.
struct GlossQueue {
    alignas(64) float px[kClassPixels], py[kClassPixels], pz[kClassPixels];
    alignas(64) float mx[kClassPixels], my[kClassPixels], mz[kClassPixels];
    alignas(64) float r[kClassPixels], g[kClassPixels], b[kClassPixels];
    alignas(64) float weight[kClassPixels];
    std::uint8_t slot[kClassPixels];
    std::int32_t count = 0;
};

/// The queues of a tile, and the hash that sorts its pixels into them.
struct GlossQueues {
    GlossQueue of_class[kLatticeClasses];
    std::uint32_t tile_hash;
};

/// Appends the lanes of the mask: point, mirror direction, pixel of the tile.
template <class R>
ZERKALO_INLINE void enqueue(GlossQueues& queues, Mask<R> mask, Vec3<R> p, Vec3<R> m, int first) {
    alignas(64) float lanes[6][kWidth<R>];
    store(lanes[0], p.x), store(lanes[1], p.y), store(lanes[2], p.z);
    store(lanes[3], m.x), store(lanes[4], m.y), store(lanes[5], m.z);
    for (std::uint32_t bits = bits_of(mask); bits != 0; bits &= bits - 1) {
        const int lane = __builtin_ctz(bits);
        const int slot = first + lane;
        GlossQueue& queue = queues.of_class[lattice_class(queues.tile_hash, slot % kTileSide, slot / kTileSide)];
        const std::int32_t at = queue.count++;
        queue.px[at] = lanes[0][lane], queue.py[at] = lanes[1][lane], queue.pz[at] = lanes[2][lane];
        queue.mx[at] = lanes[3][lane], queue.my[at] = lanes[4][lane], queue.mz[at] = lanes[5][lane];
        queue.slot[at] = static_cast<std::uint8_t>(slot);
    }
}

/// Fills the last packet with copies of the last entry and clears the sums.
ZERKALO_INLINE void close_queue(GlossQueue& queue, int width) {
    const std::int32_t last = queue.count - 1;
    const std::int32_t padded = (queue.count + width - 1) / width * width;
    for (std::int32_t at = queue.count; at < padded; ++at) {
        queue.px[at] = queue.px[last], queue.py[at] = queue.py[last], queue.pz[at] = queue.pz[last];
        queue.mx[at] = queue.mx[last], queue.my[at] = queue.my[last], queue.mz[at] = queue.mz[last];
    }
    for (std::int32_t at = 0; at < padded; ++at) queue.r[at] = queue.g[at] = queue.b[at] = queue.weight[at] = 0;
}

/// Cosine of ray s against the mirror's normal.
template <class R>
ZERKALO_INLINE R ray_cosine(const LobeFrame<R>& frame, const LatticeChunk& chunk, std::int32_t s) {
    return frame.m_n * R(chunk.forward[s]) + frame.t_n * R(chunk.side[s]) + frame.b_n * R(chunk.up[s]);
}

/// The lobe rays of one packet for one chunk of the lattice: adds to the queue's sums.
template <class R>
ZERKALO_INLINE void shoot_chunk(const Plan& plan, const LobeData& lobe, const LatticeChunk& chunk, Vec3<float> normal,
                                float turn, GlossQueue& queue, std::int32_t at, TileCounts& counts) {
    const auto active = load<R>(kLaneNumbers.real) < R(float(queue.count - at));
    const Vec3<R> p{load<R>(queue.px + at), load<R>(queue.py + at), load<R>(queue.pz + at)};
    const Vec3<R> m{load<R>(queue.mx + at), load<R>(queue.my + at), load<R>(queue.mz + at)};
    const LobeFrame<R> frame = lobe_frame(m, turn, spread<R>(normal));
    LobeAim<R> aim;
    aim_lobe(aim, plan, lobe, chunk, frame, p, active);
    counts.lobe += count_of(active) * static_cast<std::uint32_t>(chunk.count);
    const bool weighted = lobe.max_phong;
    const bool dips = weighted || any(frame.m_n <= R(lobe.widest_sine));
    const R inverse_cosine = R(1) / frame.m_n;
    if (weighted) {
        // The mean weight counts all rays, also those that meet nothing.
        R weight_sum = load<R>(queue.weight + at);
        for (std::int32_t s = 0; s < chunk.count; ++s) {
            weight_sum = weight_sum + lobe_weight(ray_cosine(frame, chunk, s), inverse_cosine);
        }
        store(queue.weight + at, weight_sum);
    }

    const Rgb<R> background = spread<R>(plan.background);
    Rgb<R> sum{load<R>(queue.r + at), load<R>(queue.g + at), load<R>(queue.b + at)};
    for (std::uint64_t left = aim.reach; left != 0; left &= left - 1) {
        const std::int32_t s = first_of(left);
        if (s >= chunk.count) break;
        const Vec3<R> d = frame.m * R(chunk.forward[s]) + frame.t * R(chunk.side[s]) + frame.b * R(chunk.up[s]);
        CandidateMask asked = 0;
        const Nearest<R> near = nearest_in_lobe(plan, aim, s, p, d, asked);
        Mask<R> hit = active & (near.id >= R(0));
        if (none(hit)) continue;
        R weight = R(1);
        if (dips) {
            const R cosine = ray_cosine(frame, chunk, s);
            hit = hit & (cosine > R(0));
            if (weighted) weight = lobe_weight(cosine, inverse_cosine);
        }
        const Rgb<R> light = solid_light(plan, asked, near, p, d, hit, background, counts) - background;
        sum = sum + scaled(light, weight);
    }
    store(queue.r + at, sum.r), store(queue.g + at, sum.g), store(queue.b + at, sum.b);
}

/// Adds F K_r I to the colours of a class of pixels whose lobe rays are all in.
ZERKALO_INLINE void settle(GlossQueue& queue, const Plan& plan, const MirrorPlan& mirror, TileColours& colours) {
    const float samples = float(plan.samples);
    const Rgb<float> background = plan.background;
    for (std::int32_t at = 0; at < queue.count; ++at) {
        const float weight = mirror.lobe.max_phong ? queue.weight[at] / samples : 1.0f;
        const int slot = queue.slot[at];
        colours.r[slot] += mirror.reflectance.r * (background.r * weight + queue.r[at] / samples);
        colours.g[slot] += mirror.reflectance.g * (background.g * weight + queue.g[at] / samples);
        colours.b[slot] += mirror.reflectance.b * (background.b * weight + queue.b[at] / samples);
    }
    queue.count = 0;
}

/// Traces all waiting pixels of camera sample `sample` and adds what they see in the mirror to their colours.
template <class R>
ZERKALO_INLINE void flush(GlossQueues& queues, const Plan& plan, const MirrorPlan& mirror, std::uint32_t sample,
                          TileColours& colours, TileCounts& counts) {
    std::int32_t waiting = 0;
    for (const GlossQueue& queue : queues.of_class) waiting += queue.count;
    if (waiting == 0) return;
    for (GlossQueue& queue : queues.of_class) {
        if (queue.count > 0) close_queue(queue, kWidth<R>);
    }
    LatticeChunk chunk;
    for (std::int32_t first = 0; first < plan.samples; first += kChunk) {
        fill_chunk<R>(chunk, mirror.lobe, first, plan.samples);
        for (int c = 0; c < kLatticeClasses; ++c) {
            GlossQueue& queue = queues.of_class[c];
            const float turn = turn_of_class(c, sample, 0);
            for (std::int32_t at = 0; at < queue.count; at += kWidth<R>) {
                shoot_chunk<R>(plan, mirror.lobe, chunk, mirror.shape.n, turn, queue, at, counts);
            }
        }
    }
    for (GlossQueue& queue : queues.of_class) settle(queue, plan, mirror, colours);
}

}  // namespace zerkalo::inline ZERKALO_ISA
