// How much of a lobe two convex regions of directions cover together: what one solid hides of another's coverage
// (coverage.hpp). Both outlines are polygons here, round ones with as many sides as the profile can tell apart:
//
//     coverage of both = [the axis is inside of both] - 1/(2 pi) integral of cos^(n+1) dphi along the parts
//                        of each outline that lie inside of the other
//
// A way along an outline keeps its sides, in lanes, and clips them by kept ones of the other region. Sides that pass
// the profile's cone bound nothing in it: a convex region leaves a convex cone through its own sides only.
// Source of the clipping by planes: Cyrus, Beck, "Generalized Two- and Three-Dimensional Clipping", 1978.
#pragma once

#include "core/optics/coverage.hpp"

namespace zerkalo::inline ZERKALO_ISA {

constexpr int kMostSides = 48;  // a tube's outline has two arcs, their ends and two generators; a prism's at most 36
constexpr int kArcPanels = 4;   // an arc is passed in so many panels
constexpr int kMostPanelSides = (kMostSides - 8) / (2 * kArcPanels);

/// Sides that cross the cone, their region to the left of the way from a to b; zero in lanes without one.
template <class R>
struct Sides {
    Vec3<R> a[kMostSides], b[kMostSides];
    std::int32_t count;
};

/// A way along a whole outline.
template <class R>
struct Walk {
    Sides<R>& sides;
    bool keeps;                // its sides are added to these, as long as there is room
    std::int32_t clip_count;   // it is clipped by so many of the first of them; -1: nobody asks for its share
    bool full = false;         // there was no room
    Mask<R> inside{true};      // the axis lies inside
    Mask<R> crosses{false};    // some side crosses the cone
    R share{0};                // of what is inside of the sides that clip it
};

/// Lanes in which the outline's region has something of the cone.
template <class R>
ZERKALO_INLINE Mask<R> any_of(const Walk<R>& walk) {
    return walk.inside | walk.crosses;
}

/// edge_share of the part of the edge from a to b that is inside of the sides from number `first` to `end`.
template <class R>
ZERKALO_ONCE R clipped_share(const LobeProfile& profile, const Sides<R>& sides, std::int32_t first, std::int32_t end,
                             const Vec3<R>& a, const Vec3<R>& b) {
    R from = R(0), to = R(1);
    for (std::int32_t k = first; k < end; ++k) {
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
    return select(some, edge_share(profile, cross(a, b), a + way * from, a + way * to), R(0));
}

/// One side of the outline, from a to b: the region lies to its left in the lanes of `left`, to its right in those of
/// `right`; the others have no such side.
template <class R>
ZERKALO_ONCE void pass_side(Walk<R>& walk, const LobeProfile& profile, const Vec3<R>& a, const Vec3<R>& b,
                            const Mask<R>& left, const Mask<R>& right) {
    const Vec3<R> n = cross(a, b);
    const auto turns_left = n.z >= R(0);
    walk.inside = walk.inside & (turns_left | !left) & ((!turns_left) | !right);
    const Mask<R> near = (left | right) & edge_comes_near(profile, n, a, b);
    if (none(near)) return;
    const Mask<R> crosses = part_in_cone(profile, n, a, b, near).crosses;
    if (none(crosses)) return;
    walk.crosses = walk.crosses | crosses;
    const Vec3<R> nowhere{R(0), R(0), R(0)};
    const Vec3<R> from = select(crosses, select(left, a, b), nowhere);
    const Vec3<R> to = select(crosses, select(left, b, a), nowhere);
    Sides<R>& sides = walk.sides;
    if (walk.clip_count >= 0) {
        walk.share = walk.share + clipped_share(profile, sides, 0, walk.clip_count, from, to);
    }
    if (!walk.keeps) return;
    walk.full = walk.full || sides.count == kMostSides;
    if (walk.full) return;
    sides.a[sides.count] = from, sides.b[sides.count] = to;
    ++sides.count;
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
