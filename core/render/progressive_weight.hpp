// What a pass counts for beside others: in proportion to the inverse of the variance that is expected of it.
#pragma once

#include "core/numeric/setup.hpp"
#include "core/render/progressive.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The variance of a pass falls as samples^-(gain / 8), measured over the shipped scenes (README.md). Where passes are
/// all that tells the error, the few samples of the survey stand for the many that follow: there it is taken finer.
inline int gain_of(const PlanHead& plan, bool told_by_passes) {
    const Estimator rule = plan.sampling.estimator;
    if (rule == Estimator::random) return 8;
    if (!told_by_passes) return 12;
    // Rays between unpolished mirrors go on at random, one for each.
    if (plan.mirror_count > 1) return 10;
    const int of_rule = is_keyed(rule) ? 11 : 12;
    // Rays off normals that the viewer sees lie less evenly.
    return plan.features & kFeatureGgx ? of_rule - 1 : of_rule;
}

/// samples^(gain / 8) for a gain of 8..15.
inline double weight_of(double samples, int gain) {
    const double half = square_root(samples), quarter = square_root(half), eighth = square_root(quarter);
    double weight = samples;
    if (gain & 4) weight *= half;
    if (gain & 2) weight *= quarter;
    if (gain & 1) weight *= eighth;
    return weight;
}

constexpr double kLargestStep = 16;  // times the samples so far: an estimate from few samples must not decide all

// Of the variance asked for, what the forecast aims at: some tiles are only lucky, and no table is exact, least of all
// that of ggx lobes.
constexpr double kMargin = 0.85, kMarginOfGgx = 0.78;

/// What a pass costs a camera ray before its first lobe ray, in lobe rays: measured over the shipped scenes (README.md).
constexpr double kPriceOfOneBounce = 16, kPriceOfGeneral = 2;

/// Whether a lobe ray costs nearly as much as a pixel without.
inline bool rays_are_dear(const PlanHead& plan) { return (plan.features & kNeedsGeneral) != 0; }

/// Pixels times channels.
inline double values_of(const PlanHead& plan) { return 3.0 * plan.width * plan.height; }

inline double margin_of(const PlanHead& plan) { return plan.features & kFeatureGgx ? kMarginOfGgx : kMargin; }

/// Of all tiles together, for the estimate to become that error or a little less.
inline double variance_for(const PlanHead& plan, double error) {
    return margin_of(plan) * error * error * values_of(plan);
}

}  // namespace zerkalo::inline ZERKALO_ISA
