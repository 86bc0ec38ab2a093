// The solids that the lobe rays of a class of pixels can meet: which rays (render/lobe_reach.hpp), and for each packet
// which lanes, and every term of the intersections that the origin alone determines.
#pragma once

#include "core/render/lobe_reach.hpp"

namespace zerkalo::inline ZERKALO_ISA {

constexpr int kHoistedTerms = 28;  // lanes of origin terms that are kept; a solid without room computes its own

/// A solid that some pixels of a class can meet.
template <class R>
struct GroupCandidate {
    std::uint64_t reach;  // bit s: ray s of the chunk may meet the solid from some pixel
    std::int32_t k;
    Mask<R> allowed[kGroupPackets<R>];  // lanes whose whole lobe may meet it
};

template <class R>
struct GroupAim {
    GroupCandidate<R> candidates[kMaxSolids];
    std::int32_t count;
    Mask<R> meets[kGroupPackets<R>];  // lanes whose lobe may meet any solid; the others send no ray
};

template <class R>
struct LobeCandidate {
    Mask<R> allowed;
    std::uint64_t reach;
    const SolidPlan* solid;
    const R* terms;  // its origin terms, or null
    std::int32_t k;
};

template <class R>
struct LobeAim {
    LobeCandidate<R> candidates[kMaxSolids];
    std::int32_t count;
    std::uint64_t reach;   // rays that may meet any of them
    std::uint64_t shared;  // rays that may meet more than one
    R terms[kHoistedTerms];
};

/// Can the cone of directions about m (half-angle of the lobe) meet the solid's bounding sphere?
/// The sphere's signed distance to the cone's side is  across cos - along sin;  compared squared, without a root.
template <class R>
ZERKALO_INLINE Mask<R> lobe_may_meet(const SolidPlan& solid, const LobeData& lobe, Vec3<R> p, Vec3<R> m) {
    const Vec3<R> f = solid.bound_centre - p;
    const R along = dot(f, m);
    const Vec3<R> across = f - m * along;
    const R reach = R(solid.bound_radius) + along * R(lobe.sine);
    return (reach >= R(0)) & (dot(across, across) * R(lobe.cosine * lobe.cosine) <= reach * reach);
}

template <class R>
ZERKALO_INLINE int hoisted_terms(const SolidPlan& solid) {
    if (solid.shape == ShapeKind::sphere) return 4;
    if (solid.shape == ShapeKind::tube) return 3;
    return 2 * solid.half_spaces.slab_count;
}

template <class R>
ZERKALO_INLINE void hoist(R* terms, const Plan& plan, const SolidPlan& solid, Vec3<R> p) {
    if (solid.shape == ShapeKind::sphere) {
        const auto from = sphere_seen_from<FloatNumbers<R>>(solid.sphere, p);
        terms[0] = from.f.x, terms[1] = from.f.y, terms[2] = from.f.z, terms[3] = from.c;
    } else if (solid.shape == ShapeKind::tube) {
        const auto from = tube_seen_from<FloatNumbers<R>>(solid.tube, p);
        terms[0] = from.x, terms[1] = from.y, terms[2] = from.z;
    } else {
        const Vec3<R> o = p - solid.half_spaces.centre;
        for (std::int32_t s = 0; s < solid.half_spaces.slab_count; ++s) {
            const auto from = slab_seen_from<FloatNumbers<R>>(plan.slabs[solid.half_spaces.first_slab + s], o);
            terms[2 * s] = from.lo, terms[2 * s + 1] = from.hi;
        }
    }
}

/// Chooses the candidates of a class for one chunk of the lattice.
template <class R>
ZERKALO_ONCE void aim_group(GroupAim<R>& aim, const Plan& plan, const LobeData& lobe, CandidateMask solids,
                              const LatticeChunk& chunk, const GroupFrames<R>& frames) {
    aim.count = 0;
    for (std::int32_t i = 0; i < frames.packets; ++i) aim.meets[i] = Mask<R>(plan.exact_plan != 0);
    const LobePilot pilot = pilot_of(frames);
    for (CandidateMask left = solids; left != 0; left &= left - 1) {
        const int k = first_of(left);
        const SolidPlan& solid = plan.solids[k];
        GroupCandidate<R>& candidate = aim.candidates[aim.count];
        candidate.k = k;
        candidate.reach = ~std::uint64_t{0};
        if (plan.exact_plan) {
            for (std::int32_t i = 0; i < frames.packets; ++i) candidate.allowed[i] = Mask<R>(true);
            ++aim.count;
            continue;
        }
        auto some = Mask<R>(false);
        for (std::int32_t i = 0; i < frames.packets; ++i) {
            candidate.allowed[i] = lobe_may_meet(solid, lobe, frames.p[i], frames.frame[i].m);
            some = some | candidate.allowed[i];
            aim.meets[i] = aim.meets[i] | candidate.allowed[i];
        }
        if (none(some)) continue;
        candidate.reach = reach_of_chunk(plan, solid, chunk, pilot, frames);
        if (candidate.reach != 0) ++aim.count;
    }
}

/// Chooses the candidates of packet i of the class and hoists their terms.
template <class R>
ZERKALO_INLINE void aim_packet(LobeAim<R>& aim, const GroupAim<R>& group_aim, const Plan& plan,
                               const GroupFrames<R>& frames, std::int32_t i, Mask<R> active) {
    aim.count = 0;
    aim.reach = aim.shared = 0;
    int used = 0;
    for (std::int32_t c = 0; c < group_aim.count; ++c) {
        const GroupCandidate<R>& chosen = group_aim.candidates[c];
        const auto allowed = active & chosen.allowed[i];
        if (none(allowed)) continue;
        const SolidPlan& solid = plan.solids[chosen.k];
        aim.shared |= aim.reach & chosen.reach;
        aim.reach |= chosen.reach;
        LobeCandidate<R>& candidate = aim.candidates[aim.count++];
        candidate.reach = chosen.reach;
        candidate.allowed = allowed;
        candidate.solid = &solid;
        candidate.k = chosen.k;
        candidate.terms = nullptr;
        const int count = hoisted_terms<R>(solid);
        if (used + count > kHoistedTerms) continue;
        hoist(aim.terms + used, plan, solid, frames.p[i]);
        candidate.terms = aim.terms + used;
        used += count;
    }
}

/// As with_span(), from hoisted terms.
template <class R, class Use>
ZERKALO_INLINE void with_hoisted_span(const Plan& plan, const SolidPlan& solid, const R* terms, Vec3<R> d, Use use) {
    using N = FloatNumbers<R>;
    if (solid.shape == ShapeKind::sphere) {
        use(sphere_span<N>(solid.sphere, SphereOrigin<N>{{terms[0], terms[1], terms[2]}, terms[3]}, d));
    } else if (solid.shape == ShapeKind::half_spaces) {
        Span<N> span = whole_span<N>();
        const Slab* slabs = plan.slabs + solid.half_spaces.first_slab;
        for (std::int32_t s = 0; s < solid.half_spaces.slab_count; ++s) {
            clip<Faces::entry>(span, slabs[s], SlabOrigin<N>{terms[2 * s], terms[2 * s + 1]}, d);
            if (none(span.entry <= span.exit)) break;
        }
        use(span);
    } else if (solid.tube.tapered) {
        use(tube_span<true, Faces::entry, N>(solid.tube, Vec3<R>{terms[0], terms[1], terms[2]}, d));
    } else {
        use(tube_span<false, Faces::entry, N>(solid.tube, Vec3<R>{terms[0], terms[1], terms[2]}, d));
    }
}

/// The only candidate of ray s, which is not shared.
template <class R>
ZERKALO_INLINE const LobeCandidate<R>& only_candidate(const LobeAim<R>& aim, std::int32_t s) {
    const LobeCandidate<R>* candidate = aim.candidates;
    while (!(candidate->reach >> s & 1)) ++candidate;
    return *candidate;
}

/// Hands `use` the span of a candidate along ray d.
template <class R, class Use>
ZERKALO_INLINE void with_candidate_span(const Plan& plan, const LobeCandidate<R>& candidate, Vec3<R> p, Vec3<R> d,
                                        Use use) {
    if (candidate.terms != nullptr) {
        with_hoisted_span(plan, *candidate.solid, candidate.terms, d, use);
    } else {
        with_span<Faces::entry, R>(plan, candidate.k, PointOrigin<R>{p}, d, use);
    }
}

/// The nearest solid of each lane along ray s of the chunk, d; adds to `asked` the solids that were asked, and tells
/// `each` the solid, the face and the lanes of every hit, near or not.
template <class R, class Each>
ZERKALO_INLINE Nearest<R> nearest_in_lobe(const Plan& plan, const LobeAim<R>& aim, std::int32_t s, Vec3<R> p, Vec3<R> d,
                                          CandidateMask& asked, Each each) {
    Nearest<R> best = nothing_yet<R>();
    for (std::int32_t c = 0; c < aim.count; ++c) {
        const LobeCandidate<R>& candidate = aim.candidates[c];
        if (!(candidate.reach >> s & 1)) continue;
        const SolidPlan& solid = *candidate.solid;
        asked |= CandidateMask{1} << candidate.k;
        with_candidate_span(plan, candidate, p, d, [&](const Span<FloatNumbers<R>>& span) ZERKALO_INLINE_LAMBDA {
            const auto met = (span.entry <= span.exit) & candidate.allowed;
            keep_nearer(best, span, solid, met);
            each(candidate.k, span.face_in, met & (span.entry > R(0)));
        });
    }
    return best;
}

}  // namespace zerkalo::inline ZERKALO_ISA
