// The covered part of the light of a tile's pixels: pixel by pixel, or, where it is smooth against the tile, at sixteen
// places from which the pixels are interpolated by polynomials of third degree (Chebyshev's places).
#pragma once

#include "core/render/cover_hidden.hpp"
#include "core/render/gloss_queue.hpp"

namespace zerkalo::inline ZERKALO_ISA {

constexpr int kGridSide = 4, kGridPlaces = kGridSide * kGridSide;

/// Places cos((2 k + 1) pi / 8) across the tile, from -1 to 1, for each of the grid's places.
struct GridPlaces {
    float x[kGridPlaces], y[kGridPlaces];
};
constexpr float kFar = 0.92387953f, kNear = 0.38268343f;
constexpr GridPlaces kGrid{
    {kFar, kNear, -kNear, -kFar, kFar, kNear, -kNear, -kFar, kFar, kNear, -kNear, -kFar, kFar, kNear, -kNear, -kFar},
    {kFar, kFar, kFar, kFar, kNear, kNear, kNear, kNear, -kNear, -kNear, -kNear, -kNear, -kFar, -kFar, -kFar, -kFar}};

/// The polynomials that are 1 at one of the four places and 0 at the others, at x: sums of T_0..T_3.
template <class R>
struct GridBasis {
    R at[kGridSide];
};
template <class R>
ZERKALO_INLINE GridBasis<R> grid_basis(R x) {
    constexpr float kHalfRoot = 0.35355339f;  // cos(pi / 4) / 2
    const R t2 = R(2) * x * x - R(1), t3 = x * (R(2) * t2 - R(1));
    const R even = R(kHalfRoot) * t2;
    const R outer = R(kFar / 2) * x + R(kNear / 2) * t3, inner = R(kNear / 2) * x - R(kFar / 2) * t3;
    const R first = R(0.25f) + even, second = R(0.25f) - even;
    return {{first + outer, second + inner, second - inner, first - outer}};
}

/// The light at the grid's places.
struct CoverGrid {
    float r[kGridPlaces], g[kGridPlaces], b[kGridPlaces];
};

/// What the covered solids bring, without what they hide of each other.
template <class R>
ZERKALO_INLINE Rgb<R> all_covered(const TileCover& cover, const Plan& plan, const MirrorPlan& mirror, const Vec3<R>& p,
                                  const LobeFrame<R>& frame) {
    const Rgb<R> light = covered_light(cover, plan, mirror, p, frame);
    return cover.hiders != 0 ? light - hidden_light(cover, plan, p, frame) : light;
}

template <class R>
ZERKALO_ONCE void fill_grid(CoverGrid& grid, const TileCover& cover, const Plan& plan, const Rect& tile) {
    const MirrorPlan& mirror = plan.mirrors[0];
    const CameraPlan& camera = plan.camera;
    const float height = plan.camera_origin.mirrors[0].z;
    const float across = float(2 * tile.left + kTileSide - plan.width);
    const float upwards = float(plan.height - 2 * tile.top - kTileSide);
    for (int first = 0; first < kGridPlaces; first += kWidth<R>) {
        const R x = load<R>(kGrid.x + first) * R(kTileSide) + R(across);
        const R y = R(upwards) - load<R>(kGrid.y + first) * R(kTileSide);
        const Vec3<R> towards = camera.view + camera.step_x * x + camera.step_y * y;
        const Vec3<R> p = camera.origin + towards * (R(height) / -dot(mirror.shape.n, towards));
        const Vec3<R> m = reflect(towards * (R(1) / sqrt(dot(towards, towards))), spread<R>(mirror.shape.n));
        const Tangents<R> sides = tangents_of(m);
        const Rgb<R> light = all_covered(cover, plan, mirror, p, LobeFrame<R>{m, sides.t, sides.b});
        store(grid.r + first, light.r), store(grid.g + first, light.g), store(grid.b + first, light.b);
    }
}

template <class R>
ZERKALO_INLINE Rgb<R> interpolated(const CoverGrid& grid, R x, R y) {
    const GridBasis<R> across = grid_basis(x), down = grid_basis(y);
    Rgb<R> sum = spread<R>(Rgb<float>{0, 0, 0});
    for (int row = 0; row < kGridSide; ++row) {
        Rgb<R> line = spread<R>(Rgb<float>{0, 0, 0});
        for (int k = 0; k < kGridSide; ++k) {
            const int place = row * kGridSide + k;
            line = line + scaled(Rgb<float>{grid.r[place], grid.g[place], grid.b[place]}, across.at[k]);
        }
        sum = sum + scaled(line, down.at[row]);
    }
    return sum;
}

/// The lanes whose lobe may meet one of the solids.
template <class R>
ZERKALO_INLINE Mask<R> may_meet_any(const Plan& plan, CandidateMask solids, Vec3<R> p, Vec3<R> m) {
    auto meets = Mask<R>(false);
    for (CandidateMask left = solids; left != 0; left &= left - 1) {
        meets = meets | lobe_may_meet(plan.solids[first_of(left)], plan.mirrors[0].lobe, p, m);
    }
    return meets;
}

/// Adds F K_r times the covered light to the colours of all pixels that wait for their lobe rays, for the camera rays
/// through the given point of each.
template <class R>
ZERKALO_ONCE void add_covered(const TileCover& cover, const CoverGrid& grid, const GlossQueues& queues, const Plan& plan,
                              SubPixel at, TileColours& colours, TileCounts& counts) {
    constexpr std::uint64_t kPacket = (std::uint64_t{1} << kWidth<R>)-1;
    const GlossPoints& points = queues.points;
    CandidateMask solids = 0;
    for (std::int32_t i = 0; i < cover.count; ++i) solids |= CandidateMask{1} << cover.solids[i].k;
    for (int first = 0; first < kTilePixels; first += kWidth<R>) {
        const std::uint64_t bits = queues.waiting >> first & kPacket;
        if (bits == 0) continue;
        const auto waiting = lanes_of_bits<R>(bits);
        const Vec3<R> p{load<R>(points.px + first), load<R>(points.py + first), load<R>(points.pz + first)};
        const Vec3<R> m{load<R>(points.mx + first), load<R>(points.my + first), load<R>(points.mz + first)};
        auto covered = waiting & may_meet_any(plan, solids, p, m);
        counts.covered += count_of(covered);
        counts.sampled += count_of(waiting & may_meet_any(plan, cover.plain, p, m));
        if (none(covered)) continue;
        Rgb<R> light;
        if (cover.smooth) {
            const R column = load<R>(kColumns.real + first % kTileSide) + R(at.x);
            const R row = load<R>(kRows.real) + R(float(first / kTileSide) + at.y);
            constexpr float kStep = 2.0f / kTileSide, kStart = kStep / 2 - 1;
            light = interpolated(grid, column * R(kStep) + R(kStart), row * R(kStep) + R(kStart));
        } else {
            const Tangents<R> sides = tangents_of(m);
            light = all_covered(cover, plan, plan.mirrors[0], p, LobeFrame<R>{m, sides.t, sides.b});
        }
        light = spread<R>(plan.mirrors[0].reflectance) * light;
        put(colours, first, select(covered, light, spread<R>(Rgb<float>{0, 0, 0})), true);
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
