// The kernel for every scene: chains and trees of rays, curved mirrors, meshes, cameras anywhere (render/trace.hpp).
#pragma once

#include "core/render/fixed_tile.hpp"
#include "core/render/packet.hpp"
#include "core/render/render.hpp"
#include "core/render/spread.hpp"
#include "core/render/trace.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class R>
ZERKALO_INLINE PathPacket<R> no_continuation(const PlanFor<R>& plan, const PathPacket<R>& ray) {
    PathPacket<R> next = ray;
    next.active = mask_of<R>(false);
    next.candidates = all_of(plan);
    next.aimed = false;
    next.depth = ray.depth + 1;
    return next;
}

/// What the rays of one packet see; their continuations go onto the stack, jobs last.
template <class R>
ZERKALO_INLINE void trace_one(const PlanFor<R>& plan, const TileView& view, const PathPacket<R>& ray, Length<R> t_min,
                              const PathKey<R>& key, PathStack<R>& stack, Rgb<LightSum<R>>& sum,
                              TileCounts& counts) {
    const bool close = ray.depth == 0 && (plan.features & kFeatureInside) != 0;
    const AnyHit<R> hit =
        nearest_anywhere<R>(plan, ray.candidates, ray.aimed, ray.o, ray.d, ray.from, ray.active, t_min, close);
    const auto hits = ray.active & (hit.id >= Index<R>(0));
    add<R>(sum, ray.active & (!hits), ray.throughput, spread<Radiance<R>>(plan.background));
    if (none(hits)) return;
    const Vec3<Direction<R>> zero = {Direction<R>(0), Direction<R>(0), Direction<R>(0)};
    // Each is made in place: one to copy would take a packet's room on the stack.
    const auto fresh = [&]() ZERKALO_INLINE_LAMBDA { return no_continuation(plan, ray); };
    Continuations<R> next{fresh(), fresh(), fresh(),
                          {zero, Share<R>(0), Direction<R>(0), mask_of<R>(false), mask_of<R>(false)}};
    next.job.is_job = true;
    next.job.sample = 0;
    next.job.candidates = 0;
    shade_solids<R>(plan, ray, hit, sum, next, counts);
    shade_mirrors<R>(plan, view, ray, hit, key, sum, next, counts);
    if (any(next.two.active)) stack.push(next.two);
    if (any(next.one.active)) stack.push(next.one);
    if (any(next.job.active)) {
        stack.push(next.job);
        aim_job<R>(plan, next.lobe, stack.lobe, next.job.o, next.job.d, next.job.candidates);
    }
}

/// Takes the next packet of rays off the stack: a waiting one, or the next lattice ray of the job on top.
/// Returns false where all rays of the job's step are done with.
template <class R>
ZERKALO_ONCE bool next_packet(const PlanFor<R>& plan, PathStack<R>& stack, const PathKey<R>& key, PathPacket<R>& ray,
                                Rgb<LightSum<R>>& sum, TileCounts& counts) {
    PathPacket<R>& top = stack.packets[stack.count - 1];
    if (!top.is_job) {
        ray = top;
        --stack.count;
        return true;
    }
    const std::int32_t s = top.sample++;
    const bool last = top.sample == plan.samples;
    if (last) --stack.count;
    LobeJob<R>& job = stack.lobe;
    const LobePoint<R> point = point_of_job<R>(plan, stack.rows, job, key, s, top.active);
    const Rgb<Weight<R>> throughput = throughput_of_ray<R>(plan, top.throughput, s);
    CandidateMask candidates = top.candidates;
    if constexpr (Formats<R>::kFixed) {
        if (job.target_count > 0) {
            candidates = solids_met<R>(job, point, top.active);
            const bool at_rim = s < rays_at_rim(plan.sampling.estimator, plan.samples), passed = candidates == 0;
            if (passed && at_rim) add<R>(sum, top.active, throughput, spread<Radiance<R>>(plan.background));
            job.missed += passed && !at_rim;
            if (last) add_missed<R>(plan, top.active, top.throughput, job.missed, sum);
            if (passed) {
                counts.lobe += count_of(top.active);
                ray.after_lobe = false;  // nothing was added for it alone
                return false;
            }
        }
    }
    ray = top;
    ray.active = mask_of<R>(false);
    ray.candidates = candidates;
    ray.aimed = job.target_count > 0;
    ray.is_job = false;
    ray.after_lobe = true;
    ray.sample = s;
    LobeRay<R> lobe = lobe_ray<R>(point, top.d, job.base, job.n, job.max_phong);
    if (plan.features & kFeatureGgx) {
        lobe = select<R>(job.ggx, ggx_ray<R>(place_of_ray<R>(plan, key, s), top.d, job.n, job.alpha), lobe);
    }
    go_on_in_lobe<R>(plan, lobe, job.max_phong | job.ggx, top.active, top.o, throughput, top.from.id, ray, sum, counts);
    return any(ray.active);
}

/// The light that comes along the camera rays of one packet.
template <class R>
ZERKALO_INLINE Rgb<LightSum<R>> trace_packet(const PlanFor<R>& plan, const TileView& view, const CameraRay<R>& camera,
                                             Mask<R> active, const PathKey<R>& key, PathStack<R>& stack,
                                             LobeParts<R>* parts, TileCounts& counts) {
    using W = Weight<R>;
    Rgb<LightSum<R>> sum{LightSum<R>(0), LightSum<R>(0), LightSum<R>(0)};
    const Departure<R> from = departure_of_camera<R>(plan.camera, camera.d);
    stack.count = 0;
    stack.push(
        PathPacket<R>{camera.o, camera.d, {W(1), W(1), W(1)}, from, active, view.seen, false, 0, false, false, 0});
    while (stack.count > 0) {
        PathPacket<R> ray;
        const Rgb<LightSum<R>> before = sum;
        if (next_packet<R>(plan, stack, key, ray, sum, counts)) {
            trace_one<R>(plan, view, ray, ray.depth == 0 ? camera.t_min : Length<R>(0), key, stack, sum, counts);
        }
        if (parts && ray.after_lobe) note(*parts, ray.sample, sum, before);
    }
    return sum;
}

template <class R>
ZERKALO_INLINE PathKey<R> path_key(const PlanFor<R>& plan, const Rect& tile, int first, std::uint32_t camera_sample) {
    alignas(64) Phase<Uniform<R>> turns[kWidth<R>];
    alignas(64) std::uint32_t pixels[kWidth<R>], keys[kWidth<R>], halves[kWidth<R>];
    const std::uint32_t hash = tile_hash(plan, tile);
    const LatticeClasses classes = lattice_classes(hash);
    const bool keyed = is_keyed(plan.sampling.estimator);
    const LatticePart part = lattice_part(plan.sampling, camera_sample, plan.antialias);
    PathKey<R> key{{}, camera_sample, part, {}, mask_of<R>(false), mask_of<R>(false), {}};
    for (int lane = 0; lane < kWidth<R>; ++lane) {
        const int x = (first + lane) % kTileSide, y = (first + lane) / kTileSide;
        const int lattice_class = class_of_pixel(classes, first + lane);
        turns[lane] = phase_of<Uniform<R>>(phase_of_class(plan.sampling, lattice_class));
        const SetChoice<std::uint32_t> set =
            keyed ? set_of_class(plan.sampling, hash, lattice_class, camera_sample) : SetChoice<std::uint32_t>{0, 0};
        keys[lane] = set.key, halves[lane] = set.half;
        pixels[lane] = static_cast<std::uint32_t>(tile.top + y) * static_cast<std::uint32_t>(plan.width) +
                       static_cast<std::uint32_t>(tile.left + x);
    }
    if constexpr (Formats<R>::kFixed) {
        for (int lane = 0; lane < kWidth<R>; ++lane) {
            set_lane(key.class_low, lane, (classes.low >> (first + lane) & 1) != 0);
            set_lane(key.class_high, lane, (classes.high >> (first + lane) & 1) != 0);
        }
    }
    key.pixel = load_bits<R>(pixels);
    key.turn = load_phases<R>(turns);
    if (keyed) key.set = {load_bits<R>(keys), load_bits<R>(halves)};
    return key;
}

/// Renders one tile of any scene. R: the lanes, or the fixed-point system.
template <class R>
inline void render_tile_general(const PlanFor<R>& plan, const Tile& tile, const LinearImage& image, RayCounts& counts,
                                TileSpread* spread_of_tile = nullptr) {
    counts.primary += camera_rays(plan, tile);
    const TileView view = view_of_tile<R>(plan, tile);
    if (view.seen == 0) return fill_tile<R>(plan, tile, image);
    TileColoursFor<R> colours;
    TileCounts tile_counts;
    PathStack<R> stack;
    const bool lobes =
        (plan.features & kFeatureGlossy) != 0 && (mirrors_in(view.seen) != 0 || (plan.features & kFeatureChain) != 0);
    for (std::int32_t a = 0; a < plan.antialias; ++a) {
        const auto at = sub_pixel<Uniform<R>>(a, plan.antialias);
        TileColumns<R> columns;
        fill_columns(columns, plan, tile, at);
        for (int first = 0; first < tile.height * kTileSide; first += kWidth<R>) {
            const auto active = lanes_of<R>(tile, first);
            if (none(active)) continue;
            const PathKey<R> key =
                lobes ? path_key<R>(plan, tile, first, static_cast<std::uint32_t>(a)) : PathKey<R>{};
            LobeParts<R> parts{};
            const CameraRay<R> camera = camera_ray<R>(plan, columns, tile, first, at);
            put(colours, first,
                trace_packet<R>(plan, view, camera, active, key, stack, spread_of_tile ? &parts : nullptr, tile_counts),
                a > 0);
            if (spread_of_tile) add_variance(*spread_of_tile, first, plan, parts);
        }
    }
    if (plan.antialias > 1) average<R>(colours, plan.antialias);
    if constexpr (kTells<R>) {
        if (spread_of_tile) average(*spread_of_tile, plan.antialias);
    }
    write_tile<R>(plan, colours, tile, image);
    counts.reflected += tile_counts.reflected;
    counts.lobe += tile_counts.lobe;
    counts.refracted += tile_counts.refracted;
    counts.shadow += tile_counts.shadow;
}

}  // namespace zerkalo::inline ZERKALO_ISA
