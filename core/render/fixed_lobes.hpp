// The lobes of a tile in fixed point, class by class: the pixels that wait for them, the rays that a class shares, and
// which of these may meet a solid.
#pragma once

#include "core/render/fixed_tile.hpp"
#include "core/render/trace.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The light of a tile's pixels, as raw integers, row-major.
struct LightSums {
    std::int64_t r[kTilePixels], g[kTilePixels], b[kTilePixels];
};

/// Pixels whose lobes must send rays: mirror points and mirror directions, as raw integers, and what the rays can meet.
struct WaitingLobes {
    std::int32_t o[3][kTilePixels], m[3][kTilePixels];
    std::uint64_t pixels;
    CandidateMask candidates;
};

/// The lanes of a packet as pixels of the tile; those past its end are copies of its last one.
struct PacketPixels {
    std::uint8_t of_lane[kWidestLane];
};

template <class L>
ZERKALO_INLINE void store_raw(std::remove_reference_t<decltype(lane_of(L{}.raw, 0))>* target, L x) {
    for (int k = 0; k < kLanesOf<typename L::Representation>; ++k) target[k] = lane_of(x.raw, k);
}
template <class L, class T>
ZERKALO_INLINE L gather_raw(const T* source, const PacketPixels& pixels) {
    L result{};
    for (int k = 0; k < kLanesOf<typename L::Representation>; ++k) set_lane(result.raw, k, source[pixels.of_lane[k]]);
    return result;
}
template <class L, class T>
ZERKALO_INLINE L load_raw(const T* source) {
    L result{};
    for (int k = 0; k < kLanesOf<typename L::Representation>; ++k) set_lane(result.raw, k, source[k]);
    return result;
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
ZERKALO_INLINE void enqueue(WaitingLobes& waiting, Mask<R> mask, const Vec3<Length<R>>& o, const Vec3<Direction<R>>& m,
                            CandidateMask candidates, int first) {
    store_raw(waiting.o[0] + first, o.x), store_raw(waiting.o[1] + first, o.y), store_raw(waiting.o[2] + first, o.z);
    store_raw(waiting.m[0] + first, m.x), store_raw(waiting.m[1] + first, m.y), store_raw(waiting.m[2] + first, m.z);
    waiting.pixels |= std::uint64_t{bits_of(mask)} << first;
    waiting.candidates |= candidates;
}

/// What one ray of a lobe counts for.
template <class R>
ZERKALO_INLINE Rgb<Weight<R>> part_of_lobe(const PlanFor<R>& plan) {
    return as<Weight<R>>(scaled(spread<Weight<R>>(plan.mirrors[0].reflectance), one_part_of<R>(plan.samples)));
}

/// Adds what the rays from o along d see, times the throughput: solids, or the background, but for mirrors.
template <class R>
ZERKALO_INLINE AnyHit<R> add_seen(const PlanFor<R>& plan, CandidateMask candidates, bool aimed, Vec3<Length<R>> o,
                                  Vec3<Direction<R>> d, const Departure<R>& from, Mask<R> active,
                                  Rgb<Weight<R>> throughput, Rgb<LightSum<R>>& sum, TileCounts& counts) {
    const AnyHit<R> hit =
        nearest_anywhere<R>(plan, candidates, aimed, o, d, from, active, Length<R>(0), false);
    const auto hits = active & (hit.id >= Index<R>(0));
    const auto misses = active & (!hits);
    if (any(misses)) add<R>(sum, misses, throughput, spread<Radiance<R>>(plan.background));
    if (none(hits)) return hit;
    light_solids<R>(plan, candidates, hit, o, d, active, throughput, sum, counts, [](const auto&...) {});
    return hit;
}

constexpr std::int32_t kFixedChunk = 32;

/// A run of the rays of each class, in the lobe's frame.
template <class R>
struct ClassRays {
    using One = Uniform<R>;
    std::int32_t count;
    LobePoint<One> of_class[kLatticeClasses][kFixedChunk];
};

/// Rays first, first + 1, ... of all classes.
template <class R>
ZERKALO_ONCE void fill_rays(ClassRays<R>& rays, const PlanFor<R>& plan, std::uint32_t tile, std::uint32_t camera_sample,
                            std::int32_t first) {
    using One = Uniform<R>;
    const Sampling& sampling = plan.sampling;
    const auto exponent = Share<One>(plan.mirrors[0].lobe.inverse_exponent);
    const std::int32_t left = plan.samples - first;
    rays.count = left < kFixedChunk ? left : kFixedChunk;
    PathKey<One> keys[kLatticeClasses]{};
    for (int c = 0; c < kLatticeClasses; ++c) {
        keys[c].turn = phase_of<One>(phase_of_class(sampling, c, camera_sample));
        if (is_keyed(sampling.estimator)) keys[c].set = set_of_class(sampling, tile, c, camera_sample);
    }
    for (std::int32_t i = 0; i < rays.count; ++i) {
        LobePolar<One> polar{};
        for (int c = 0; c < kLatticeClasses; ++c) {
            const SetPoint<One> at = place_of_ray<One>(plan, keys[c], first + i);
            // Of a lattice the classes differ in their turn alone.
            if (c == 0 || is_keyed(sampling.estimator)) polar = lobe_polar(at.u, exponent);
            rays.of_class[c][i] = at_azimuth(polar, at.turn);
        }
    }
}

/// The rays of a chunk, for a packet of one class. `job`: aimed from o along m.
template <class R>
ZERKALO_INLINE void shoot_rays(const PlanFor<R>& plan, const LobePoint<Uniform<R>>* rays, std::int32_t count,
                               const LobeJob<R>& job, std::int32_t& missed, Vec3<Length<R>> o, Vec3<Direction<R>> m,
                               Mask<R> active, CandidateMask candidates, Rgb<LightSum<R>>& sum, TileCounts& counts) {
    using D = Direction<R>;
    const Rgb<Weight<R>> part = part_of_lobe<R>(plan);
    const Departure<R> from{index_of<R>(kMaxSolids), Index<R>(0), mask_of<R>(false)};
    const bool aimed = job.target_count > 0;
    counts.lobe += count_of(active) * static_cast<std::uint32_t>(count);
    for (std::int32_t i = 0; i < count; ++i) {
        const LobePoint<R> point{D(rays[i].side), D(rays[i].up), D(rays[i].forward)};
        const CandidateMask met = aimed ? solids_met<R>(job, point, active) : candidates;
        if (aimed && met == 0) {
            ++missed;
            continue;
        }
        const LobeRay<R> ray = lobe_ray<R>(point, m, job.base, job.n, job.max_phong);
        const auto below = active & (!ray.above) & (!job.max_phong);
        if (any(below)) add<R>(sum, below, part, spread<Radiance<R>>(plan.background));
        const auto above = active & ray.above;
        if (none(above)) continue;
        const Rgb<Weight<R>> throughput = any(job.max_phong) ? as<Weight<R>>(scaled(part, ray.weight)) : part;
        add_seen<R>(plan, met, aimed, o, ray.d, from, above, throughput, sum, counts);
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
    using S = LightSum<R>;
    const MirrorPlanFor<R>& mirror = plan.mirrors[0];
    const LatticeClasses classes = lattice_classes(tile);
    const LobeStart<R> start{spread<D>(mirror.shape.n), Share<R>(mirror.lobe.inverse_exponent), D(mirror.lobe.alpha),
                             mask_of<R>(mirror.lobe.max_phong != 0), mask_of<R>(false)};
    ClassRays<R> rays;
    LobeJob<R> job;
    for (std::int32_t first = 0; first < plan.samples; first += kFixedChunk) {
        fill_rays<R>(rays, plan, tile, camera_sample, first);
        for (int c = 0; c < kLatticeClasses; ++c) {
            std::uint64_t pixels = waiting.pixels & pixels_of_class(classes, c);
            while (pixels != 0) {
                PacketPixels packet;
                const Mask<R> active = next_pixels<R>(packet, pixels);
                const Vec3<L> o{gather_raw<L>(waiting.o[0], packet), gather_raw<L>(waiting.o[1], packet),
                                gather_raw<L>(waiting.o[2], packet)};
                const Vec3<D> m{gather_raw<D>(waiting.m[0], packet), gather_raw<D>(waiting.m[1], packet),
                                gather_raw<D>(waiting.m[2], packet)};
                Rgb<S> sum{gather_raw<S>(sums.r, packet), gather_raw<S>(sums.g, packet), gather_raw<S>(sums.b, packet)};
                aim_job<R>(plan, start, job, o, m, waiting.candidates);
                std::int32_t missed = 0;
                shoot_rays<R>(plan, rays.of_class[c], rays.count, job, missed, o, m, active, waiting.candidates, sum,
                              counts);
                add_missed<R>(plan, active, part_of_lobe<R>(plan), missed, sum);
                for (int k = 0; k < kWidth<R> && lane_of(active, k); ++k) {
                    const int pixel = packet.of_lane[k];
                    sums.r[pixel] = lane_of(sum.r.raw, k);
                    sums.g[pixel] = lane_of(sum.g.raw, k);
                    sums.b[pixel] = lane_of(sum.b.raw, k);
                }
            }
        }
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
