// The fixed-point kernel for scenes whose rays bounce at most once (the scenes of one_bounce.hpp). The same light as
// the general kernel's, to the last bit: its sums are exact, so they may be added in any order.
//
//     camera rays -> local light; the mirror's pixels wait -> those whose lobe meets nothing leave -> their lobes
//
// Lobes that no solid is near see the background alone. The others of one class share the directions of their rays, in
// the lobe's own frame: which of them may meet a solid is asked once for a packet, with rays in the lanes.
#pragma once

#include "core/render/fixed_lobes.hpp"
#include "core/render/general.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// What the only mirror's front reflects: one ray on, or a lobe that waits.
template <class R>
ZERKALO_INLINE void reflect_once(const PlanFor<R>& plan, const MirrorSpot<R>& at, Vec3<Direction<R>> d, int first,
                                 WaitingLobes& waiting, Rgb<LightSum<R>>& sum, TileCounts& counts) {
    using W = Weight<R>;
    const MirrorPlanFor<R>& mirror = plan.mirrors[0];
    const Vec3<Direction<R>> m = reflect(d, at.n);
    if (mirror.lobe.glossy) {
        enqueue<R>(waiting, at.front, at.p, m, first);
        return;
    }
    counts.reflected += count_of(at.front);
    const CandidateMask solids = first_bits(plan.solid_count);
    const Nearest<R> near = nearest_from_mirror<R>(plan, solids, at.p, m, at.front);
    add_nearest<R>(plan, solids, near, at.p, m, at.front, spread<W>(mirror.reflectance), sum, counts);
}

/// The light that comes along the camera rays of one packet, without what waits.
template <class R>
ZERKALO_INLINE Rgb<LightSum<R>> camera_light(const PlanFor<R>& plan, const TileView& view, const CameraRay<R>& camera,
                                             Mask<R> active, int first, WaitingLobes& waiting, TileCounts& counts) {
    using W = Weight<R>;
    const Rgb<W> whole{W(1), W(1), W(1)};
    Rgb<LightSum<R>> sum{LightSum<R>(0), LightSum<R>(0), LightSum<R>(0)};
    const Nearest<R> near =
        nearest_from<R>(plan, view.seen, plan.camera_origin, plan.camera.origin, camera.d, active);
    auto here = mask_of<R>(false);
    MirrorHit<System<R>> crossing;
    if (mirrors_in(view.seen) != 0) {
        crossing = plane_mirror_hit<System<R>>(plan.mirrors[0].shape, plan.camera_origin.mirrors[0], camera.d,
                                               Length<R>(0));
        here = active & crossing.hit & (crossing.t < near.t);
    }
    add_nearest<R>(plan, view.seen, near, camera.o, camera.d, active & (!here), whole, sum, counts);
    if (none(here)) return sum;
    const AnyHit<R> hit{crossing.t, Index<R>(0), Index<R>(0), mask_of<R>(false), crossing.x, crossing.y, crossing.z};
    const MirrorSpot<R> at =
        light_mirror<R>(plan, 0, view.mirror_blockers, hit, camera.o, camera.d, here, whole, sum, counts);
    if (plan.mirrors[0].reflects && any(at.front)) reflect_once<R>(plan, at, camera.d, first, waiting, sum, counts);
    return sum;
}

/// The same of a tile's camera sample a. Called, not inlined: what it has on the stack is gone once lobes are traced.
template <class R>
ZERKALO_ONCE void trace_camera_rays(const PlanFor<R>& plan, const TileView& view, const Tile& tile, std::int32_t a,
                                    LightSums& sums, WaitingLobes& waiting, TileCounts& counts) {
    const auto at = sub_pixel<Uniform<R>>(a, plan.antialias);
    TileColumns<R> columns;
    fill_columns(columns, plan, tile, at);
    waiting.pixels = 0;
    for (int first = 0; first < tile.height * kTileSide; first += kWidth<R>) {
        const auto active = lanes_of<R>(tile, first);
        if (none(active)) continue;
        const CameraRay<R> camera = camera_ray<R>(plan, columns, tile, first, at);
        store_sum<R>(sums, first, camera_light<R>(plan, view, camera, active, first, waiting, counts));
    }
}

/// Renders one tile. Precondition: plan.features without kNeedsGeneral.
template <class R>
ZERKALO_ONCE void render_tile_one_bounce_fixed(const PlanFor<R>& plan, const Tile& tile, const LinearImage& image,
                                               RayCounts& counts) {
    counts.primary += camera_rays(plan, tile);
    const TileView view = view_of_tile<R>(plan, tile);
    if (view.seen == 0) return fill_tile<R>(plan, tile, image);
    FixedColours colours;
    LightSums sums;
    WaitingLobes waiting;
    TileCounts tile_counts;
    for (std::int32_t a = 0; a < plan.antialias; ++a) {
        trace_camera_rays<R>(plan, view, tile, a, sums, waiting, tile_counts);
        if (waiting.pixels != 0) cull_lobes<R>(plan, waiting, sums);
        if (waiting.pixels != 0) {
            trace_lobes<R>(plan, waiting, tile_hash(plan, tile), static_cast<std::uint32_t>(a), sums, tile_counts);
        }
        for (int first = 0; first < tile.height * kTileSide; first += kWidth<R>) {
            put(colours, first, load_sum<R>(sums, first), a > 0);
        }
    }
    if (plan.antialias > 1) average<R>(colours, plan.antialias);
    write_tile<R>(plan, colours, tile, image);
    counts.reflected += tile_counts.reflected;
    counts.lobe += tile_counts.lobe;
    counts.shadow += tile_counts.shadow;
}

/// Renders one tile of any scene, by the smaller kernel that can. `general_alone`: only scenes that need the general
/// kernel; more than eight lanes: none of these.
template <class R, bool general_alone = false>
ZERKALO_INLINE void render_tile_fixed(const PlanFor<R>& plan, const Tile& tile, const LinearImage& image,
                                      RayCounts& counts) {
    if constexpr (general_alone) {
        render_tile_general<R>(plan, tile, image, counts);
    } else if constexpr (kWidth<R> > 8) {
        render_tile_one_bounce_fixed<R>(plan, tile, image, counts);
    } else if (plan.features & kNeedsGeneral) {
        render_tile_general<R>(plan, tile, image, counts);
    } else {
        render_tile_one_bounce_fixed<R>(plan, tile, image, counts);
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
