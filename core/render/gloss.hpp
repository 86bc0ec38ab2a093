// The unpolished mirror: the average over a lobe about the mirror direction (seed: the mirror that is not ideal).
//
//     I = background W + (1/N) sum over lattice rays i that meet a solid of  w_i (L_i - background)
//
// with w_i the lobe's weight and W their mean: 1 for the seed's Phong lobe (rays below the horizon see the background),
// min(1, cos_i / cos_o) for max-Phong. Where no ray can meet a solid the sum is empty: the answer is exact without a
// ray. Pixels that do need rays wait in a queue, so that packets are full; the lattice is computed once a tile. Source
// of max-Phong: Neumann, Neumann, Szirmay-Kalos, "Compact Metallic Reflectance Models", CGF 18(3), 1999.
#pragma once

#include "core/render/lobe_aim.hpp"
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
    std::uint64_t waiting;  // bit p: pixel p
};

/// Notes the packet's points and lets the lanes of the mask wait.
template <class R>
ZERKALO_INLINE void enqueue(GlossQueues& queues, Mask<R> mask, Vec3<R> p, Vec3<R> m, int first) {
    GlossPoints& points = queues.points;
    store(points.px + first, p.x), store(points.py + first, p.y), store(points.pz + first, p.z);
    store(points.mx + first, m.x), store(points.my + first, m.y), store(points.mz + first, m.z);
    queues.waiting |= std::uint64_t{bits_of(mask)} << first;
}

/// Fills a queue with the pixels of its class, its last packet with copies of the last one, and clears the sums.
template <class R>
ZERKALO_INLINE void fill_queue(GlossQueue& queue, std::uint64_t pixels, bool weighted) {
    std::int32_t count = 0;
    for (; pixels != 0; pixels &= pixels - 1) queue.pixel[count++] = static_cast<std::uint8_t>(first_of(pixels));
    queue.count = count;
    if (count == 0) return;
    std::int32_t padded = count;
    for (; padded % kWidth<R> != 0; ++padded) queue.pixel[padded] = queue.pixel[count - 1];
    for (std::int32_t at = 0; at < padded; at += kWidth<R>) {
        store(queue.r + at, R(0)), store(queue.g + at, R(0)), store(queue.b + at, R(0));
        if (weighted) store(queue.weight + at, R(0));
    }
}

/// The values of `source` at the pixels of one packet.
template <class R>
ZERKALO_INLINE R gather(const float* source, const std::uint8_t* pixels) {
    alignas(64) float lanes[kWidth<R>];
    for (int lane = 0; lane < kWidth<R>; ++lane) lanes[lane] = source[pixels[lane]];
    return load<R>(lanes);
}

/// Cosine of ray s against the mirror's normal.
template <class R>
ZERKALO_INLINE R ray_cosine(const LobeFrame<R>& frame, const LatticeChunk& chunk, std::int32_t s) {
    return frame.m_n * R(chunk.forward[s]) + frame.t_n * R(chunk.side[s]) + frame.b_n * R(chunk.up[s]);
}

/// The lobe rays of one packet for one chunk of the lattice: adds to the queue's sums.
template <class R>
ZERKALO_INLINE void shoot_chunk(const Plan& plan, const LobeData& lobe, CandidateMask candidates,
                                const LatticeChunk& chunk, Vec3<float> normal, SineCosine<float> phase, const GlossPoints& points,
                                GlossQueue& queue, std::int32_t at, TileCounts& counts) {
    const auto active = load<R>(kLaneNumbers.real) < R(float(queue.count - at));
    const std::uint8_t* pixels = queue.pixel + at;
    const Vec3<R> p{gather<R>(points.px, pixels), gather<R>(points.py, pixels), gather<R>(points.pz, pixels)};
    const Vec3<R> m{gather<R>(points.mx, pixels), gather<R>(points.my, pixels), gather<R>(points.mz, pixels)};
    const LobeFrame<R> frame = lobe_frame(m, phase, spread<R>(normal));
    LobeAim<R> aim;
    aim_lobe(aim, plan, lobe, candidates, chunk, frame, p, active);
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
    for (std::uint64_t left = aim.reach & first_bits(chunk.count); left != 0; left &= left - 1) {
        const std::int32_t s = first_of(left);
        const Vec3<R> d = frame.m * R(chunk.forward[s]) + frame.t * R(chunk.side[s]) + frame.b * R(chunk.up[s]);
        if (aim.shared >> s & 1) {
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
            Rgb<R> light = solid_light(plan, asked, near, p, d, hit, background, counts) - background;
            if (weighted) light = scaled(light, weight);
            sum = sum + light;
        } else {
            const LobeCandidate<R>& candidate = only_candidate(aim, s);
            R t = R(0), face = R(0);
            Mask<R> hit = active;
            with_candidate_span(plan, candidate, p, d, [&](const Span<FloatNumbers<R>>& span) ZERKALO_INLINE_LAMBDA {
                hit = (span.entry <= span.exit) & (span.entry > R(0)) & candidate.allowed;
                t = span.entry;
                face = span.face_in;
            });
            if (none(hit)) continue;
            R weight = R(1);
            if (dips) {
                const R cosine = ray_cosine(frame, chunk, s);
                hit = hit & (cosine > R(0));
                if (weighted) weight = lobe_weight(cosine, inverse_cosine);
            }
            Rgb<R> light = light_of_solid<R>(plan, candidate.k, p + d * t, face, d, hit, counts) - background;
            if (weighted) light = scaled(light, weight);
            sum = sum + select(hit, light, spread<R>(Rgb<float>{0, 0, 0}));
        }
    }
    store(queue.r + at, sum.r), store(queue.g + at, sum.g), store(queue.b + at, sum.b);
}

/// Adds F K_r I to the colours of a class of pixels whose lobe rays are all in.
template <class R>
ZERKALO_INLINE void settle(GlossQueue& queue, const Plan& plan, const MirrorPlan& mirror, TileColours& colours) {
    const R samples = R(float(plan.samples));
    const Rgb<R> background = spread<R>(plan.background);
    for (std::int32_t at = 0; at < queue.count; at += kWidth<R>) {
        const R weight = mirror.lobe.max_phong ? load<R>(queue.weight + at) / samples : R(1);
        const Rgb<R> mean{load<R>(queue.r + at) / samples, load<R>(queue.g + at) / samples,
                          load<R>(queue.b + at) / samples};
        const Rgb<R> seen = spread<R>(mirror.reflectance) * (scaled(background, weight) + mean);
        store(queue.r + at, seen.r), store(queue.g + at, seen.g), store(queue.b + at, seen.b);
    }
    for (std::int32_t at = 0; at < queue.count; ++at) {
        const int pixel = queue.pixel[at];
        colours.r[pixel] += queue.r[at];
        colours.g[pixel] += queue.g[at];
        colours.b[pixel] += queue.b[at];
    }
}

/// Traces all waiting pixels of camera sample `sample` and adds what they see in the mirror to their colours.
template <class R>
ZERKALO_INLINE void flush(GlossQueues& queues, const LatticeClasses& classes, const Plan& plan,
                          const MirrorPlan& mirror, CandidateMask candidates, std::uint32_t sample,
                          TileColours& colours, TileCounts& counts) {
    if (queues.waiting == 0) return;
    for (int c = 0; c < kLatticeClasses; ++c) {
        fill_queue<R>(queues.of_class[c], queues.waiting & pixels_of_class(classes, c), mirror.lobe.max_phong);
    }
    queues.waiting = 0;
    LatticeChunk chunk;
    for (std::int32_t first = 0; first < plan.samples; first += kChunk) {
        fill_chunk<R>(chunk, mirror.lobe, first, plan.samples);
        for (int c = 0; c < kLatticeClasses; ++c) {
            GlossQueue& queue = queues.of_class[c];
            const SineCosine<float> phase = sincos_turn(turn_of_class(c, sample, 0));
            for (std::int32_t at = 0; at < queue.count; at += kWidth<R>) {
                shoot_chunk<R>(plan, mirror.lobe, candidates, chunk, mirror.shape.n, phase, queues.points, queue, at,
                               counts);
            }
        }
    }
    for (GlossQueue& queue : queues.of_class) settle<R>(queue, plan, mirror, colours);
}

}  // namespace zerkalo::inline ZERKALO_ISA
