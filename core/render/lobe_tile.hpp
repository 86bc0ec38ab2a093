// Which solids the lobes of a tile's pixels can meet at all: one uniform cone for the whole tile. Conservative.
#pragma once

#include "core/numeric/shuffle.hpp"
#include "core/render/tile.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The mirror points of a tile lie within `stray` of p; their mirror directions within an angle of m.
struct TileLobe {
    Vec3<float> p, m;
    float stray, cosine, sine;  // cone: the lobe's, widened by the angle
    float turn;                 // sine of that angle
    bool bounded;
};

template <class R>
ZERKALO_INLINE TileLobe lobe_of_tile(const Plan& plan, const Rect& tile) {
    const MirrorPlan& mirror = plan.mirrors[0];
    const CameraPlan& camera = plan.camera;
    const float height = plan.camera_origin.mirrors[0].z;
    const float across = float(2 * tile.left + kTileSide - plan.width);
    const float upwards = float(plan.height - 2 * tile.top - kTileSide);
    const Vec3<float> middle = camera.view + camera.step_x * across + camera.step_y * upwards;
    const float scale = 1 / sqrt(dot(middle, middle));
    const float fall = -dot(mirror.shape.n, middle);
    TileLobe lobe{};
    if (!(fall > 0) || !(height > 0)) return lobe;
    const Vec3<float> from_eye = middle * (height / fall);
    lobe.p = camera.origin + from_eye;
    lobe.m = reflect(middle * scale, mirror.shape.n);
    float stray2 = 0;
    for (int corner = 0; corner < kTileCorners; corner += kWidth<R>) {
        const TileCorners& corners = plan.tile_corners;
        const Vec3<R> off{load<R>(corners.x + corner), load<R>(corners.y + corner), load<R>(corners.z + corner)};
        const R corner_fall = R(fall) + load<R>(corners.fall + corner);
        if (!all(corner_fall > R(0))) return lobe;
        const Vec3<R> away = (off + middle) * (R(height) / corner_fall) - from_eye;
        stray2 = max(stray2, largest_lane(dot(away, away)));
    }
    // The angle's sine is at most |off| / |middle|; a little more covers rounding.
    constexpr float kRoom = 1 + 0x1p-10f;
    const float sine = plan.tile_corners.reach * scale * kRoom;
    if (!(sine < 0.5f)) return lobe;
    const float cosine = sqrt(1 - sine * sine);
    lobe.stray = sqrt(stray2) * kRoom;
    lobe.turn = sine;
    lobe.sine = mirror.lobe.sine * cosine + mirror.lobe.cosine * sine;
    lobe.cosine = mirror.lobe.cosine * cosine - mirror.lobe.sine * sine;
    lobe.bounded = lobe.cosine > 0;
    return lobe;
}

/// Solids that the cone of a tile's lobes can meet.
template <class R>
ZERKALO_INLINE CandidateMask solids_in_reach(const Plan& plan, const TileLobe& lobe) {
    CandidateMask mask = 0;
    const BoundTable& bounds = plan.bounds;
    for (std::int32_t k = 0; k < plan.solid_count; k += kWidth<R>) {
        const Vec3<R> f = Vec3<R>{load<R>(bounds.x + k), load<R>(bounds.y + k), load<R>(bounds.z + k)} - lobe.p;
        const R along = dot(f, lobe.m);
        const Vec3<R> across = f - lobe.m * along;
        const R reach = (load<R>(bounds.radius + k) + R(lobe.stray)) * R(1 + 0x1p-10f) + along * R(lobe.sine);
        const auto meets = (reach >= R(0)) & (dot(across, across) * R(lobe.cosine * lobe.cosine) <= reach * reach);
        mask |= CandidateMask{bits_of(meets)} << k;
    }
    return mask & first_bits(plan.solid_count);
}

/// Solids that some lobe ray of the tile's mirror pixels may meet, as the packets' own test would say.
template <class R>
ZERKALO_INLINE CandidateMask candidates_of_tile(const Plan& plan, const Rect& tile) {
    const CandidateMask everything = first_bits(plan.solid_count);
    if (plan.exact_plan) return everything;
    const TileLobe lobe = lobe_of_tile<R>(plan, tile);
    if (!lobe.bounded) return everything;
    return solids_in_reach<R>(plan, lobe);
}

}  // namespace zerkalo::inline ZERKALO_ISA
