// How much of a lobe two convex regions of directions cover together: what one solid hides of another's coverage
// (coverage.hpp). Both outlines are polygons here, round ones with as many sides as the profile can tell apart:
//
//     coverage of both = [the axis is inside of both] - 1/(2 pi) integral of cos^(n+1) dphi along the parts
//                        of each outline that lie inside of the other
//
// One region's sides are kept, in lanes; those of the other are handed over one by one, clipped by them and summed; then
// the same with the roles changed. Sides that pass the profile's cone bound nothing in it: a convex region leaves a
// convex cone through its own sides only.
// Source of the clipping by planes: Cyrus, Beck, "Generalized Two- and Three-Dimensional Clipping", 1978.
#pragma once

#include "core/optics/coverage.hpp"

namespace zerkalo::inline ZERKALO_ISA {

constexpr int kMostSides = 58;  // a tube's outline has two arcs, their ends and two generators; a prism's at most 36
constexpr int kArcPanels = 4;   // an arc is passed in so many panels
constexpr int kMostPanelSides = (kMostSides - 8) / (2 * kArcPanels);

/// Sides of a region that cross the cone, the region to the left of the way from a to b; zero in lanes without one.
template <class R>
struct Sides {
    Vec3<R> a[kMostSides], b[kMostSides];
    std::int32_t count;
};

/// A way along a whole outline: its sides are kept, or clipped by kept ones and summed.
template <class R>
struct Walk {
    Sides<R>* kept;          // where they go, or null
    const Sides<R>* within;  // what they are clipped by, if not kept
    Mask<R> inside;          // the axis lies inside
    Mask<R> crosses;         // some side crosses the cone
    R share;                 // of what is inside
};

template <class R>
ZERKALO_INLINE Walk<R> keeping(Sides<R>& sides) {
    sides.count = 0;
    return {&sides, nullptr, Mask<R>(true), Mask<R>(false), R(0)};
}
template <class R>
ZERKALO_INLINE Walk<R> clipped_by(const Sides<R>& sides) {
    return {nullptr, &sides, Mask<R>(true), Mask<R>(false), R(0)};
}

/// Lanes in which the outline's region has something of the cone.
template <class R>
ZERKALO_INLINE Mask<R> any_of(const Walk<R>& walk) {
    return walk.inside | walk.crosses;
}

/// edge_share of the part of an edge that is inside of all the sides.
template <class R>
ZERKALO_INLINE R clipped_share(const LobeProfile& profile, const Sides<R>& sides, Vec3<R> n, Vec3<R> a, Vec3<R> b) {
    R from = R(0), to = R(1);
    for (std::int32_t k = 0; k < sides.count; ++k) {
        const Vec3<R> inwards = cross(sides.a[k], sides.b[k]);
        const R at_a = dot(inwards, a), at_b = dot(inwards, b);
        const auto leaves_a = at_a < R(0), leaves_b = at_b < R(0);
        if (none(leaves_a | leaves_b)) continue;
        const R cut = at_a / (at_a - at_b);
        from = select(leaves_a, max(from, select(leaves_b, R(1), cut)), from);
        to = select(leaves_b, min(to, select(leaves_a, R(0), cut)), to);
    }
    const auto some = from < to;
    if (none(some)) return R(0);
    const Vec3<R> way = b - a;
    return select(some, edge_share(profile, n, a + way * from, a + way * to), R(0));
}

/// One side of the outline, from a to b: the region lies to its left in the lanes of `left`, to its right in those of
/// `right`; the others have no such side.
template <class R>
ZERKALO_ONCE void pass_side(Walk<R>& walk, const LobeProfile& profile, const Vec3<R>& a, const Vec3<R>& b,
                            const Mask<R>& left, const Mask<R>& right) {
    const Vec3<R> n = cross(a, b);
    const auto turns_left = n.z >= R(0);
    walk.inside = walk.inside & (turns_left | !left) & ((!turns_left) | !right);
    const auto crosses = (left | right) & part_in_cone(profile, n, a, b).crosses;
    if (none(crosses)) return;
    walk.crosses = walk.crosses | crosses;
    if (walk.kept != nullptr) {
        Sides<R>& sides = *walk.kept;
        const Vec3<R> nowhere{R(0), R(0), R(0)};
        sides.a[sides.count] = select(crosses, select(left, a, b), nowhere);
        sides.b[sides.count] = select(crosses, select(left, b, a), nowhere);
        ++sides.count;
    } else {
        const R share = clipped_share(profile, *walk.within, n, a, b);
        walk.share = walk.share + select(crosses, select(left, share, -share), R(0));
    }
}

/// May a way from a to b that stays inside of the ball over both come into the profile's cone?
template <class R>
ZERKALO_INLINE Mask<R> may_come_near(const LobeProfile& profile, Vec3<R> a, Vec3<R> b) {
    const Vec3<R> middle = (a + b) * R(0.5f), way = b - a;
    const R reach = R(0.5f) * sqrt(dot(way, way)) + middle.z * R(sqrt(profile.edge));
    const R across2 = middle.x * middle.x + middle.y * middle.y;
    return (reach >= R(0)) & (across2 * R(1 - profile.edge) <= reach * reach);
}

}  // namespace zerkalo::inline ZERKALO_ISA
