// What solids hide of the covered light of others: for each face f of a solid and each solid A that stands before it
// (`CoveredSolid::hidden_by`) the coverage of what lies in both outlines, times what f brings. Each face counts for
//
//     coverage_f - sum over A of coverage of (f and A)
//
// and a lobe ray that meets f counts 1 - the number of these A that it meets as well, whichever is nearest: so any
// choice of them is right. Where one of them hides f, nothing but wrong shades is left to the rays.
#pragma once

#include "core/render/cover_outlines.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The ways along a covered solid whose sum is its covered light, and what each brings.
struct ShadedWay {
    int face;  // or kWholeOutline
    Rgb<float> light;
};

ZERKALO_INLINE bool brings_nothing(const Rgb<float>& light) { return light.r == 0 && light.g == 0 && light.b == 0; }

ZERKALO_INLINE int way_count(const Plan& plan, const CoveredSolid& cover) {
    const ShapeKind shape = plan.solids[cover.k].shape;
    if (shape == ShapeKind::half_spaces) return plan.outlines[cover.k].face_count;
    return shape == ShapeKind::tube ? 2 : 1;
}

ZERKALO_INLINE ShadedWay way_of(const Plan& plan, const CoveredSolid& cover, int way) {
    const auto shade = [&](int face) ZERKALO_INLINE_LAMBDA {
        return Rgb<float>{cover.r[face], cover.g[face], cover.b[face]};
    };
    if (plan.solids[cover.k].shape == ShapeKind::half_spaces) {
        return {way, shade(plan.outlines[cover.k].faces[way].slab)};
    }
    if (way == 0) return {kWholeOutline, shade(kLateralFace)};
    return {kCapFace, shade(kCapFace) - shade(kLateralFace)};
}

/// The outline of solid `before`: its sides are the first that are kept.
template <class R>
ZERKALO_INLINE Walk<R> keep_hider(Sides<R>& sides, const Outlines<R>& of) {
    sides.count = 0;
    Walk<R> hider{sides, true, -1};
    walk_outline(hider, of, of.before, kWholeOutline);
    return hider;
}

/// What the hider's kept sides, the first of all, have inside of a face of the solid behind it, the others.
template <class R>
ZERKALO_INLINE R share_of_hider(const LobeProfile& profile, const Sides<R>& sides, std::int32_t count) {
    R sum = R(0);
    for (std::int32_t k = 0; k < count; ++k) {
        sum = sum + clipped_share(profile, sides, count, sides.count, sides.a[k], sides.b[k]);
    }
    return sum;
}

/// The same where there is no room for both: one after the other, and then the hider's own again.
template <class R>
ZERKALO_INLINE R share_of_hider_in_turn(Sides<R>& sides, const Outlines<R>& of, int face) {
    sides.count = 0;
    Walk<R> behind{sides, true, -1};
    walk_outline(behind, of, of.behind, face);
    Walk<R> hider{sides, false, sides.count};
    walk_outline(hider, of, of.before, kWholeOutline);
    keep_hider(sides, of);
    return hider.share;
}

/// What solid `before` hides of the covered light of `behind`, in the lanes of `here`.
template <class R>
ZERKALO_ONCE Rgb<R> hidden_by(const CoveredSolid& behind, const Plan& plan, const Outlines<R>& of,
                              const Mask<R>& here) {
    const Rgb<R> nothing = spread<R>(Rgb<float>{0, 0, 0});
    Sides<R> sides;
    const Walk<R> hider = keep_hider(sides, of);
    const auto some = here & any_of(hider);
    if (none(some)) return nothing;
    Rgb<R> sum = nothing;
    const std::int32_t kept = sides.count;
    for (int k = 0; k < way_count(plan, behind); ++k) {
        const ShadedWay way = way_of(plan, behind, k);
        if (brings_nothing(way.light)) continue;
        sides.count = kept;
        Walk<R> face{sides, true, kept};
        walk_outline(face, of, of.behind, way.face);
        const auto both = some & any_of(face);
        if (none(both)) continue;
        const R around = face.share + (face.full ? share_of_hider_in_turn(sides, of, way.face)
                                                 : share_of_hider(plan.mirrors[0].profile, sides, kept));
        const R share = select(hider.inside & face.inside, R(1), R(0)) - around;
        sum = sum + scaled(way.light, select(both, share, R(0)));
    }
    return sum;
}

/// The covered light of a tile's solids that others hide.
template <class R>
ZERKALO_ONCE Rgb<R> hidden_light(const TileCover& cover, const Plan& plan, const Vec3<R>& p,
                                 const LobeFrame<R>& frame) {
    Rgb<R> sum = spread<R>(Rgb<float>{0, 0, 0});
    const LobeData& lobe = plan.mirrors[0].lobe;
    for (std::int32_t i = 0; i < cover.count; ++i) {
        const CoveredSolid& behind = cover.solids[i];
        if (behind.hidden_by == 0) continue;
        const auto reaches = lobe_may_meet(plan.solids[behind.k], lobe, p, frame.m);
        for (CandidateMask left = behind.hidden_by; left != 0; left &= left - 1) {
            const int before = first_of(left);
            const auto here = reaches & lobe_may_meet(plan.solids[before], lobe, p, frame.m);
            if (none(here)) continue;
            const Outlines<R> of{plan, cover, p, frame, behind.k, before};
            sum = sum + hidden_by(behind, plan, of, here);
        }
    }
    return sum;
}

/// The solids that are taken off the outline of solid k.
ZERKALO_INLINE CandidateMask hiders_in(const TileCover& cover, int k) {
    for (std::int32_t i = 0; i < cover.count; ++i) {
        if (cover.solids[i].k == k) return cover.solids[i].hidden_by;
    }
    return 0;
}

/// The noted solids that one ray of a packet meets, and in which faces and lanes.
template <class R>
struct Meetings {
    struct {
        std::int32_t k;
        R face;
        Mask<R> met;
    } of[kMaxCovered + kMaxHiders];
    std::int32_t count = 0;

    ZERKALO_INLINE void add(const TileCover& cover, std::int32_t k, R face, Mask<R> met) {
        if (cover.noted >> k & 1 && any(met)) of[count++] = {k, face, met};
    }
};

/// What the outlines of all these solids count for the ray.
template <class R>
ZERKALO_INLINE Rgb<R> counted_of(const TileCover& cover, const Meetings<R>& meetings) {
    Rgb<R> sum = spread<R>(Rgb<float>{0, 0, 0});
    for (std::int32_t i = 0; i < meetings.count; ++i) {
        const auto& [k, face, met] = meetings.of[i];
        Rgb<R> own = spread<R>(Rgb<float>{0, 0, 0});
        add_counted(own, cover, k, face, met);
        R counts = R(1);
        for (std::int32_t j = 0; j < meetings.count; ++j) {
            const bool hides = hiders_in(cover, k) >> meetings.of[j].k & 1;
            if (hides) counts = counts - select(meetings.of[j].met, R(1), R(0));
        }
        sum = sum + scaled(own, counts);
    }
    return sum;
}

}  // namespace zerkalo::inline ZERKALO_ISA
