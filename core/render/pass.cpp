// A pass over a frame that is prepared already: the same plan with other lobe rays.
#include "core/numeric/float_mode.hpp"
#include "core/render/class_rays.hpp"
#include "core/render/derive.hpp"
#include "core/render/lattice_chunk.hpp"
#include "core/render/render.hpp"

#include <type_traits>

namespace zerkalo {
namespace {

template <class F>
Status begin(PlanOf<F>& plan, const Pass& pass) {
    const IeeeMode ieee;
    if (const Status status = check_pass(pass); !status.ok()) return status;
    place_lobe_rays(plan, pass);
    return kOk;
}

}  // namespace

Status check_pass(const Pass& pass) {
    if (pass.samples < 1 || pass.samples > kMaxSamples) {
        return {"samples", "must lie in 1..1048576", Part::settings, 0};
    }
    if (pass.antialias < 0 || pass.antialias > kMaxAntialias) {
        return {"antialias", "must lie in 0..4096", Part::settings, 0};
    }
    if (pass.rotation < 0) return {"rotation", "must lie in 0..2147483647", Part::settings, 0};
    return kOk;
}

template <class F>
void place_lobe_rays(PlanOf<F>& plan, const Pass& pass) {
    plan.samples = pass.samples;
    if (pass.antialias > 0) plan.antialias = pass.antialias;
    plan.sampling = sampling_of(plan.sampling.estimator, static_cast<std::uint32_t>(pass.rotation));
    for (int k = 0; k < kSpreadParts; ++k) {
        plan.part_scale[k] = plan.samples < kSpreadParts
                                 ? 1.0f
                                 : scale_of_part(plan.sampling.estimator, plan.samples, k, kSpreadParts);
    }
    for (std::int32_t m = 0; m < plan.mirror_count; ++m) {
        MirrorPlanOf<F>& mirror = plan.mirrors[m];
        if (!mirror.lobe.glossy) continue;
        // Cosines and sines have no scale: those of every scene are rounded alike.
        derive_cone(mirror.lobe_exponent, plan, pass.survey, Constants<F>(), mirror.lobe);
        // A keyed rule has other points in every tile.
        if (is_keyed(plan.sampling.estimator)) continue;
        if constexpr (std::is_same_v<F, FloatFormats>) {
            const LatticePart part = lattice_part(plan.sampling, 0, plan.antialias);
            fill_chunk<float>(mirror.lattice, part, mirror.lobe, 0, plan.samples);
        } else if constexpr (F::kFixed) {
            fill_rays<FixedNumbers<1>>(mirror.rays, plan, mirror.lobe, 0, 0, 0);
        }
    }
}

template void place_lobe_rays(Plan&, const Pass&);
template void place_lobe_rays(DoublePlan&, const Pass&);
template void place_lobe_rays(FixedPlan&, const Pass&);

Status begin_pass(Plan& plan, const Pass& pass) { return begin(plan, pass); }
Status begin_pass(DoublePlan& plan, const Pass& pass) { return begin(plan, pass); }
Status begin_pass(FixedPlan& plan, const Pass& pass) { return begin(plan, pass); }

}  // namespace zerkalo
