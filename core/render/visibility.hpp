// What a ray meets first, and whether a light is visible: the two questions of ray tracing, for packets that start
// outside of every solid. (Rays that may start inside one, or on a surface of any kind: anywhere.hpp.)
//
// No epsilon: a point on the outside of a convex solid cannot be shadowed by it, so it is left out by its identity.
#pragma once

#include "core/optics/whitted.hpp"
#include "core/render/meet.hpp"

namespace zerkalo::inline ZERKALO_ISA {

using CandidateMask = std::uint64_t;  // bit k: solid k; bit kMaxSolids + m: mirror m

constexpr CandidateMask solids_in(CandidateMask mask) { return mask & 0xffffffffu; }
constexpr CandidateMask mirrors_in(CandidateMask mask) { return mask >> kMaxSolids; }
/// Bits 0 to count - 1, count <= 64.
constexpr CandidateMask first_bits(std::int32_t count) {
    return count < 64 ? (CandidateMask{1} << count) - 1 : ~CandidateMask{0};
}
constexpr CandidateMask all_of(const PlanHead& plan) {
    return first_bits(plan.solid_count) | first_bits(plan.mirror_count) << kMaxSolids;
}
ZERKALO_INLINE int first_of(CandidateMask mask) { return __builtin_ctzll(mask); }

/// The nearest solid of each lane. t is infinite and id -1 where there is none.
template <class R>
struct Nearest {
    Length<R> t;
    Index<R> id, face;
};

template <class R>
ZERKALO_INLINE Nearest<R> nothing_yet() {
    return {far_away<Length<R>>(), Index<R>(-1), Index<R>(0)};
}

/// Keeps the nearer of what was found and the entry of solid k. Ties stay with the earlier, lower index.
template <class R>
ZERKALO_INLINE void keep_nearer(Nearest<R>& best, const Span<System<R>>& span, const SolidPlanFor<R>& solid,
                                Mask<R> allowed) {
    const auto nearer = (span.entry > Length<R>(0)) & (span.entry < best.t) & allowed;
    best.t = select(nearer, span.entry, best.t);
    best.id = select(nearer, Index<R>(solid.id), best.id);
    best.face = select(nearer, span.face_in, best.face);
}

template <class R, class O>
ZERKALO_INLINE Nearest<R> nearest_solid(const Plan& plan, CandidateMask candidates, const O& origin, Vec3<R> d) {
    Nearest<R> best = nothing_yet<R>();
    for (CandidateMask left = solids_in(candidates); left != 0; left &= left - 1) {
        const int k = first_of(left);
        with_span<Faces::entry, R>(plan, k, origin, d, [&](const Span<FloatNumbers<R>>& span) ZERKALO_INLINE_LAMBDA {
            keep_nearer(best, span, plan.solids[k], span.entry <= span.exit);
        });
    }
    return best;
}

/// Takes away the lanes from which solid k hides a light: the span from the light lies between it and the point.
template <class R>
ZERKALO_INLINE void hide_by_solid(Mask<R>& visible, const Plan& plan, const LightPlan& light, int k,
                                  const ToLight<R>& to, R own_id) {
    with_span<Faces::none, R>(plan, k, light.origin, -to.l,
                           [&](const Span<FloatNumbers<R>>& span) ZERKALO_INLINE_LAMBDA {
                               const auto hidden = (span.entry > R(0)) & (span.entry < to.distance) &
                                                   (span.entry <= span.exit) & (own_id != R(plan.solids[k].id));
                               visible = visible & (!hidden);
                           });
}

/// Does any ray from the light pass the bounding sphere? Conservative. The sphere's centre is seen from the light:
/// a unit direction w passes it only if c.w > 0 and (c.w)^2 >= |c|^2 - radius^2.
template <class R>
ZERKALO_INLINE bool may_shade(const SharedBound& bound, const ToLight<R>& to, Mask<R> lit) {
    const R against = dot(bound.centre, to.l);
    return any(lit & (against < R(0)) & (against * against >= R(bound.beyond)));
}

/// Lanes of `lit` that see the light. `own_id`: the solid or mirror that each lane stands on.
template <class R>
ZERKALO_INLINE Mask<R> visible_from_outside(const Plan& plan, const LightPlan& light, CandidateMask blockers,
                                            const ToLight<R>& to, R own_id, Mask<R> lit) {
    Mask<R> visible = lit;
    for (CandidateMask left = solids_in(blockers); left != 0; left &= left - 1) {
        const int k = first_of(left);
        if (!plan.exact_plan && !may_shade(light.bounds[k], to, visible)) continue;
        hide_by_solid(visible, plan, light, k, to, own_id);
        if (none(visible)) return visible;
    }
    for (CandidateMask left = mirrors_in(blockers); left != 0; left &= left - 1) {
        const int m = first_of(left);
        const auto crossing = plane_mirror_hit<FloatNumbers<R>>(
            plan.mirrors[m].shape, mirror_origin<R>(plan, m, light.origin), -to.l, R(0));
        const auto hidden = crossing.hit & (crossing.t < to.distance) & (own_id != R(float(kMaxSolids + m)));
        visible = visible & (!hidden);
    }
    return visible;
}

}  // namespace zerkalo::inline ZERKALO_ISA
