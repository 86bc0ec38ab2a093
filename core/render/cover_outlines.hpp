// The outlines of solids and of their faces as ways of straight sides (optics/overlap.hpp), seen in a packet's lobes.
//
// A round outline becomes a polygon of the same area, which the lobe can hardly tell from it: an arc cut into steps of
// the angle delta has its corners k = 1 + delta^2 / 12 + delta^4 / 160 outside, and where it goes over into a straight
// side, that side goes on for delta / 5 first. By what that is off: core/optics/README.md.
#pragma once

#include "core/optics/overlap.hpp"
#include "core/render/cover_solids.hpp"

namespace zerkalo::inline ZERKALO_ISA {

constexpr int kBallPanelSides = 5;  // for the part of the outline that lies in the cone

/// The factor k above for steps that are this part of a turn.
template <class R>
ZERKALO_INLINE R corner_scale(R step) {
    constexpr float kTurn2 = 39.478417604f;  // (2 pi)^2
    const R delta2 = step * step * R(kTurn2);
    return R(1) + delta2 * (R(1.0f / 12) + delta2 * R(1.0f / 160));
}

/// One angle after another by the same step.
template <class R>
ZERKALO_INLINE SineCosine<R> turned_by(SineCosine<R> a, SineCosine<R> step) {
    return {a.sine * step.cosine + a.cosine * step.sine, a.cosine * step.cosine - a.sine * step.sine};
}

template <class R>
ZERKALO_INLINE Vec3<R> place_on(const Rim<R>& rim, SineCosine<R> at, R scale) {
    return rim.centre + (rim.towards * at.cosine + rim.aside * at.sine) * scale;
}

/// kArcPanels times `panel` sides around a rim from the angle `from` on, which becomes the last. A panel that passes
/// the lobe is one side: whether the axis is inside, that tells as well.
template <class R>
ZERKALO_ONCE void pass_arc(Walk<R>& walk, const LobeProfile& profile, const Rim<R>& rim, SineCosine<R>& from,
                           const R& step, int panel, const Mask<R>& left, const Mask<R>& right) {
    const SineCosine<R> turn = sincos_turn(step), panel_turn = sincos_turn(step * R(float(panel)));
    const R scale = corner_scale(step);
    const auto exists = left | right;
    Vec3<R> a = place_on(rim, from, scale);
    for (int k = 0; k < kArcPanels; ++k) {
        const SineCosine<R> end = turned_by(from, panel_turn);
        const Vec3<R> last = place_on(rim, end, scale);
        if (any(exists & may_come_near(profile, a, last))) {
            for (int side = 1; side < panel; ++side) {
                from = turned_by(from, turn);
                const Vec3<R> b = place_on(rim, from, scale);
                pass_side(walk, profile, a, b, left, right);
                a = b;
            }
        }
        pass_side(walk, profile, a, last, left, right);
        a = last, from = end;
    }
}

template <class R>
ZERKALO_ONCE void walk_ball(Walk<R>& walk, const LobeProfile& profile, const SphereData& ball,
                            const Vec3<R>& p, const LobeFrame<R>& frame) {
    const Vec3<R> centre = in_lobe(frame, ball.centre - p);
    const R across = sqrt(centre.x * centre.x + centre.y * centre.y);
    const BallView<R> view = view_of_ball(profile, across, centre.z, R(ball.radius2 * ball.inverse_radius));
    const auto off_axis = across > R(0);
    const R inverse = R(1) / select(off_axis, across, R(1));
    const R x = select(off_axis, centre.x * inverse, R(1)), y = select(off_axis, centre.y * inverse, R(0));
    // The circle where the cone around the ball meets the unit sphere, from its place nearest to the axis.
    const Rim<R> rim{Vec3<R>{x * view.sine_g, y * view.sine_g, view.cosine_g} * view.cosine_a,
                     Vec3<R>{-x * view.cosine_g, -y * view.cosine_g, view.sine_g} * view.sine_a,
                     Vec3<R>{y, -x, R(0)} * view.sine_a};
    const R edge = sqrt(view.edge2), turned = sqrt(R(1) - view.edge2);
    const R step = turn_of(edge, turned) * R(4.0f / (kArcPanels * kBallPanelSides));
    SineCosine<R> from{R(-2) * edge * turned, R(1) - R(2) * view.edge2};
    const auto exists = view.edge2 > R(0);
    pass_arc(walk, profile, rim, from, step, kBallPanelSides, exists, Mask<R>(false));
    walk.inside = select(exists, walk.inside, (view.nearest < R(0)) & (view.ahead > R(0)));
}

/// Where the straight sides of a tube's silhouette meet its rim's: see pass_rim.
template <class R>
struct RimEnds {
    Vec3<R> first, last;
};

/// The part of a rim that belongs to the silhouette, from -B to B, and in lanes of `whole`, where B is pi, back to its
/// start.
template <class R>
ZERKALO_ONCE RimEnds<R> pass_rim(Walk<R>& walk, const LobeProfile& profile, const Rim<R>& rim, const R& sine,
                                 const R& cosine, int panel, bool top, const Mask<R>& exists, const Mask<R>& whole) {
    constexpr float kFifthOfTurn = 1.2566371f;  // 2 pi / 5
    const Mask<R> nowhere(false);
    const Mask<R> &left = top ? nowhere : exists, &right = top ? exists : nowhere;
    const R step = turn_of(sine, cosine) * R(2.0f / float(kArcPanels * panel + 2));
    const R on = step * R(kFifthOfTurn);
    // Along the tangents at both ends.
    const Vec3<R> middle = rim.centre + rim.towards * (cosine + sine * on);
    const Vec3<R> out = rim.aside * (sine - cosine * on);
    const RimEnds<R> ends{middle - out, middle + out};
    const R scale = corner_scale(step);
    SineCosine<R> at = turned_by(SineCosine<R>{-sine, cosine}, sincos_turn(step));
    pass_side(walk, profile, ends.first, place_on(rim, at, scale), left, right);
    pass_arc(walk, profile, rim, at, step, panel, left, right);
    pass_side(walk, profile, place_on(rim, at, scale), ends.last, left, right);
    if (any(exists & whole)) pass_side(walk, profile, ends.last, ends.first, left & whole, right & whole);
    return ends;
}

/// The silhouette of a tube: an arc of each rim, whole or none where only one is seen, and two generators.
template <class R>
ZERKALO_ONCE void walk_tube(Walk<R>& walk, const LobeProfile& profile, const TubeData& tube,
                            int panel, const Vec3<R>& p, const LobeFrame<R>& frame) {
    const TubeView<R> view = view_of_tube(tube, p, frame);
    const auto both = view.has_front & view.has_back;
    RimEnds<R> ends[2];
    for (int top = 0; top < 2; ++top) {
        const float height = top ? tube.half_height : -tube.half_height, radius = rim_radius(tube, height);
        const auto round = Mask<R>(radius > 0);
        // Where the end's cap is seen, the way around its far side.
        const auto behind = (top ? view.height > R(height) : view.height < R(height)) & round;
        const R sign = select(behind, R(-radius), R(radius));
        const Rim<R> rim{view.middle + view.up * R(height), view.towards * sign, view.aside * R(radius)};
        const auto exists = round & select(behind, view.has_back, view.has_front);
        ends[top] = pass_rim(walk, profile, rim, view.sine, select(behind, -view.cosine, view.cosine), panel, top != 0,
                             exists, !both);
    }
    pass_side(walk, profile, ends[0].last, ends[1].last, both, Mask<R>(false));
    pass_side(walk, profile, ends[0].first, ends[1].first, Mask<R>(false), both);
}

/// The cap of a tube that is seen.
template <class R>
ZERKALO_ONCE void walk_cap(Walk<R>& walk, const LobeProfile& profile, const TubeData& tube, int panel,
                           const Vec3<R>& p, const LobeFrame<R>& frame) {
    const TubeView<R> view = view_of_tube(tube, p, frame);
    const R height = R(tube.half_height);
    const R below = R(rim_radius(tube, -tube.half_height)), above = R(rim_radius(tube, tube.half_height));
    const auto top = (view.height > height) & (above > R(0)), base = (view.height < -height) & (below > R(0));
    walk.inside = top | base;
    if (none(top | base)) return;
    const R radius = select(top, above, below);
    const Rim<R> rim{view.middle + view.up * select(top, height, -height), view.towards * radius,
                     view.aside * radius};
    SineCosine<R> from{R(0), R(1)};
    pass_arc(walk, profile, rim, from, R(1 / float(kArcPanels * panel)), panel, top, base);
}

constexpr int kWholeOutline = -1;  // instead of a face

/// The outline of a polyhedron, or of one of its faces.
template <class R>
ZERKALO_ONCE void walk_polyhedron(Walk<R>& walk, const LobeProfile& profile, const Plan& plan, int k, int face,
                                  const Vec3<R>& p, const LobeFrame<R>& frame) {
    const Outline& outline = plan.outlines[k];
    PolyhedronView<R> view;
    view_polyhedron(view, plan, k, p, frame);
    for (int e = 0; e < outline.edge_count; ++e) {
        const OutlineEdge& edge = outline.edges[e];
        const Mask<R> &on_left = view.looks_here[edge.left], &on_right = view.looks_here[edge.right];
        auto left = on_left & !on_right, right = on_right & !on_left;
        if (face != kWholeOutline) {
            left = Mask<R>(face == edge.left) & on_left;
            right = Mask<R>(face == edge.right) & on_right;
        }
        if (any(left | right)) pass_side(walk, profile, view.corners[edge.from], view.corners[edge.to], left, right);
    }
    if (face != kWholeOutline) walk.inside = walk.inside & view.looks_here[face];
}

/// Two solids, one before the other, seen from a packet's places.
template <class R>
struct Outlines {
    const Plan& plan;
    const TileCover& cover;
    const Vec3<R>& p;
    const LobeFrame<R>& frame;
    int behind, before;
};

/// The outline of solid k, or of its face: a tube's cap, or one of a polyhedron in the order of its Outline.
template <class R>
ZERKALO_ONCE void walk_outline(Walk<R>& walk, const Outlines<R>& of, int k, int face) {
    const SolidPlan& solid = of.plan.solids[k];
    const LobeProfile& profile = of.plan.mirrors[0].profile;
    const int panel = of.cover.panel[k];
    if (solid.shape == ShapeKind::sphere) {
        walk_ball(walk, profile, solid.sphere, of.p, of.frame);
    } else if (solid.shape == ShapeKind::half_spaces) {
        walk_polyhedron(walk, profile, of.plan, k, face, of.p, of.frame);
    } else if (face == kWholeOutline) {
        walk_tube(walk, profile, solid.tube, panel, of.p, of.frame);
    } else {
        walk_cap(walk, profile, solid.tube, panel + (panel + 2) / 2, of.p, of.frame);
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
