// Local light for packets: Whitted's sum (optics/whitted.hpp) over the plan's lights, with shadows.
#pragma once

#include "core/render/visibility.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Lanes counted by kind, added to RayCounts when a tile is done.
struct TileCounts {
    std::uint32_t reflected = 0, lobe = 0, refracted = 0, shadow = 0;
    std::uint32_t weighed = 0, covered = 0, sampled = 0;  // see RayCounts
};

/// Where a packet is lit: points, normals towards the viewer, the rays that came, who stands there.
template <class R>
struct Spot {
    Vec3<R> p, n, d;
    R own_id;
    Mask<R> active;
};

/// The local part of seed formula 1.5, for one surface. Lanes that are not active are meaningless. Bit j of `unlit_by`:
/// light j is known not to reach it (only sides of mirrors have such: see SurfaceData).
template <class R>
ZERKALO_INLINE Rgb<R> local_light(const Plan& plan, const Spot<R>& spot, const SurfaceData& surface,
                                  const Blockers& blockers, std::uint32_t unlit_by, TileCounts& counts) {
    Rgb<R> sum = spread<R>(surface.ambient);
    for (std::int32_t j = 0; j < plan.light_count; ++j) {
        if (unlit_by >> j & 1) continue;
        const LightPlan& light = plan.lights[j];
        const ToLight<R> to = towards(light.data, spot.p, spot.n);
        const auto lit = spot.active & (to.n_dot_l > R(0));
        if (none(lit)) continue;
        counts.shadow += count_of(lit);
        const auto visible = visible_from_outside(plan, light, blockers.of_light[j], to, spot.own_id, lit);
        if (none(visible)) continue;
        const Rgb<R> share = light_share(light.data, to, spot.n, -spot.d, surface, visible);
        sum.r = select(visible, sum.r + share.r, sum.r);
        sum.g = select(visible, sum.g + share.g, sum.g);
        sum.b = select(visible, sum.b + share.b, sum.b);
    }
    return sum;
}

/// Light that a solid sends back along the rays from p, in the lanes of `here`; the others are meaningless.
template <class R>
ZERKALO_INLINE Rgb<R> light_of_solid(const Plan& plan, const SolidPlan& solid, Vec3<R> p, R face, Vec3<R> d, Mask<R> here,
                                     TileCounts& counts) {
    const Spot<R> spot{p, normal_towards<R>(plan, solid, p, face, d, here), d, R(solid.id), here};
    return local_light(plan, spot, solid.surface, solid.blockers, 0, counts);
}

/// Light that the hit solids send back along the rays, solid by solid; `otherwise` where no lane is active.
template <class R>
ZERKALO_INLINE Rgb<R> solid_light(const Plan& plan, CandidateMask candidates, const Nearest<R>& near, Vec3<R> o,
                                  Vec3<R> d, Mask<R> active, Rgb<R> otherwise, TileCounts& counts) {
    const Vec3<R> p = o + d * near.t;
    Rgb<R> light = otherwise;
    for (CandidateMask left = solids_in(candidates); left != 0; left &= left - 1) {
        const SolidPlan& solid = plan.solids[first_of(left)];
        const auto here = active & (near.id == R(solid.id));
        if (none(here)) continue;
        const Rgb<R> own = light_of_solid<R>(plan, solid, p, near.face, d, here, counts);
        light.r = select(here, own.r, light.r);
        light.g = select(here, own.g, light.g);
        light.b = select(here, own.b, light.b);
    }
    return light;
}

}  // namespace zerkalo::inline ZERKALO_ISA
