// The unpolished mirror: the average over a lobe about the mirror direction (seed: the mirror that is not ideal).
//
//     I = background W + sum over lattice rays i that meet a solid of  s_i w_i (L_i - background)
//
// with s_i the ray's share of the lobe (1/N, but for the rim: optics/shares.hpp), w_i the lobe's weight and W their
// mean: 1 for the seed's Phong lobe (rays below the horizon see the background), min(1, cos_i / cos_o) for max-Phong.
// Where no ray can meet a solid the sum is empty: the answer is exact without a ray. Where the solids' faces f are
// covered first (render/cover_solids.hpp), with any shades c_f, the same is
//
//     I = background W + sum over f of (c_f - background) coverage_f
//         + sum over i of  s_i (w_i (L_i - background) - sum over all f that ray i meets of (c_f - background))
//
// so that only what differs from the shades is left to the rays; where a solid hides another, both sums leave out what
// is hidden (render/cover_hidden.hpp). Pixels that do need rays wait in a queue, so that
// packets are full; the lattice's first points are in the plan. Source of max-Phong: Neumann, Neumann, Szirmay-Kalos,
// "Compact Metallic Reflectance Models", CGF 18(3), 1999.
#pragma once

#include "core/render/cover_grid.hpp"
#include "core/render/gloss_settle.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The mirror's normal in the lobe's frame.
template <class R>
struct NormalInFrame {
    R forward, side, up;
};

/// Cosine of ray s against the mirror's normal.
template <class R>
ZERKALO_INLINE R ray_cosine(const NormalInFrame<R>& n, const LatticeChunk& chunk, std::int32_t s) {
    return n.forward * R(chunk.forward[s]) + n.side * R(chunk.side[s]) + n.up * R(chunk.up[s]);
}

/// The weight of max-Phong times what ray s counts for.
template <class R>
ZERKALO_INLINE R weight_of_ray(const NormalInFrame<R>& n, const LatticeChunk& chunk, std::int32_t s, R inverse_cosine) {
    const R weight = lobe_weight(ray_cosine(n, chunk, s), inverse_cosine);
    return s < chunk.rim ? weight * R(chunk.weight[s]) : weight;
}

/// The points and frames of a queue's pixels from number `first` on.
template <class R>
ZERKALO_INLINE void frame_group(GroupFrames<R>& frames, const GlossQueue& queue, std::int32_t first,
                                const GlossPoints& points, SineCosine<float> phase) {
    const std::int32_t packets = (queue.count - first + kWidth<R> - 1) / kWidth<R>;
    frames.packets = packets < kGroupPackets<R> ? packets : kGroupPackets<R>;
    for (std::int32_t i = 0; i < frames.packets; ++i) {
        const std::uint8_t* pixels = queue.pixel + first + i * kWidth<R>;
        const Vec3<R> m{gather<R>(points.mx, pixels), gather<R>(points.my, pixels), gather<R>(points.mz, pixels)};
        frames.p[i] = {gather<R>(points.px, pixels), gather<R>(points.py, pixels), gather<R>(points.pz, pixels)};
        frames.frame[i] = lobe_frame(m, phase);
    }
}

/// Rays alone: nothing is known of a lobe before them, and nobody asks how sure its average is.
struct NoAids {
    static constexpr bool kCovers = false, kTells = false;
    template <class R>
    struct Met {};
};

/// Rays alone that tell how sure their average is.
struct TellingAids {
    static constexpr bool kCovers = false, kTells = true;
    template <class R>
    struct Met {};
    TileSpread* spread;
    GlossParts parts;  // in the spread
};

/// What a tile's lobe rays can have beside them.
struct LobeAids {
    static constexpr bool kCovers = true, kTells = true;
    template <class R>
    using Met = Meetings<R>;
    TileSpread* spread;  // null: nobody asks
    GlossParts parts;
    const TileCover& cover;  // what is known before them
};

/// Adds the weights of a chunk's rays to their sum, and each to that of its part.
template <class R>
ZERKALO_INLINE void add_weights(GlossQueue& queue, GlossParts::OfClasses& parts, int c, std::int32_t at,
                                const NormalInFrame<R>& n, const LatticeChunk& chunk, R inverse_cosine) {
    R sum = load<R>(queue.weight + at), of_part[kSpreadParts];
    for (int part = 0; part < kSpreadParts; ++part) of_part[part] = load<R>(parts[c][part] + at);
    // The rays are a multiple of the parts.
    for (std::int32_t s = 0; s < chunk.count; s += kSpreadParts) {
        for (int part = 0; part < kSpreadParts; ++part) {
            const R weight = weight_of_ray(n, chunk, s + part, inverse_cosine);
            sum = sum + weight;
            of_part[part] = of_part[part] + weight;
        }
    }
    store(queue.weight + at, sum);
    for (int part = 0; part < kSpreadParts; ++part) store(parts[c][part] + at, of_part[part]);
}
/// Their sum alone.
template <class R>
ZERKALO_INLINE void add_weights(GlossQueue& queue, std::int32_t at, const NormalInFrame<R>& n,
                                const LatticeChunk& chunk, R inverse_cosine) {
    R sum = load<R>(queue.weight + at);
    for (std::int32_t s = 0; s < chunk.count; ++s) sum = sum + weight_of_ray(n, chunk, s, inverse_cosine);
    store(queue.weight + at, sum);
}

/// The lobe rays of packet i of a group, number `at` and on in the queue of class c, for one chunk of the lattice: adds
/// to the queue's sums.
template <class R, class Aids>
ZERKALO_INLINE void shoot_chunk(const Plan& plan, const MirrorPlan& mirror, const Aids& aids,
                                const GroupAim<R>& group_aim, const GroupFrames<R>& frames, const LatticeChunk& chunk,
                                GlossQueue& queue, std::int32_t at, std::int32_t i, int c, TileCounts& counts) {
    const auto active = load<R>(kLaneNumbers.real) < R(float(queue.count - at));
    const Vec3<R>& p = frames.p[i];
    const LobeFrame<R>& frame = frames.frame[i];
    LobeAim<R> aim;
    aim_packet(aim, group_aim, plan, frames, i, active);
    const std::uint32_t sending = count_of(Mask<R>(active & group_aim.meets[i]));
    counts.lobe += sending * static_cast<std::uint32_t>(chunk.count);
    counts.weighed += (count_of(active) - sending) * static_cast<std::uint32_t>(chunk.count);
    const bool weighted = mirror.lobe.max_phong;
    const Vec3<R> normal = spread<R>(mirror.shape.n);
    NormalInFrame<R> n{dot(frame.m, normal), R(0), R(0)};
    const bool dips = weighted || any(n.forward <= R(mirror.lobe.widest_sine));
    if (dips) n.side = dot(frame.t, normal), n.up = dot(frame.b, normal);
    const R inverse_cosine = R(1) / n.forward;
    if (weighted) {
        // The mean weight counts all rays, also those that meet nothing.
        bool told = false;
        if constexpr (Aids::kTells) {
            told = aids.spread != nullptr;
            if (told) add_weights(queue, *aids.parts.weight, c, at, n, chunk, inverse_cosine);
        }
        if (!told) add_weights(queue, at, n, chunk, inverse_cosine);
    }

    const Rgb<R> background = spread<R>(plan.background), none_yet = spread<R>(Rgb<float>{0, 0, 0});
    Rgb<R> sum{load<R>(queue.r + at), load<R>(queue.g + at), load<R>(queue.b + at)};
    const auto take = [&](std::int32_t s, Rgb<R> light) ZERKALO_INLINE_LAMBDA {
        if (s < chunk.rim) light = scaled(light, R(chunk.weight[s]));
        sum = sum + light;
        if constexpr (Aids::kTells) {
            if (aids.spread == nullptr) return;
            const GlossParts& parts = aids.parts;
            const std::int32_t part = s % kSpreadParts;
            add_to((*parts.r)[c][part] + at, light.r), add_to((*parts.g)[c][part] + at, light.g);
            add_to((*parts.b)[c][part] + at, light.b);
        }
    };
    for (std::uint64_t left = aim.reach & first_bits(chunk.count); left != 0; left &= left - 1) {
        const std::int32_t s = first_of(left);
        const Vec3<R> d = frame.m * R(chunk.forward[s]) + frame.t * R(chunk.side[s]) + frame.b * R(chunk.up[s]);
        if (aim.shared >> s & 1) {
            CandidateMask asked = 0;
            Rgb<R> counted = none_yet;
            typename Aids::template Met<R> meetings;
            const auto each = [&](int k, R face, Mask<R> met) ZERKALO_INLINE_LAMBDA {
                if constexpr (Aids::kCovers) {
                    if (aids.cover.hiders != 0) return meetings.add(aids.cover, k, face, met);
                    add_counted(counted, aids.cover, k, face, met);
                }
            };
            const Nearest<R> near = nearest_in_lobe(plan, aim, s, p, d, asked, each);
            Mask<R> hit = active & (near.id >= R(0));
            if (none(hit)) continue;
            if constexpr (Aids::kCovers) {
                if (aids.cover.hiders != 0) counted = counted_of(aids.cover, meetings);
            }
            if (dips) hit = hit & (ray_cosine(n, chunk, s) > R(0));
            Rgb<R> light = solid_light(plan, asked, near, p, d, hit, background, counts) - background;
            if (weighted) light = scaled(light, lobe_weight(ray_cosine(n, chunk, s), inverse_cosine));
            // In the order of the other branch: which one a ray takes depends on its packet.
            if constexpr (Aids::kCovers) take(s, none_yet - counted);
            take(s, light);
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
            if constexpr (Aids::kCovers) {
                Rgb<R> counted = none_yet;
                add_counted(counted, aids.cover, candidate.k, face, hit);
                take(s, none_yet - counted);
            }
            if (dips) hit = hit & (ray_cosine(n, chunk, s) > R(0));
            Rgb<R> light = light_of_solid<R>(plan, *candidate.solid, p + d * t, face, d, hit, counts) - background;
            if (weighted) light = scaled(light, lobe_weight(ray_cosine(n, chunk, s), inverse_cosine));
            take(s, select(hit, light, none_yet));
        }
    }
    store(queue.r + at, sum.r), store(queue.g + at, sum.g), store(queue.b + at, sum.b);
}

constexpr int kClassChunks = 2;  // of a keyed rule: for the even classes and for the odd ones

/// The points of the classes from number `first` on: of the lattice, in the first chunk, for all of them.
template <class R>
ZERKALO_ONCE void fill_class_chunks(LatticeChunk* chunks, const Plan& plan, const LobeData& lobe, std::uint32_t tile,
                                    std::uint32_t sample, std::int32_t first) {
    if (!is_keyed(plan.sampling.estimator)) {
        const LatticePart part = lattice_part(plan.sampling, sample, plan.antialias);
        return fill_chunk<R>(chunks[0], part, lobe, first, plan.samples);
    }
    for (int c = 0; c < kClassChunks; ++c) {
        const auto set = set_of_class(plan.sampling, tile, c, sample);
        fill_keyed_chunk<R>(chunks[c], plan.sampling, lobe, set, first, plan.samples);
    }
}

/// Traces all waiting pixels of camera sample `sample` and adds what they see in the mirror to their colours.
/// A function of its own, so that its stack and the camera rays' are not held at the same time.
template <class R, class Aids>
ZERKALO_ONCE void flush(GlossQueues& queues, const LatticeClasses& classes, const Plan& plan, const MirrorPlan& mirror,
                        CandidateMask candidates, const Aids& aids, std::uint32_t sample, TileColours& colours,
                        TileCounts& counts) {
    const std::uint64_t waiting = queues.waiting;
    queues.waiting = 0;
    for (int c = 0; c < kLatticeClasses; ++c) {
        fill_queue<R>(queues, c, waiting & pixels_of_class(classes, c), mirror.lobe.max_phong);
    }
    const bool keyed = is_keyed(plan.sampling.estimator);
    LatticeChunk later[kClassChunks];
    GroupFrames<R> frames;
    GroupAim<R> aim;
    for (std::int32_t first = 0; first < plan.samples; first += kChunk) {
        const bool fill = first > 0 || sample > 0 || keyed;
        if (fill) fill_class_chunks<R>(later, plan, mirror.lobe, queues.tile, sample, first);
        const LatticeChunk* chunks = fill ? later : &mirror.lattice;
        SineCosine<float> phase = sincos_turn(turn_of_class(plan.sampling, 0));
        for (int c = 0; c < kLatticeClasses; ++c, phase = quarter_turned(phase)) {
            GlossQueue& queue = queues.of_class[c];
            const LatticeChunk& chunk = chunks[c & int{keyed}];
            for (std::int32_t at = 0; at < queue.count; at += kGroupPackets<R> * kWidth<R>) {
                frame_group(frames, queue, at, queues.points, phase);
                aim_group(aim, plan, mirror.lobe, candidates, chunk, frames);
                for (std::int32_t i = 0; i < frames.packets; ++i) {
                    shoot_chunk<R>(plan, mirror, aids, aim, frames, chunk, queue, at + i * kWidth<R>, i, c, counts);
                }
            }
        }
    }
    if constexpr (Aids::kTells) {
        for (int c = 0; aids.spread != nullptr && c < kLatticeClasses; ++c) {
            settle_spread<R>(queues.of_class[c], aids, c, plan, mirror);
        }
    }
    settle<R>(queues, waiting, plan, mirror, colours);
}

}  // namespace zerkalo::inline ZERKALO_ISA
