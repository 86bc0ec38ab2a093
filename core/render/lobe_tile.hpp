// Which solids the lobes of a tile's pixels can meet at all: one uniform cone for the whole tile. Conservative.
#pragma once

#include "core/render/tile.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The mirror points of a tile lie within `stray` of p; their mirror directions within an angle of m.
struct TileLobe {
    Vec3<float> p, m;
    float stray, cosine, sine;  // cone: the lobe's, widened by the angle
    bool bounded;
};

ZERKALO_INLINE TileLobe lobe_of_tile(const Plan& plan, const Rect& tile) {
    const MirrorPlan& mirror = plan.mirrors[0];
    const CameraPlan& camera = plan.camera;
    const float height = plan.shared_mirrors[kCameraOrigin][0].z;
    const float across = float(2 * tile.left + tile.width - plan.width);
    const float upwards = float(plan.height - 2 * tile.top - tile.height);
    const Vec3<float> middle = camera.view + camera.step_x * across + camera.step_y * upwards;
    const float scale = 1 / sqrt(dot(middle, middle));
    const float fall = -dot(mirror.shape.n, middle);
    TileLobe lobe{};
    if (!(fall > 0) || !(height > 0)) return lobe;
    const Vec3<float> from_eye = middle * (height / fall);
    lobe.p = camera.origin + from_eye;
    lobe.m = reflect(middle * scale, mirror.shape.n);
    float stray2 = 0, turn2 = 0;
    for (int corner = 0; corner < 4; ++corner) {
        const Vec3<float> off = camera.step_x * float(corner & 1 ? tile.width : -tile.width) +
                                camera.step_y * float(corner & 2 ? tile.height : -tile.height);
        const Vec3<float> d = middle + off;
        const float corner_fall = -dot(mirror.shape.n, d);
        if (!(corner_fall > 0)) return lobe;
        const Vec3<float> away = d * (height / corner_fall) - from_eye;
        stray2 = max(stray2, dot(away, away));
        turn2 = max(turn2, dot(off, off));
    }
    // The angle's sine is at most |off| / |middle|; a little more covers rounding.
    constexpr float kRoom = 1 + 0x1p-10f;
    const float sine = sqrt(turn2) * scale * kRoom;
    if (!(sine < 0.5f)) return lobe;
    const float cosine = sqrt(1 - sine * sine);
    lobe.stray = sqrt(stray2) * kRoom;
    lobe.sine = mirror.lobe.sine * cosine + mirror.lobe.cosine * sine;
    lobe.cosine = mirror.lobe.cosine * cosine - mirror.lobe.sine * sine;
    lobe.bounded = lobe.cosine > 0;
    return lobe;
}

/// Solids that some lobe ray of the tile's mirror pixels may meet, as the packets' own test would say.
ZERKALO_INLINE CandidateMask candidates_of_tile(const Plan& plan, const Rect& tile) {
    const CandidateMask everything = (CandidateMask{1} << plan.solid_count) - 1;
    if (plan.exact_plan) return everything;
    const TileLobe lobe = lobe_of_tile(plan, tile);
    if (!lobe.bounded) return everything;
    CandidateMask mask = 0;
    for (std::int32_t k = 0; k < plan.solid_count; ++k) {
        const Vec3<float> f = plan.solids[k].bound_centre - lobe.p;
        const float along = dot(f, lobe.m);
        const Vec3<float> across = f - lobe.m * along;
        const float reach = (plan.solids[k].bound_radius + lobe.stray) * (1 + 0x1p-10f) + along * lobe.sine;
        const bool meets = reach >= 0 && dot(across, across) * (lobe.cosine * lobe.cosine) <= reach * reach;
        mask |= CandidateMask{meets} << k;
    }
    return mask;
}

}  // namespace zerkalo::inline ZERKALO_ISA
