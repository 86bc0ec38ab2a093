// The lobes of a tile in fixed point, class by class: the rays of the pixels that wait for them.
#pragma once

#include "core/render/fixed_cull.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// What the rays of a chunk carry, the same for all pixels.
template <class One>
struct ChunkWeights {
    Rgb<Weight<One>> full, of_ray[kRayChunk];
    RayMask at_rim;  // those that carry less than the full share
};
template <class One>
ZERKALO_INLINE void fill_weights(ChunkWeights<One>& weights, const PlanOf<FixedFormats>& plan, std::int32_t first,
                                 std::int32_t count) {
    weights.full = full_throughput<One>(plan);
    for (std::int32_t i = 0; i < count; ++i) {
        weights.of_ray[i] = throughput_of_ray<One>(plan, weights.full, first + i);
    }
    const std::int32_t rim = rays_at_rim(plan.sampling.estimator, plan.samples) - first;
    weights.at_rim = rim <= 0 ? 0 : first_rays(rim < kRayChunk ? rim : kRayChunk);
}

/// The background, for the missed rays of a chunk.
template <class One>
ZERKALO_INLINE Rgb<LightSum<One>> light_of_missed(const PlanOf<FixedFormats>& plan, const ChunkWeights<One>& weights,
                                                  RayMask missed) {
    using S = LightSum<One>;
    Rgb<S> light{S(0), S(0), S(0)};
    add_missed<One>(plan, true, weights.full, count_of_rays(missed & ~weights.at_rim), light);
    for (RayMask left = missed & weights.at_rim; left != 0; left &= left - 1) {
        add<One>(light, true, weights.of_ray[first_of(left)], plan.background);
    }
    return light;
}

/// The nearest solid along d, for origins outside of every solid. `o`: the origins, or the one of all lanes.
template <class R, class O, class L>
ZERKALO_INLINE Nearest<R> nearest_from(const PlanFor<R>& plan, CandidateMask candidates, const O& origin, Vec3<L> o,
                                       Vec3<Direction<R>> d, Mask<R> active) {
    Nearest<R> best = nothing_yet<R>();
    for (CandidateMask left = solids_in(candidates); left != 0; left &= left - 1) {
        const int k = first_of(left);
        const Mask<R> near = plan.exact_plan ? active : may_meet<R>(plan.solids[k], o, d, active);
        if (none(near)) continue;
        with_span<Faces::entry, R>(plan, k, origin, d, [&](const Span<System<R>>& span) ZERKALO_INLINE_LAMBDA {
            keep_nearer<R>(best, span, plan.solids[k], near & (span.entry <= span.exit));
        });
    }
    return best;
}

/// The same from points of the mirror, where nothing better is known. Called, not inlined: seldom, and it takes
/// registers.
template <class R>
ZERKALO_ONCE Nearest<R> nearest_from_mirror(const PlanFor<R>& plan, CandidateMask candidates, const Vec3<Length<R>>& o,
                                            const Vec3<Direction<R>>& d, const Mask<R>& active) {
    return nearest_from<R>(plan, candidates, PointOrigin<Length<R>>{o}, o, d, active);
}

/// Adds the light of the nearest solids along d, times the throughput, and the background where there is none.
template <class R>
ZERKALO_INLINE void add_nearest(const PlanFor<R>& plan, CandidateMask candidates, const Nearest<R>& near,
                                Vec3<Length<R>> o, Vec3<Direction<R>> d, Mask<R> active, Rgb<Weight<R>> throughput,
                                Rgb<LightSum<R>>& sum, TileCounts& counts) {
    const auto hits = active & (near.id >= Index<R>(0));
    const auto misses = active & (!hits);
    if (any(misses)) add<R>(sum, misses, throughput, spread<Radiance<R>>(plan.background));
    if (none(hits)) return;
    const Length<R> none_here(0);
    const AnyHit<R> hit{near.t, near.id, near.face, mask_of<R>(false), none_here, none_here, none_here};
    light_solids<R>(plan, candidates, hit, o, d, hits, throughput, sum, counts, [](const auto&...) {});
}

/// The rays of a chunk, for a packet of one class. `aim`: of the candidates, or null where any ray may meet any.
template <class R>
ZERKALO_INLINE void shoot_rays(const PlanFor<R>& plan, const RayChunk& rays, std::int32_t count,
                               const ChunkWeights<Uniform<R>>& weights, const PacketLobes<R>& lobes,
                               CandidateMask candidates, const LobeAim<R>* aim, Rgb<LightSum<R>>& sum,
                               TileCounts& counts) {
    using D = Direction<R>;
    using One = Direction<Uniform<R>>;
    const bool weighted = plan.mirrors[0].lobe.max_phong;
    const Vec3<D> n = spread<D>(plan.mirrors[0].shape.n);
    const Mask<R> max_phong = mask_of<R>(weighted);
    counts.lobe += count_of(lobes.active) * static_cast<std::uint32_t>(count);
    // Each ray of max-Phong has a weight of its own, also where it meets nothing.
    RayMask left = first_rays(count);
    if (aim != nullptr && !weighted) {
        left &= aim->rays;
        add_uniform<R>(sum, lobes.active, light_of_missed<Uniform<R>>(plan, weights, first_rays(count) & ~left));
    }
    for (; left != 0; left &= left - 1) {
        const std::int32_t i = first_of(left);
        const LobePoint<R> point{D(One::from_raw(rays.side[i])), D(One::from_raw(rays.up[i])),
                                 D(One::from_raw(rays.forward[i]))};
        const LobeRay<R> ray = lobe_ray<R>(point, lobes.m, lobes.base, n, max_phong);
        const Rgb<Weight<R>> part = spread<Weight<R>>(weights.of_ray[i]);
        const auto below = lobes.active & (!ray.above);
        if (!weighted && any(below)) add<R>(sum, below, part, spread<Radiance<R>>(plan.background));
        const Mask<R> above = lobes.active & ray.above;
        if (none(above)) continue;
        const Rgb<Weight<R>> throughput = weighted ? as<Weight<R>>(scaled(part, ray.weight)) : part;
        CandidateMask asked = 0;
        Nearest<R> near;
        if (aim != nullptr) {
            near = nearest_aimed<R>(plan, *aim, i, ray.d, above, asked);
        } else {
            asked = candidates;
            near = nearest_from_mirror<R>(plan, asked, lobes.o, ray.d, above);
        }
        add_nearest<R>(plan, asked, near, lobes.o, ray.d, above, throughput, sum, counts);
    }
}

/// The next packet of a class's waiting pixels; takes them away.
template <class R>
ZERKALO_INLINE Mask<R> next_pixels(PacketPixels& packet, std::uint64_t& pixels) {
    auto active = mask_of<R>(false);
    int last = 0;
    for (int k = 0; k < kWidth<R>; ++k) {
        if (pixels != 0) {
            last = first_of(pixels);
            pixels &= pixels - 1;
            set_lane(active, k, true);
        }
        packet.of_lane[k] = static_cast<std::uint8_t>(last);
        packet.place_of_lane[k] = static_cast<std::uint8_t>(place_of_pixel<R>(last));
    }
    return active;
}

/// The waiting pixels of a class, packet by packet: which they are, and their lobes.
template <class R>
ZERKALO_INLINE void gather_class(const WaitingLobes& waiting, std::uint64_t pixels, ClassLobes<R>& lobes,
                                 PacketPixels* of_packet) {
    lobes.count = 0;
    while (pixels != 0) {
        PacketPixels& packet = of_packet[lobes.count];
        PacketLobes<R>& own = lobes.packets[lobes.count++];
        own.active = next_pixels<R>(packet, pixels);
        own.o = gather_vector<Length<R>>(waiting.o, packet);
        own.m = gather_vector<Direction<R>>(waiting.m, packet);
        own.base = tangents_of(own.m);
    }
}

/// Traces the lobes of all waiting pixels and adds what they see to the pixels' sums.
template <class R>
ZERKALO_ONCE void trace_lobes(const PlanFor<R>& plan, const WaitingLobes& waiting, std::uint32_t tile,
                              std::uint32_t camera_sample, LightSums& sums, TileCounts& counts) {
    const LatticeClasses classes = lattice_classes(tile);
    const CandidateMask candidates = solids_in(waiting.candidates);
    ClassRays own;
    ChunkWeights<Uniform<R>> weights;
    ClassLobes<R> lobes;
    PacketPixels of_packet[ClassLobes<R>::kMostPackets];
    LobeAim<R> aim;
    for (std::int32_t first = 0; first < plan.samples; first += kRayChunk) {
        const bool shared = first == 0 && camera_sample == 0 && !is_keyed(plan.sampling.estimator);
        if (!shared) fill_rays<R>(own, plan, plan.mirrors[0].lobe, tile, camera_sample, first);
        const ClassRays& rays = shared ? plan.mirrors[0].rays : own;
        fill_weights(weights, plan, first, rays.count);
        for (int c = 0; c < kLatticeClasses; ++c) {
            gather_class<R>(waiting, waiting.pixels & pixels_of_class(classes, c), lobes, of_packet);
            if (lobes.count == 0) continue;
            const RayChunk& chunk = rays.of_class[c];
            const bool aimed = !plan.exact_plan && aim_lobes<R>(aim, plan, candidates, chunk, rays.count, lobes);
            const LobeAim<R>* known = aimed ? &aim : nullptr;
            for (int p = 0; p < lobes.count; ++p) {
                if (aimed) stand_at<R>(aim, plan, lobes.packets[p].o);
                Rgb<LightSum<R>> sum = gather_sum<R>(sums, of_packet[p]);
                shoot_rays<R>(plan, chunk, rays.count, weights, lobes.packets[p], candidates, known, sum, counts);
                scatter_sum<R>(sums, of_packet[p], lobes.packets[p].active, sum);
            }
        }
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
