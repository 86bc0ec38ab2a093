// Judging the answers of the lanes ray by ray, and what is kept of a million of them: the worst of each kind.
//
// Errors of t are in ulps of the reach, the larger of |t| and the primitive's size: a float t is no better than its own
// spacing. Shifts of the surface are in roundings, 2^-24 of the way from the ray's origin to the primitive's far end.
// Both are divided by what is lost near the tip of a cone and on a flat triangle (Crossing::loss).
#pragma once

#include "tests/core/support/rays.hpp"
#include "tests/oracle/closed_forms.hpp"

#include <cstdint>

namespace zerkalo::test {

/// Rays that meet a surface more flatly than this are grazing.
constexpr Real80 kSteep = 0.1L;
/// Surfaces that pass within so many roundings of a crossing meet there; a ray whose chord is as short is tangent.
constexpr Real80 kNear = 16;

/// Spacing of the floats at x > 0.
inline Real80 ulp_of(Real80 x) { return std::ldexp(1.0L, std::ilogb(x) - 23); }

/// The worst seen so far, and the ray that showed it.
struct Worst {
    Real80 value = 0;
    std::string ray;

    void see(Real80 candidate, const RayList& rays, std::size_t k) {
        if (!(candidate > value)) return;
        value = candidate;
        ray = text(rays, k);
    }
};

/// What the rays of one kind have shown. `error` is the law; `head_on` and `steep` say what it means there.
struct Tally {
    std::uint64_t rays = 0, hits = 0, grazing_ends = 0, unjudged = 0;
    Worst error;    // error of t times the cosine of incidence, ulps of the reach
    Worst head_on;  // error of t at cosines of at least 1/2
    Worst steep;    // and of at least kSteep
    Worst tangent;  // shift of the surface that explains an end of a ray that all but touches it, roundings
    Worst band;     // shift that explains a ray which hits what it should miss, or misses what it should hit

    /// An end that is not tangent. `reach`: the larger of |t| and the size.
    void see_end(const Crossing& wanted, Real80 got, Real80 reach, const RayList& ray_list, std::size_t k) {
        const Real80 ulps = std::abs(got - wanted.t) / ulp_of(reach) / wanted.loss;
        error.see(ulps * wanted.cosine, ray_list, k);
        if (wanted.cosine >= 0.5L) head_on.see(ulps, ray_list, k);
        if (wanted.cosine >= kSteep) steep.see(ulps, ray_list, k);
        grazing_ends += wanted.cosine < kSteep;
    }
    void see_tangent(Real80 shift, const RayList& ray_list, std::size_t k) {
        ++unjudged;
        tangent.see(shift, ray_list, k);
    }
    void see_disagreement(Real80 shift, const RayList& ray_list, std::size_t k) {
        ++unjudged;
        band.see(shift, ray_list, k);
    }
};

/// A ray that all but touches a bent surface: its ends move by the root of what the surface moves by.
inline bool is_tangent(const Crossing& at, Real80 rounding) {
    return at.cosine * at.cosine * at.bend < 2 * kNear * rounding;
}

/// The least of a growing sequence of shifts, in roundings, that `explains(shift)`.
template <class Explains>
Real80 least_shift(Real80 rounding, Explains explains) {
    Real80 roundings = 0.125L;
    while (roundings < 1e12L && !explains(roundings * rounding)) roundings *= 1.25L;
    return roundings;
}

/// One ray of a convex solid. span(grow): the closed form; crossing(t, near): how it is met there.
template <class SpanOf, class CrossingAt>
void judge_span(Tally& tally, const RayList& rays, const SpanList& got, std::size_t k, Real80 size, Real80 rounding,
                SpanOf span, CrossingAt crossing) {
    const bool hit = got.entry[k] <= got.exit[k];
    const ExactSpan wanted = span(0);
    ++tally.rays;
    if (hit == wanted.empty()) {
        const auto explains = [&](Real80 shift) { return span(hit ? shift : -shift).empty() != hit; };
        return tally.see_disagreement(least_shift(rounding, explains), rays, k);
    }
    if (!hit) return;
    ++tally.hits;
    for (const bool in : {true, false}) {
        const Real80 t = in ? wanted.entry : wanted.exit, found = in ? got.entry[k] : got.exit[k];
        const Crossing at = crossing(t, kNear * rounding);
        if (!is_tangent(at, rounding)) {
            tally.see_end(at, found, std::max(std::abs(t), size), rays, k);
            continue;
        }
        tally.see_tangent(least_shift(rounding * at.loss, [&](Real80 shift) {
            const ExactSpan most = span(shift), least = span(-shift);
            if (most.empty() || found < most.entry || found > most.exit) return false;
            return least.empty() || (in ? found <= least.entry : found >= least.exit);
        }), rays, k);
    }
}

/// By how much the surface must move to move a crossing by `way` along the ray.
inline Real80 shift_for(const Crossing& at, Real80 way) { return way * at.cosine + way * way / (2 * at.bend); }

struct SurfaceAnswer {
    bool hit;
    Real80 t;
};

/// One ray of a surface with an outline, met at its first crossing inside that with t > 0.
inline void judge_surface(Tally& tally, const RayList& rays, std::size_t k, const SurfaceAnswer& got,
                          const Crossings& wanted, Real80 size, Real80 rounding) {
    const auto counts = [](const Crossing& at) { return std::min(at.rim, at.t); };  // negative: it does not
    int first = 0, taken = 0;
    while (first < wanted.count && counts(wanted.at[first]) < 0) ++first;
    // Which of the crossings the answer means: the nearest.
    if (wanted.count == 2 && std::abs(got.t - wanted.at[1].t) < std::abs(got.t - wanted.at[0].t)) taken = 1;
    if (!got.hit) taken = wanted.count;
    ++tally.rays;
    if (got.hit && wanted.count == 0) return tally.see_disagreement(wanted.past / rounding, rays, k);
    if (taken != first) {
        Real80 shift = 0;
        for (int i = 0; i < wanted.count; ++i) {
            const Real80 way = counts(wanted.at[i]);
            // A crossing goes when its ray is moved past the outline, or past the surface.
            const Real80 chord = wanted.at[i].bend * wanted.at[i].cosine * wanted.at[i].cosine / 2;
            const Real80 least = shift_for(wanted.at[i], std::abs(way));
            if ((way >= 0) != (i == taken)) shift = std::max(shift, way >= 0 ? std::min(least, chord) : least);
            if (i == taken) break;
        }
        return tally.see_disagreement(shift / rounding, rays, k);
    }
    if (!got.hit) return;
    ++tally.hits;
    const Crossing& at = wanted.at[taken];
    if (is_tangent(at, rounding)) return tally.see_tangent(shift_for(at, std::abs(got.t - at.t)) / rounding, rays, k);
    tally.see_end(at, got.t, std::max(std::abs(at.t), size), rays, k);
}

}  // namespace zerkalo::test
