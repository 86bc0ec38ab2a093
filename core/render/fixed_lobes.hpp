// The lobes of a tile in fixed point, class by class: the pixels that wait for them, and their rays.
#pragma once

#include "core/render/fixed_aim.hpp"
#include "core/render/packet.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The light of a tile's pixels, as raw integers, row-major.
struct LightSums {
    alignas(64) std::int64_t r[kTilePixels], g[kTilePixels], b[kTilePixels];
};

/// Pixels whose lobes must send rays: mirror points and mirror directions, as raw integers, and what the rays can meet.
struct WaitingLobes {
    alignas(64) std::int32_t o[3][kTilePixels], m[3][kTilePixels];
    std::uint64_t pixels;
    CandidateMask candidates;
};

/// The lanes of a packet as pixels of the tile; those past its end are copies of its last one.
struct PacketPixels {
    std::uint8_t of_lane[kWidestLane];
};

template <class L>
ZERKALO_INLINE L gather_raw(const typename L::Element* source, const PacketPixels& pixels) {
    constexpr int kLanes = kLanesOf<typename L::Representation>;
    alignas(64) typename L::Element lanes[kLanes];
    for (int k = 0; k < kLanes; ++k) lanes[k] = source[pixels.of_lane[k]];
    return load_raw<L>(lanes);
}

template <class R>
ZERKALO_INLINE void store_sum(LightSums& sums, int first, const Rgb<LightSum<R>>& sum) {
    store_raw(sums.r + first, sum.r), store_raw(sums.g + first, sum.g), store_raw(sums.b + first, sum.b);
}
template <class R>
ZERKALO_INLINE Rgb<LightSum<R>> load_sum(const LightSums& sums, int first) {
    using S = LightSum<R>;
    return {load_raw<S>(sums.r + first), load_raw<S>(sums.g + first), load_raw<S>(sums.b + first)};
}
template <class R>
ZERKALO_INLINE Rgb<LightSum<R>> gather_sum(const LightSums& sums, const PacketPixels& pixels) {
    using S = LightSum<R>;
    return {gather_raw<S>(sums.r, pixels), gather_raw<S>(sums.g, pixels), gather_raw<S>(sums.b, pixels)};
}
/// The active lanes come first.
template <class R>
ZERKALO_INLINE void scatter_sum(LightSums& sums, const PacketPixels& pixels, Mask<R> active,
                                const Rgb<LightSum<R>>& sum) {
    alignas(64) std::int64_t r[kWidth<R>], g[kWidth<R>], b[kWidth<R>];
    store_raw(r, sum.r), store_raw(g, sum.g), store_raw(b, sum.b);
    const auto count = static_cast<int>(count_of(active));
    for (int k = 0; k < count; ++k) {
        const int pixel = pixels.of_lane[k];
        sums.r[pixel] = r[k], sums.g[pixel] = g[k], sums.b[pixel] = b[k];
    }
}

template <class R>
ZERKALO_INLINE void enqueue(WaitingLobes& waiting, Mask<R> mask, const Vec3<Length<R>>& o, const Vec3<Direction<R>>& m,
                            int first) {
    store_raw(waiting.o[0] + first, o.x), store_raw(waiting.o[1] + first, o.y), store_raw(waiting.o[2] + first, o.z);
    store_raw(waiting.m[0] + first, m.x), store_raw(waiting.m[1] + first, m.y), store_raw(waiting.m[2] + first, m.z);
    waiting.pixels |= std::uint64_t{bits_of(mask)} << first;
}

/// The background, for rays of the chunk that begins with ray `first`.
template <class R>
ZERKALO_INLINE void add_missed_of(const PlanFor<R>& plan, Mask<R> mask, Rgb<Weight<R>> full, std::int32_t first,
                                  RayMask missed, Rgb<LightSum<R>>& sum) {
    const std::int32_t rim = rays_at_rim(plan.sampling.estimator, plan.samples) - first;
    RayMask at_rim = rim <= 0 ? 0 : missed & first_rays(rim < kRayChunk ? rim : kRayChunk);
    add_missed<R>(plan, mask, full, count_of_rays(missed & ~at_rim), sum);
    for (; at_rim != 0; at_rim &= at_rim - 1) {
        const Rgb<Weight<R>> throughput = throughput_of_ray<R>(plan, full, first + first_of(at_rim));
        add<R>(sum, mask, throughput, spread<Radiance<R>>(plan.background));
    }
}

template <class R>
struct WaitingPacket {
    Vec3<Length<R>> o;
    Vec3<Direction<R>> m;
    Mask<R> active;
};
template <class R>
ZERKALO_INLINE WaitingPacket<R> load_waiting(const WaitingLobes& waiting, int first) {
    using L = Length<R>;
    using D = Direction<R>;
    return {{load_raw<L>(waiting.o[0] + first), load_raw<L>(waiting.o[1] + first), load_raw<L>(waiting.o[2] + first)},
            {load_raw<D>(waiting.m[0] + first), load_raw<D>(waiting.m[1] + first), load_raw<D>(waiting.m[2] + first)},
            lanes_of_bits<R>(waiting.pixels >> first)};
}

/// The largest component: at least the distance over the root of 3.
template <class L>
ZERKALO_INLINE L largest_of(const Vec3<L>& v) {
    return max(max(absolute(v.x), absolute(v.y)), absolute(v.z));
}

/// Solids that some waiting pixel's lobe may be near, by the lobe of the first one: the others' points and directions
/// stray from it.
template <class R>
ZERKALO_INLINE CandidateMask solids_near_lobes(const PlanFor<R>& plan, const WaitingLobes& waiting) {
    using One = Uniform<R>;
    using L = Length<R>;
    using D = Direction<R>;
    const int pilot = first_of(waiting.pixels);
    const WaitingPacket<One> at = load_waiting<One>(waiting, pilot);
    L stray(0);
    D turn(0);
    for (int first = 0; first < kTilePixels; first += kWidth<R>) {
        const WaitingPacket<R> packet = load_waiting<R>(waiting, first);
        if (none(packet.active)) continue;
        const L off = largest_of(fitting_difference(packet.o, spread<L>(at.o)));
        stray = max(stray, select(packet.active, off, L(0)));
        turn = max(turn, select(packet.active, largest_of(packet.m - spread<D>(at.m)), D(0)));
    }
    // More than the root of the packets' own room.
    constexpr auto kRoom = Length<One>::from_raw(1 << 18);
    const auto most_off = largest_lane_of(stray), most_angle = as<Length<One>>(largest_lane_of(turn));
    const auto most_stray = most_off + most_off + kRoom, most_turn = most_angle + most_angle;
    CandidateMask near = 0;
    for (std::int32_t k = 0; k < plan.solid_count; ++k) {
        const auto way = plan.solids[k].bound_centre - at.o;
        const auto far = root<Length<One>>(dot_of_ways(way, way)) + kRoom;
        const auto around = most_stray + as<Length<One>>(far * most_turn);
        if (cone_may_meet<One>(plan.solids[k], plan.mirrors[0].lobe, at.o, at.m, around)) near |= CandidateMask{1} << k;
    }
    return near;
}

/// Takes away the pixels whose lobes meet nothing, with their light; finds what the others can meet.
template <class R>
ZERKALO_ONCE void cull_lobes(const PlanFor<R>& plan, WaitingLobes& waiting, LightSums& sums) {
    const LobeFor<R>& lobe = plan.mirrors[0].lobe;
    const bool narrow = !plan.exact_plan && lobe.cone.narrow;
    const CandidateMask solids = narrow ? solids_near_lobes<R>(plan, waiting) : solids_in(all_of(plan));
    std::uint64_t sending = 0;
    waiting.candidates = 0;
    for (int first = 0; first < kTilePixels; first += kWidth<R>) {
        const WaitingPacket<R> packet = load_waiting<R>(waiting, first);
        if (none(packet.active)) continue;
        Rgb<LightSum<R>> sum = load_sum<R>(sums, first);
        CandidateMask candidates;
        const Mask<R> with_rays = lanes_with_rays<R>(plan, lobe, packet.o, packet.m, full_throughput<R>(plan),
                                                     packet.active, candidates, sum, solids);
        store_sum<R>(sums, first, sum);
        sending |= std::uint64_t{bits_of(with_rays)} << first;
        waiting.candidates |= candidates;
    }
    waiting.pixels = sending;
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

/// What the lobes of a packet share.
template <class R>
struct PacketLobes {
    Vec3<Length<R>> o;
    Vec3<Direction<R>> m;
    Tangents<Direction<R>> base;
    Mask<R> active, max_phong;
    CandidateMask candidates;
    bool aimed;
};

/// The rays of a chunk, for a packet of one class.
template <class R>
ZERKALO_INLINE void shoot_rays(const PlanFor<R>& plan, const RayChunk& rays, std::int32_t first, std::int32_t count,
                               const PacketLobes<R>& lobes, const LobeAim<R>& aim, Rgb<LightSum<R>>& sum,
                               TileCounts& counts) {
    using D = Direction<R>;
    using One = Direction<Uniform<R>>;
    const bool weighted = plan.mirrors[0].lobe.max_phong;
    const Rgb<Weight<R>> full = full_throughput<R>(plan);
    const Vec3<D> n = spread<D>(plan.mirrors[0].shape.n);
    counts.lobe += count_of(lobes.active) * static_cast<std::uint32_t>(count);
    // Each ray of max-Phong has a weight of its own, also where it meets nothing.
    RayMask left = first_rays(count);
    if (lobes.aimed && !weighted) {
        left &= aim.rays;
        add_missed_of<R>(plan, lobes.active, full, first, first_rays(count) & ~left, sum);
    }
    for (; left != 0; left &= left - 1) {
        const std::int32_t i = first_of(left);
        const LobePoint<R> point{D(One::from_raw(rays.side[i])), D(One::from_raw(rays.up[i])),
                                 D(One::from_raw(rays.forward[i]))};
        const LobeRay<R> ray = lobe_ray<R>(point, lobes.m, lobes.base, n, lobes.max_phong);
        const Rgb<Weight<R>> part = throughput_of_ray<R>(plan, full, first + i);
        const auto below = lobes.active & (!ray.above);
        if (!weighted && any(below)) add<R>(sum, below, part, spread<Radiance<R>>(plan.background));
        const Mask<R> above = lobes.active & ray.above;
        if (none(above)) continue;
        const Rgb<Weight<R>> throughput = weighted ? as<Weight<R>>(scaled(part, ray.weight)) : part;
        CandidateMask asked = 0;
        Nearest<R> near;
        if (lobes.aimed) {
            near = nearest_aimed<R>(plan, aim, i, ray.d, above, asked);
        } else {
            asked = lobes.candidates;
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
    }
    return active;
}

/// Traces the lobes of all waiting pixels and adds what they see to the pixels' sums.
template <class R>
ZERKALO_ONCE void trace_lobes(const PlanFor<R>& plan, const WaitingLobes& waiting, std::uint32_t tile,
                              std::uint32_t camera_sample, LightSums& sums, TileCounts& counts) {
    using L = Length<R>;
    using D = Direction<R>;
    const LatticeClasses classes = lattice_classes(tile);
    ClassRays own;
    LobeAim<R> aim;
    for (std::int32_t first = 0; first < plan.samples; first += kRayChunk) {
        const bool shared = first == 0 && camera_sample == 0 && !is_keyed(plan.sampling.estimator);
        if (!shared) fill_rays<R>(own, plan, plan.mirrors[0].lobe, tile, camera_sample, first);
        const ClassRays& rays = shared ? plan.mirrors[0].rays : own;
        for (int c = 0; c < kLatticeClasses; ++c) {
            std::uint64_t pixels = waiting.pixels & pixels_of_class(classes, c);
            const RayChunk& chunk = rays.of_class[c];
            while (pixels != 0) {
                PacketPixels packet;
                PacketLobes<R> lobes;
                lobes.active = next_pixels<R>(packet, pixels);
                lobes.max_phong = mask_of<R>(plan.mirrors[0].lobe.max_phong != 0);
                lobes.candidates = solids_in(waiting.candidates);
                lobes.o = {gather_raw<L>(waiting.o[0], packet), gather_raw<L>(waiting.o[1], packet),
                           gather_raw<L>(waiting.o[2], packet)};
                lobes.m = {gather_raw<D>(waiting.m[0], packet), gather_raw<D>(waiting.m[1], packet),
                           gather_raw<D>(waiting.m[2], packet)};
                lobes.base = tangents_of(lobes.m);
                lobes.aimed = !plan.exact_plan && aim_lobes<R>(aim, plan, lobes.candidates, chunk, rays.count, lobes.o,
                                                               lobes.m, lobes.base);
                Rgb<LightSum<R>> sum = gather_sum<R>(sums, packet);
                shoot_rays<R>(plan, chunk, first, rays.count, lobes, aim, sum, counts);
                scatter_sum<R>(sums, packet, lobes.active, sum);
            }
        }
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
