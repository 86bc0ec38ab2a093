// A run of lobe rays in fixed point, computed once for all the packets of a class that share it.
#pragma once

#include "core/render/lobe_job.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Rays first, first + 1, ... of all classes.
template <class R>
ZERKALO_ONCE void fill_rays(ClassRays& rays, const PlanHead& plan, const LobeFor<R>& lobe, std::uint32_t tile,
                            std::uint32_t camera_sample, std::int32_t first) {
    using One = Uniform<R>;
    const Sampling& sampling = plan.sampling;
    const auto exponent = Share<One>(lobe.inverse_exponent);
    const std::int32_t left = plan.samples - first;
    rays.count = left < kRayChunk ? left : kRayChunk;
    PathKey<One> keys[kLatticeClasses]{};
    for (int c = 0; c < kLatticeClasses; ++c) {
        keys[c].turn = phase_of<One>(phase_of_class(sampling, c));
        keys[c].part = lattice_part(sampling, camera_sample, plan.antialias);
        if (is_keyed(sampling.estimator)) keys[c].set = set_of_class(sampling, tile, c, camera_sample);
    }
    for (std::int32_t i = 0; i < rays.count; ++i) {
        LobePolar<One> polar{};
        for (int c = 0; c < kLatticeClasses; ++c) {
            const SetPoint<One> at = place_of_ray<One>(plan, keys[c], first + i);
            // Of a lattice the classes differ in their turn alone.
            if (c == 0 || is_keyed(sampling.estimator)) polar = lobe_polar(at.u, exponent);
            const LobePoint<One> point = at_azimuth(polar, at.turn);
            RayChunk& chunk = rays.of_class[c];
            chunk.side[i] = point.side.raw, chunk.up[i] = point.up.raw, chunk.forward[i] = point.forward.raw;
        }
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
