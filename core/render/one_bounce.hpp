// The kernel for scenes whose rays bounce at most once: opaque solids and at most one plane mirror, seen from outside.
//
//     camera ray -> nearest surface -> local light            (seed formula 1.5: ambient, Lambert, Phong)
//                -> mirror: F K_r I_r, one ray or a lobe      (I_r K_r; the lobe: render/gloss.hpp)
//                -> solid seen in it -> local light
#pragma once

#include "core/render/gloss.hpp"
#include "core/render/lobe_tile.hpp"
#include "core/render/render.hpp"

#include <type_traits>

namespace zerkalo::inline ZERKALO_ISA {

/// I_r of a polished mirror: what its one ray sees.
template <class R>
ZERKALO_INLINE Rgb<R> sharp_reflection(const Plan& plan, const TileView& view, const Spot<R>& spot,
                                       TileCounts& counts) {
    counts.reflected += count_of(spot.active);
    const Rgb<R> background = spread<R>(plan.background);
    const Vec3<R> m = reflect(spot.d, spot.n);
    const Nearest<R> near = nearest_solid(plan, view.in_mirror, PointOrigin<R>{spot.p}, m);
    const auto hit = spot.active & (near.id >= R(0));
    return solid_light(plan, view.in_mirror, near, spot.p, m, hit, background, counts);
}

/// Puts the pixels whose lobe may meet a solid into the queue; returns the closed form for the others, 0 for these.
template <class R>
ZERKALO_INLINE Rgb<R> queue_gloss(const Plan& plan, const TileView& view, const Spot<R>& spot, int first,
                                  GlossQueues& queues) {
    const LobeData& lobe = plan.mirrors[0].lobe;
    const Vec3<R> m = reflect(spot.d, spot.n);
    const Rgb<float>& background = plan.background;
    const bool weigh_all = lobe.max_phong && (background.r != 0 || background.g != 0 || background.b != 0);
    auto waiting = spot.active & Mask<R>(plan.exact_plan || weigh_all);
    if (none(waiting)) {
        for (CandidateMask left = view.in_lobe; left != 0; left &= left - 1) {
            waiting = waiting | (spot.active & lobe_may_meet(plan.solids[first_of(left)], lobe, spot.p, m));
            if (none((!waiting) & spot.active)) break;
        }
    }
    if (any(waiting)) enqueue(queues, waiting, spot.p, m, first);
    return select(waiting, spread<R>(Rgb<float>{0, 0, 0}), spread<R>(background));
}

/// What the mirror does with a ray: one ray on, a lobe of rays, or a lobe whose solids are covered before its rays.
enum class Bounce { sharp, lobe, covered_lobe };

/// The colours of one packet, without what waits in the queue.
template <bool Glossy, class R>
ZERKALO_INLINE Rgb<R> packet_light(const Plan& plan, const TileView& view, Vec3<R> towards, Mask<R> active, int first,
                                   GlossQueues& queues, TileCounts& counts) {
    const Vec3<R> d = towards * (R(1) / sqrt(dot(towards, towards)));
    const SharedOrigin& camera = plan.camera_origin;
    Nearest<R> near = nearest_solid(plan, view.seen, camera, d);
    Rgb<R> light = spread<R>(plan.background);
    const CandidateMask mirrors = mirrors_in(view.seen);
    auto on_mirror = Mask<R>(false);
    MirrorHit<FloatNumbers<R>> crossing;
    if (mirrors != 0) {
        crossing = plane_mirror_hit<FloatNumbers<R>>(plan.mirrors[0].shape, mirror_origin<R>(plan, 0, camera), d, R(0));
        on_mirror = active & crossing.hit & (crossing.t < near.t);
    }
    const auto on_solid = active & (!on_mirror) & (near.id >= R(0));
    const Vec3<R> o = spread<R>(plan.camera.origin);
    if (any(on_solid)) light = solid_light(plan, view.seen, near, o, d, on_solid, light, counts);
    if (none(on_mirror)) return light;

    const MirrorPlan& mirror = plan.mirrors[0];
    const bool front = camera.mirrors[0].z > 0;
    const Vec3<R> n = spread<R>(mirror.shape.n);
    const Spot<R> spot{o + d * crossing.t, front ? n : -n, d, R(float(kMaxSolids)), on_mirror};
    const SurfaceData& surface = front ? mirror.front : mirror.back;
    Rgb<R> seen = local_light(plan, spot, surface, view.mirror_blockers, surface.unlit_by, counts);
    if (front && mirror.reflects) {
        Rgb<R> reflected;
        if constexpr (Glossy) {
            reflected = queue_gloss(plan, view, spot, first, queues);
        } else {
            reflected = sharp_reflection(plan, view, spot, counts);
        }
        seen = seen + mirror.reflectance * reflected;
    }
    return select(on_mirror, seen, light);
}

/// Renders one tile. R: the lanes; Spread: tell how sure the average is.
template <class R, Bounce bounce, bool Spread = false>
inline void render_tile_one_bounce(const Plan& plan, const Rect& tile, const LinearImage& image, RayCounts& counts,
                                   TileSpread* spread_of_tile = nullptr) {
    constexpr bool Glossy = bounce != Bounce::sharp, Covered = bounce == Bounce::covered_lobe;
    counts.primary += static_cast<std::uint64_t>(tile.width) * static_cast<std::uint64_t>(tile.height) *
                      static_cast<std::uint64_t>(plan.antialias);
    TileView view = view_of_tile<R>(plan, tile);
    if (view.seen == 0) return fill_tile<R>(plan, tile, image);
    TileColours colours;
    TileCounts tile_counts;
    GlossQueues queues;
    queues.waiting = 0;
    queues.tile = tile_hash(plan, tile);
    const LatticeClasses classes = lattice_classes(queues.tile);
    if (Glossy && mirrors_in(view.seen) != 0) view.in_lobe = candidates_of_tile<R>(plan, tile);
    std::conditional_t<Covered, TileCover, NoCover> cover;
    std::conditional_t<Covered, CoverGrid, NoCover> grid;
    [[maybe_unused]] bool cover_is_known = false;
    const bool whole = tile.width == kTileSide && tile.height == kTileSide;
    for (std::int32_t a = 0; a < plan.antialias; ++a) {
        const SubPixel at = sub_pixel<float>(a, plan.antialias);
        TileColumns<R> columns;
        fill_columns(columns, plan, tile, at);
        for (int first = 0; first < tile.height * kTileSide; first += kWidth<R>) {
            auto active = Mask<R>(true);
            if (!whole) {
                active = lanes_inside<R>(tile, first);
                if (none(active)) continue;
            }
            const Vec3<R> column = columns.towards[first / kWidth<R> % TileColumns<R>::kPackets];
            const Vec3<R> towards = towards_pixel(plan.camera, column, twice_upwards(plan, row_lanes<R>(tile, first), at));
            const Rgb<R> light = packet_light<Glossy>(plan, view, towards, active, first, queues, tile_counts);
            put(colours, first, light, a > 0);
        }
        if constexpr (Glossy) {
            if (queues.waiting == 0) continue;
            if constexpr (Covered) {
                if (!cover_is_known) {
                    cover_tile<R>(cover, plan, tile, tile_counts);
                    if (cover.smooth) fill_grid<R>(grid, cover, plan, tile);
                }
                cover_is_known = true;
                add_covered<R>(cover, grid, queues, plan, at, colours, tile_counts);
            }
            flush<R, Spread>(queues, classes, plan, plan.mirrors[0], view.in_lobe, cover, static_cast<std::uint32_t>(a),
                             colours, spread_of_tile, tile_counts);
        }
    }
    if (plan.antialias > 1) average<R>(colours, plan.antialias);
    if constexpr (Spread) average(*spread_of_tile, plan.antialias);
    write_tile<R>(plan, colours, tile, image);
    counts.reflected += tile_counts.reflected;
    counts.lobe += tile_counts.lobe;
    counts.shadow += tile_counts.shadow;
    if constexpr (Covered) counts.covered += tile_counts.covered, counts.sampled += tile_counts.sampled;
}

}  // namespace zerkalo::inline ZERKALO_ISA
