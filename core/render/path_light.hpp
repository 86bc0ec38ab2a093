// What a path's rays carry and bring: sums of light, and the lobe rays that are known to see the background alone.
#pragma once

#include "core/optics/shares.hpp"
#include "core/render/meet.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class R>
ZERKALO_INLINE void add(Rgb<LightSum<R>>& sum, Mask<R> mask, Rgb<Weight<R>> throughput, Rgb<Radiance<R>> light) {
    sum = plus_where(mask, sum, throughput * light);
}

/// Adds light that is the same in all lanes.
template <class R>
ZERKALO_INLINE void add_uniform(Rgb<LightSum<R>>& sum, Mask<R> mask, const Rgb<LightSum<Uniform<R>>>& light) {
    sum = plus_where(mask, sum, spread<LightSum<R>>(light));
}

/// The background, for as many rays that are known to miss everything.
template <class R>
ZERKALO_INLINE void add_missed(const PlanFor<R>& plan, Mask<R> mask, Rgb<Weight<R>> throughput, std::int32_t missed,
                               Rgb<LightSum<R>>& sum) {
    if (missed == 0) return;
    const Rgb<Weight<R>> all{times(throughput.r, missed), times(throughput.g, missed), times(throughput.b, missed)};
    add<R>(sum, mask, all, spread<Radiance<R>>(plan.background));
}

/// What lobe ray s of a pixel carries; `full`: what those with the largest share do.
template <class R>
ZERKALO_INLINE Rgb<Weight<R>> throughput_of_ray(const PlanHead& plan, Rgb<Weight<R>> full, std::int32_t s) {
    if (s >= rays_at_rim(plan.sampling.estimator, plan.samples)) return full;
    return as<Weight<R>>(scaled(full, weight_at_rim<R>(s, plan.samples)));
}

/// What a ray with the largest share carries from the only mirror.
template <class R>
ZERKALO_INLINE Rgb<Weight<R>> full_throughput(const PlanFor<R>& plan) {
    const auto weight = full_weight<R>(plan.sampling.estimator, plan.samples);
    return as<Weight<R>>(scaled(spread<Weight<R>>(plan.mirrors[0].reflectance), weight));
}

/// The background, for all rays of a lobe.
template <class R>
ZERKALO_INLINE void add_whole_lobe(const PlanFor<R>& plan, Mask<R> mask, Rgb<Weight<R>> full,
                                   Rgb<LightSum<R>>& sum) {
    const std::int32_t rim = rays_at_rim(plan.sampling.estimator, plan.samples);
    add_missed<R>(plan, mask, full, plan.samples - rim, sum);
    for (std::int32_t s = 0; s < rim; ++s) {
        add<R>(sum, mask, throughput_of_ray<R>(plan, full, s), spread<Radiance<R>>(plan.background));
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
