// How much of the lobes of a packet the faces of a solid cover (optics/coverage.hpp), times what they bring: the sum
// over f of (c_f - b) coverage_f of gloss.hpp. Balls, polyhedra, tapered tubes; each as if it were
// alone (what others hide of it: render/cover_hidden.hpp).
#pragma once

#include "core/optics/coverage.hpp"
#include "core/render/cover_tile.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// A vector in the lobe's frame.
template <class R, class V>
ZERKALO_INLINE Vec3<R> in_lobe(const LobeFrame<R>& frame, Vec3<V> v) {
    return {dot(frame.t, v), dot(frame.b, v), dot(frame.m, v)};
}

/// What a hit of the given face brings; nothing in lanes outside of `here`.
template <class R>
ZERKALO_INLINE Rgb<R> shade_in(Mask<R> here, const CoveredSolid& cover, int face) {
    return {select(here, R(cover.r[face]), R(0)), select(here, R(cover.g[face]), R(0)),
            select(here, R(cover.b[face]), R(0))};
}

template <class R>
ZERKALO_INLINE Rgb<R> covered_by_ball(const CoveredSolid& cover, const Plan& plan, const LobeProfile& profile,
                                      Vec3<R> p, const LobeFrame<R>& frame) {
    const SphereData& ball = plan.solids[cover.k].sphere;
    const Vec3<R> centre = in_lobe(frame, ball.centre - p);
    const R across = sqrt(centre.x * centre.x + centre.y * centre.y);
    const R share = ball_coverage(profile, across, centre.z, R(ball.radius2 * ball.inverse_radius));
    return scaled(shade_in<R>(Mask<R>(true), cover, 0), share);
}

/// A polyhedron's corners in the lobe's frame, and which of its faces look to the packet's places.
template <class R>
struct PolyhedronView {
    Vec3<R> corners[2 * kMaxOutlineSides];
    Mask<R> looks_here[kMaxOutlineFaces];
};

template <class R>
ZERKALO_INLINE void view_polyhedron(PolyhedronView<R>& view, const Plan& plan, int k, Vec3<R> p,
                                    const LobeFrame<R>& frame) {
    const Outline& outline = plan.outlines[k];
    const HalfSpacesData& body = plan.solids[k].half_spaces;
    for (int c = 0; c < outline.corner_count; ++c) {
        view.corners[c] = in_lobe(frame, Vec3<float>{outline.x[c], outline.y[c], outline.z[c]} - p);
    }
    for (int f = 0; f < outline.face_count; ++f) {
        const OutlineFace& face = outline.faces[f];
        const auto from = slab_seen_from<FloatNumbers<R>>(plan.slabs[body.first_slab + face.slab], p - body.centre);
        view.looks_here[f] = face.low ? from.lo > R(0) : from.hi < R(0);
    }
}

template <class R>
ZERKALO_INLINE Rgb<R> covered_by_polyhedron(const CoveredSolid& cover, const Plan& plan, const LobeProfile& profile,
                                            Vec3<R> p, const LobeFrame<R>& frame) {
    const Outline& outline = plan.outlines[cover.k];
    PolyhedronView<R> view;
    view_polyhedron(view, plan, cover.k, p, frame);
    const auto& [corners, looks_here] = view;
    Mask<R> inside[kMaxOutlineFaces];
    for (int f = 0; f < outline.face_count; ++f) inside[f] = looks_here[f];
    Rgb<R> sum = spread<R>(Rgb<float>{0, 0, 0});
    for (int e = 0; e < outline.edge_count; ++e) {
        const OutlineEdge& edge = outline.edges[e];
        if (none(looks_here[edge.left] | looks_here[edge.right])) continue;
        const Vec3<R>& a = corners[edge.from];
        const Vec3<R>& b = corners[edge.to];
        const auto left = turning(a, b) >= R(0);
        inside[edge.left] = inside[edge.left] & left;
        inside[edge.right] = inside[edge.right] & !left;
        const Rgb<R> step = shade_in<R>(looks_here[edge.left], cover, outline.faces[edge.left].slab) -
                            shade_in<R>(looks_here[edge.right], cover, outline.faces[edge.right].slab);
        sum = sum - scaled(step, edge_share(profile, a, b));
    }
    for (int f = 0; f < outline.face_count; ++f) {
        if (any(inside[f])) sum = sum + shade_in<R>(inside[f], cover, outline.faces[f].slab);
    }
    return sum;
}

/// A way along an outline: its integral, and the lanes whose axis lies to its left, or to its right, all along.
template <class R>
struct OutlineWay {
    R share;
    Mask<R> left, right;

    ZERKALO_INLINE void pass(Vec3<R> a, Vec3<R> b, Mask<R> exists) {
        const auto turns_left = turning(a, b) >= R(0);
        left = left & (turns_left | !exists);
        right = right & ((!turns_left) | !exists);
    }
};

/// Rim of a tube in the lobe's frame: centre + towards cos + aside sin.
template <class R>
struct Rim {
    Vec3<R> centre, towards, aside;
};

/// May the conic arc with these three places, the middle one its control point, come into the profile's cone?
template <class R>
ZERKALO_INLINE Mask<R> may_cross(const LobeProfile& profile, Vec3<R> a, Vec3<R> c, Vec3<R> b) {
    const auto ahead = (a.z > R(0)) & (b.z > R(0)) & (c.z > R(0));
    const R inverse = R(1) / c.z, inverse_a = R(1) / a.z, inverse_b = R(1) / b.z;
    const R x = c.x * inverse, y = c.y * inverse;
    const R a_x = a.x * inverse_a - x, a_y = a.y * inverse_a - y, b_x = b.x * inverse_b - x, b_y = b.y * inverse_b - y;
    const R reach = sqrt(max(a_x * a_x + a_y * a_y, b_x * b_x + b_y * b_y)) + R(sqrt(profile.tangent2));
    return (!ahead) | (x * x + y * y <= reach * reach);
}

/// From -B to B around a rim, cos B given: four conic arcs, each cut into panels.
template <class R>
ZERKALO_ONCE OutlineWay<R> along_rim(const LobeProfile& profile, const Rim<R>& rim, const R& cosine,
                                     const Mask<R>& exists, std::int32_t panels, bool few_nodes) {
    OutlineWay<R> way{R(0), Mask<R>(true), Mask<R>(true)};
    // Cosines and sines of B, B/2, B/4.
    const R sine = sqrt(max((R(1) - cosine) * (R(1) + cosine), R(0)));
    const R half_cosine = sqrt((R(1) + cosine) * R(0.5f)), half_sine = sqrt((R(1) - cosine) * R(0.5f));
    const R quarter_cosine = sqrt((R(1) + half_cosine) * R(0.5f));
    const R quarter_sine = half_sine / (quarter_cosine + quarter_cosine);
    const R cosines[3] = {R(1), half_cosine, cosine}, sines[3] = {R(0), half_sine, sine};
    const R mid_cosines[2] = {quarter_cosine, quarter_cosine * half_cosine - quarter_sine * half_sine};
    const R mid_sines[2] = {quarter_sine, quarter_sine * half_cosine + quarter_cosine * half_sine};
    const float step = 1 / float(panels);
    for (int arc = -2; arc < 2; ++arc) {
        const int inner = arc < 0 ? -arc - 1 : arc;  // of the two arcs of a side, from its middle
        const R sign = R(arc < 0 ? -1.0f : 1.0f);
        const auto at = [&](R c, R s) ZERKALO_INLINE_LAMBDA {
            return rim.centre + rim.towards * c + rim.aside * (sign * s);
        };
        const Vec3<R> near = at(cosines[inner], sines[inner]), far = at(cosines[inner + 1], sines[inner + 1]);
        // A conic's control point lies where its tangents meet; its weight is the cosine of half the arc.
        const Vec3<R> control = rim.centre * quarter_cosine + rim.towards * mid_cosines[inner] +
                                rim.aside * (sign * mid_sines[inner]);
        const ConicArc<R> conic = arc < 0 ? ConicArc<R>{far, control, near} : ConicArc<R>{near, control, far};
        Vec3<R> from = conic.a;
        for (std::int32_t k = 0; k < panels; ++k) {
            const R t0 = R(step * float(k)), t1 = R(k + 1 < panels ? step * float(k + 1) : 1.0f);
            const Vec3<R> to = place_on(conic, t1);
            const Vec3<R> between = conic.a * ((R(1) - t0) * (R(1) - t1)) +
                                    conic.c * (t0 * (R(1) - t1) + t1 * (R(1) - t0)) + conic.b * (t0 * t1);
            way.pass(from, to, exists);
            const auto crosses = exists & may_cross(profile, from, between, to);
            if (any(crosses)) {
                const R chord = turn_of(turning(from, to), from.x * to.x + from.y * to.y);
                way.share = way.share + select(crosses, chord - arc_integral(profile, conic, t0, t1, few_nodes), R(0));
            }
            from = to;
        }
    }
    return way;
}

template <class R>
ZERKALO_INLINE OutlineWay<R> along_edge(const LobeProfile& profile, Vec3<R> a, Vec3<R> b, Mask<R> exists) {
    OutlineWay<R> way{select(exists, edge_share(profile, a, b), R(0)), Mask<R>(true), Mask<R>(true)};
    way.pass(a, b, exists);
    return way;
}

/// What a tube and a place in its axes have in common.
template <class R>
struct TubeView {
    R cosine, sine;                    // of B: the side is seen from -B to B about the direction `towards`
    Mask<R> has_front, has_back;       // B > 0, B < pi
    Vec3<R> middle, up, towards, aside;  // in the lobe's frame
    R height;                          // of the place, along the axis
};

template <class R>
ZERKALO_INLINE TubeView<R> view_of_tube(const TubeData& tube, Vec3<R> p, const LobeFrame<R>& frame) {
    TubeView<R> view;
    const Vec3<R> o = tube_seen_from<FloatNumbers<R>>(tube, p);
    const R across = sqrt(o.x * o.x + o.z * o.z), level = R(tube.mid_radius) + R(tube.slope) * o.y;
    view.has_front = across > level;
    view.has_back = -level < across;
    view.cosine = max(min(level / across, R(1)), R(-1));
    view.sine = sqrt(max((R(1) - view.cosine) * (R(1) + view.cosine), R(0)));
    view.height = o.y;
    const auto off_axis = across > R(0);
    const R inverse = R(1) / select(off_axis, across, R(1));
    const R x = select(off_axis, o.x * inverse, R(1)), z = select(off_axis, o.z * inverse, R(0));
    const Vec3<R> axis_x = in_lobe(frame, tube.axis_x), axis_z = in_lobe(frame, tube.axis_z);
    view.middle = in_lobe(frame, tube.centre - p);
    view.up = in_lobe(frame, tube.axis_y);
    view.towards = axis_x * x + axis_z * z;
    view.aside = axis_z * x - axis_x * z;
    return view;
}

/// One end of a tube: the way along its rim that belongs to the silhouette, and its cap's coverage.
template <class R>
struct TubeEnd {
    OutlineWay<R> silhouette;
    Vec3<R> first, last;  // where the silhouette's generators end: at -B and at B
    R cap;
};

template <class R>
ZERKALO_INLINE TubeEnd<R> end_of_tube(const LobeProfile& profile, const TubeView<R>& view, const TubeData& tube,
                                      bool top, const CoveredSolid& cover) {
    TubeEnd<R> end;
    const float height = top ? tube.half_height : -tube.half_height;
    const float radius = rim_radius(tube, height);
    const auto round = Mask<R>(radius > 0);
    const Rim<R> rim{view.middle + view.up * R(height), view.towards * R(radius), view.aside * R(radius)};
    end.first = rim.centre + rim.towards * view.cosine - rim.aside * view.sine;
    end.last = rim.centre + rim.towards * view.cosine + rim.aside * view.sine;
    const OutlineWay<R> front = along_rim(profile, rim, view.cosine, view.has_front & round, cover.panels,
                                            cover.few_nodes);
    const auto cap_seen = (top ? view.height > R(height) : view.height < R(height)) & round;
    end.silhouette = front;
    end.cap = R(0);
    if (none(cap_seen)) return end;
    const Rim<R> behind{rim.centre, -rim.towards, rim.aside};
    const OutlineWay<R> back = along_rim(profile, behind, -view.cosine, view.has_back & round, cover.panels,
                                           cover.few_nodes);
    end.silhouette = {select(cap_seen, back.share, front.share), select(cap_seen, back.left, front.left),
                      select(cap_seen, back.right, front.right)};
    const auto inside = top ? front.left & back.right : front.right & back.left;
    const R around = top ? front.share - back.share : back.share - front.share;
    end.cap = select(cap_seen, select(inside, R(1), R(0)) - around, R(0));
    return end;
}

template <class R>
ZERKALO_INLINE Rgb<R> covered_by_tube(const CoveredSolid& cover, const Plan& plan, const LobeProfile& profile,
                                      Vec3<R> p, const LobeFrame<R>& frame) {
    const TubeData& tube = plan.solids[cover.k].tube;
    const TubeView<R> view = view_of_tube(tube, p, frame);
    const TubeEnd<R> base = end_of_tube(profile, view, tube, false, cover);
    const TubeEnd<R> top = end_of_tube(profile, view, tube, true, cover);
    const auto both = view.has_front & view.has_back;
    const OutlineWay<R> rising = along_edge(profile, base.last, top.last, both);
    const OutlineWay<R> falling = along_edge(profile, base.first, top.first, both);
    const auto inside = base.silhouette.left & rising.left & top.silhouette.right & falling.right;
    const R around = base.silhouette.share + rising.share - top.silhouette.share - falling.share;
    const R whole = select(view.has_front, select(inside, R(1), R(0)) - around, R(0));
    const R cap = base.cap + top.cap;
    const Rgb<R> side = shade_in<R>(view.has_front, cover, kLateralFace);
    return scaled(side, whole) + scaled(shade_in<R>(Mask<R>(true), cover, kCapFace) - side, cap);
}

/// The sum over all covered solids.
template <class R>
ZERKALO_ONCE Rgb<R> covered_light(const TileCover& cover, const Plan& plan, const MirrorPlan& mirror, const Vec3<R>& p,
                                  const LobeFrame<R>& frame) {
    Rgb<R> sum = spread<R>(Rgb<float>{0, 0, 0});
    for (std::int32_t i = 0; i < cover.count; ++i) {
        const CoveredSolid& next = cover.solids[i];
        const SolidPlan& solid = plan.solids[next.k];
        const auto here = lobe_may_meet(solid, mirror.lobe, p, frame.m);
        if (none(here)) continue;
        Rgb<R> light;
        if (solid.shape == ShapeKind::sphere) {
            light = covered_by_ball(next, plan, mirror.profile, p, frame);
        } else if (solid.shape == ShapeKind::half_spaces) {
            light = covered_by_polyhedron(next, plan, mirror.profile, p, frame);
        } else {
            light = covered_by_tube(next, plan, mirror.profile, p, frame);
        }
        sum = sum + select(here, light, spread<R>(Rgb<float>{0, 0, 0}));
    }
    return sum;
}

/// Adds what the outline of solid k counts for a hit of the given faces.
template <class R>
ZERKALO_INLINE void add_counted(Rgb<R>& sum, const TileCover& cover, int k, R face, Mask<R> hit) {
    for (std::int32_t i = 0; i < cover.count; ++i) {
        const CoveredSolid& next = cover.solids[i];
        if (next.k != k) continue;
        for (int f = 0; f < next.face_count; ++f) {
            const auto here = hit & (face == R(float(f)));
            if (any(here)) sum = sum + shade_in<R>(here, next, f);
        }
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
