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

/// In place of queues where no pixel waits: the mirror is polished.
struct NoQueues {};

/// The colours of one packet, without what waits in the queues.
template <class R, class Queues>
ZERKALO_INLINE Rgb<R> packet_light(const Plan& plan, const TileView& view, Vec3<R> towards, Mask<R> active, int first,
                                   Queues& queues, TileCounts& counts) {
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
        if constexpr (std::is_same_v<Queues, NoQueues>) {
            reflected = sharp_reflection(plan, view, spot, counts);
        } else {
            reflected = queue_gloss(plan, view, spot, first, queues);
        }
        seen = seen + mirror.reflectance * reflected;
    }
    return select(on_mirror, seen, light);
}

/// The tile's pixels as the camera's rays through one place of each see them, without what waits in the queues.
/// A function of its own: the kernels of an unpolished mirror share it.
template <class R, class Queues>
ZERKALO_ONCE void trace_camera(const Plan& plan, const Tile& tile, const TileView& view, SubPixel at, bool add,
                               TileColours& colours, Queues& queues, TileCounts& counts) {
    TileColumns<R> columns;
    fill_columns(columns, plan, tile, at);
    for (int first = 0; first < tile.height * kTileSide; first += kWidth<R>) {
        const auto active = lanes_of<R>(tile, first);
        if (none(active)) continue;
        const Vec3<R> column = columns.towards[first / kWidth<R> % TileColumns<R>::kPackets];
        const Vec3<R> towards = towards_pixel(plan.camera, column, twice_upwards(plan, row_lanes<R>(tile, first), at));
        put(colours, first, packet_light(plan, view, towards, active, first, queues, counts), add);
    }
}

/// Counts the tile's camera rays and finds what they can see. False: nothing, and the tile is done.
template <class R>
ZERKALO_INLINE bool begin_tile(TileView& view, const Plan& plan, const Tile& tile, const LinearImage& image,
                             RayCounts& counts) {
    counts.primary += camera_rays(plan, tile);
    view = view_of_tile<R>(plan, tile);
    if (view.seen != 0) return true;
    fill_tile<R>(plan, tile, image);
    return false;
}

template <class R>
ZERKALO_INLINE void finish_tile(TileColours& colours, const TileCounts& tile_counts, const Plan& plan, const Tile& tile,
                              const LinearImage& image, RayCounts& counts) {
    if (plan.antialias > 1) average<R>(colours, plan.antialias);
    write_tile<R>(plan, colours, tile, image);
    counts.reflected += tile_counts.reflected;
    counts.lobe += tile_counts.lobe;
    counts.shadow += tile_counts.shadow;
    counts.weighed += tile_counts.weighed;
    counts.covered += tile_counts.covered;
    counts.sampled += tile_counts.sampled;
}

/// Renders one tile of a scene whose mirror, if it has one, is polished.
template <class R>
inline void render_tile_sharp(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts) {
    TileView view;
    if (!begin_tile<R>(view, plan, tile, image, counts)) return;
    TileColours colours;
    TileCounts tile_counts;
    NoQueues queues;
    for (std::int32_t a = 0; a < plan.antialias; ++a) {
        trace_camera<R>(plan, tile, view, sub_pixel<float>(a, plan.antialias), a > 0, colours, queues, tile_counts);
    }
    finish_tile<R>(colours, tile_counts, plan, tile, image, counts);
}

/// Renders one tile of a scene whose mirror is unpolished. `trace` is told the waiting pixels of each camera ray.
template <class R, class Trace>
ZERKALO_INLINE void render_tile_glossy(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts,
                                       const Trace& trace) {
    TileView view;
    if (!begin_tile<R>(view, plan, tile, image, counts)) return;
    GlossQueues queues;
    queues.waiting = 0;
    queues.tile = tile_hash(plan, tile);
    const LatticeClasses classes = lattice_classes(queues.tile);
    if (mirrors_in(view.seen) != 0) view.in_lobe = candidates_of_tile<R>(plan, tile);
    TileColours colours;
    TileCounts tile_counts;
    for (std::int32_t a = 0; a < plan.antialias; ++a) {
        const SubPixel at = sub_pixel<float>(a, plan.antialias);
        trace_camera<R>(plan, tile, view, at, a > 0, colours, queues, tile_counts);
        if (queues.waiting != 0) trace(queues, classes, view.in_lobe, a, at, colours, tile_counts);
    }
    finish_tile<R>(colours, tile_counts, plan, tile, image, counts);
}

/// With lobe rays alone.
template <class R>
inline void render_tile_lobe(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts) {
    render_tile_glossy<R>(plan, tile, image, counts,
                          [&](GlossQueues& queues, const LatticeClasses& classes, CandidateMask candidates,
                              std::int32_t a, SubPixel, TileColours& colours, TileCounts& tile_counts) {
        flush<R>(queues, classes, plan, plan.mirrors[0], candidates, NoAids{}, static_cast<std::uint32_t>(a), colours,
                 tile_counts);
    });
}

/// With lobe rays alone that tell how sure their average is.
template <class R>
inline void render_tile_telling(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts,
                                TileSpread& spread) {
    render_tile_glossy<R>(plan, tile, image, counts,
                          [&](GlossQueues& queues, const LatticeClasses& classes, CandidateMask candidates,
                              std::int32_t a, SubPixel, TileColours& colours, TileCounts& tile_counts) {
        flush<R>(queues, classes, plan, plan.mirrors[0], candidates, TellingAids{&spread, parts_in(spread)},
                 static_cast<std::uint32_t>(a), colours, tile_counts);
    });
    average(spread, plan.antialias);
}

/// Covered solids of a tile, and their light where it is interpolated between.
struct CoveredTile {
    TileCover cover;
    CoverGrid grid;
    bool known = false;
};

/// Adds the covered light of the waiting pixels.
template <class R>
ZERKALO_INLINE void cover_lobes(CoveredTile& covered, const GlossQueues& queues, const Plan& plan, const Rect& tile,
                                SubPixel at, TileColours& colours, TileCounts& counts) {
    if (!covered.known) {
        cover_tile<R>(covered.cover, plan, tile, counts);
        if (covered.cover.smooth) fill_grid<R>(covered.grid, covered.cover, plan, tile);
        covered.known = true;
    }
    add_covered<R>(covered.cover, covered.grid, queues, plan, at, colours, counts);
}

/// With solids that are covered before the lobe rays, and telling how sure the average is, if `spread` is not null. G:
/// the lanes of the lobe's rays, where R may be too many for the stack.
template <class R, class G>
inline void render_tile_aided(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts,
                              TileSpread* spread) {
    CoveredTile covered;
    covered.cover.count = 0;
    covered.cover.hiders = 0;
    LobeAids aids{spread, {}, covered.cover};
    render_tile_glossy<R>(plan, tile, image, counts,
                          [&](GlossQueues& queues, const LatticeClasses& classes, CandidateMask candidates,
                              std::int32_t a, SubPixel at, TileColours& colours, TileCounts& tile_counts) {
        cover_lobes<G>(covered, queues, plan, tile, at, colours, tile_counts);
        if (spread != nullptr) aids.parts = parts_in(*spread);
        flush<G>(queues, classes, plan, plan.mirrors[0], candidates, aids, static_cast<std::uint32_t>(a), colours,
                 tile_counts);
    });
    if (spread != nullptr) average(*spread, plan.antialias);
}

}  // namespace zerkalo::inline ZERKALO_ISA
