// What a ray meets first, and whether a light is visible, for rays that may start anywhere: inside a solid, on any
// surface, far away. The general twin of visibility.hpp.
//
// No epsilon. A ray that leaves a surface knows which one, and on which side it travels:
//     outside of a convex solid    it cannot meet that solid again: left out by identity
//     inside of a convex solid     one root is zero analytically: the other, the exit, is taken
//     from a mesh                  only front faces (outside) or back faces (inside), and not the own triangle
//     from a plane mirror          it cannot meet it again; from a curved one: the chord, in closed form
//     from a face in its plane     nor can it meet the mirror; and where both are met, the solid is
#pragma once

#include "core/render/shade.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Where rays start: the surface they leave (solid k, mirror kMaxSolids + m, or -1), its face, and the side.
template <class R>
struct Departure {
    Index<R> id, face;
    Mask<R> inside;  // travelling inside the solid `id`
};

template <class R>
struct AnyHit {
    Length<R> t;
    Index<R> id, face;
    Mask<R> from_inside;
    Length<R> x, y, z;  // on a mirror, in its frame
};

template <class R>
ZERKALO_INLINE void keep_convex(AnyHit<R>& best, const Span<System<R>>& span, const SolidPlanFor<R>& solid,
                                const Departure<R>& from, Mask<R> active, Length<R> t_min) {
    const auto own = from.id == Index<R>(solid.id);
    const auto real = active & (span.entry <= span.exit) & ((!own) | from.inside);
    const auto enters = real & (!own) & (span.entry > t_min);
    const auto leaves = real & (!enters) & (span.exit > t_min);
    const Length<R> t = select(enters, span.entry, span.exit);
    const auto nearer = (enters | leaves) & (t < best.t);
    best.t = select(nearer, t, best.t);
    best.id = select(nearer, Index<R>(solid.id), best.id);
    best.face = select(nearer, select(enters, span.face_in, span.face_out), best.face);
    best.from_inside = select(nearer, Mask<R>(leaves), best.from_inside);
}

template <class R>
ZERKALO_INLINE MeshSides<R> sides_open_to(const SolidPlanFor<R>& solid, const Departure<R>& from) {
    const auto own = from.id == Index<R>(solid.id);
    return {Mask<R>((!own) | (!from.inside)), Mask<R>((!own) | from.inside), select(own, from.face, Index<R>(-1))};
}

template <class R>
ZERKALO_INLINE void keep_mesh(AnyHit<R>& best, const PlanFor<R>& plan, const SolidPlanFor<R>& solid, Vec3<Length<R>> o,
                              Vec3<Direction<R>> d, const Departure<R>& from, Mask<R> active, Length<R> t_min) {
    const auto* triangles = plan.triangles + solid.mesh.first;
    const MeshHit<R> hit = mesh_hit(triangles, solid.mesh.count, o, d, t_min, best.t, sides_open_to<R>(solid, from));
    const auto nearer = active & hit.hit;
    best.t = select(nearer, hit.t, best.t);
    best.id = select(nearer, Index<R>(solid.id), best.id);
    best.face = select(nearer, hit.face, best.face);
    best.from_inside = select(nearer, hit.back, best.from_inside);
}

/// Lanes on a face that lies in the mirror's plane.
template <class R>
ZERKALO_INLINE Mask<R> flush_with(const MirrorPlanFor<R>& mirror, Index<R> id, Index<R> face) {
    auto flush = mask_of<R>(false);
    for (std::uint32_t left = mirror.flush; left != 0; left &= left - 1) {
        const int k = first_of(left);
        flush = flush | ((id == index_of<R>(k)) & (face == Index<R>(mirror.flush_face[k])));
    }
    return flush;
}

/// Mirror m met by rays from anywhere, its own ones included. Solids win ties: only a smaller t counts.
template <class R>
ZERKALO_INLINE MirrorHit<System<R>> any_mirror_hit(const PlanFor<R>& plan, int m, Vec3<Length<R>> o,
                                                   Vec3<Direction<R>> d, const Departure<R>& from, Length<R> t_min) {
    using N = System<R>;
    const MirrorPlanFor<R>& mirror = plan.mirrors[m];
    const auto own = from.id == index_of<R>(kMaxSolids + m);
    const Vec3<Length<R>> local_o = mirror_seen_from<N>(mirror.shape, o);
    MirrorHit<N> hit = plane_or_curved<R>(mirror, local_o, d, t_min);
    hit.hit = hit.hit & (!own);
    if (mirror.flush != 0) hit.hit = hit.hit & (!flush_with<R>(mirror, from.id, from.face));
    if (mirror.curved && any(own)) {
        const auto chord = own_chord_hit<N>(mirror.shape, local_o, in_mirror_axes(mirror.shape, d), Length<R>(0));
        hit.hit = hit.hit | (own & chord.hit);
        hit.t = select(own, chord.t, hit.t);
        hit.x = select(own, chord.x, hit.x);
        hit.y = select(own, chord.y, hit.y);
        hit.z = select(own, chord.z, hit.z);
    }
    return hit;
}

/// Camera rays of a camera on a surface leave it like any other ray: outwards past it, or through the solid.
template <class R, class F>
ZERKALO_INLINE Departure<R> departure_of_camera(const CameraPlanOf<F>& camera, Vec3<Direction<R>> d) {
    const auto inwards = as<Direction<R>>(dot(camera.out_of_it, d)) < Direction<R>(0);
    return {index_of<R>(camera.stands_on), Index<R>(-1), Mask<R>(inwards)};
}

/// Solid k as the camera sees it, if it is a ball.
template <class R>
ZERKALO_INLINE auto ball_seen_by_camera(const PlanFor<R>& plan, int k) {
    const SolidPlanFor<R>& solid = plan.solids[k];
    if constexpr (std::same_as<Formats<R>, FloatFormats>) {
        return sphere_origin<R>(solid, k, plan.camera_origin);
    } else {
        return sphere_seen_from<Uniform<R>>(solid.sphere, plan.camera.origin);
    }
}

/// Meets a sphere so close to the camera that b^2 - c is the better discriminant for its rays. False of all others.
template <class R>
ZERKALO_INLINE bool met_close_by(AnyHit<R>& best, const PlanFor<R>& plan, int k, Vec3<Direction<R>> d,
                                 const Departure<R>& from, Mask<R> active, Length<R> t_min) {
    const SolidPlanFor<R>& solid = plan.solids[k];
    if (solid.shape != ShapeKind::sphere) return false;
    const auto seen = ball_seen_by_camera<R>(plan, k);
    if (!(seen.c < solid.sphere.radius2)) return false;
    keep_convex<R>(best, sphere_span_close<System<R>>(seen, d), solid, from, active, t_min);
    return true;
}

/// The nearest surface with t > t_min; t is infinite and id -1 where there is none. `aimed`: candidates are no guess.
/// `close`: these are camera rays, and the camera is inside or close to a solid.
template <class R>
ZERKALO_ONCE AnyHit<R> nearest_anywhere(const PlanFor<R>& plan, CandidateMask candidates, bool aimed,
                                        Vec3<Length<R>> o, Vec3<Direction<R>> d, const Departure<R>& from,
                                        Mask<R> active, Length<R> t_min, bool close) {
    using L = Length<R>;
    AnyHit<R> best{far_away<L>(), Index<R>(-1), Index<R>(0), mask_of<R>(false), L(0), L(0), L(0)};
    for (CandidateMask left = solids_in(candidates); left != 0; left &= left - 1) {
        const int k = first_of(left);
        const SolidPlanFor<R>& solid = plan.solids[k];
        // The others take no part: what rounding makes of a solid far beside them must not depend on their neighbours.
        const Mask<R> near = plan.exact_plan || aimed ? active : may_meet<R>(solid, o, d, active);
        if (none(near)) continue;
        if (solid.shape == ShapeKind::mesh) {
            keep_mesh<R>(best, plan, solid, o, d, from, near, t_min);
        } else if (close && met_close_by<R>(best, plan, k, d, from, near, t_min)) {
            continue;
        } else {
            with_span<Faces::both, R>(
                plan, k, PointOrigin<L>{o}, d, [&](const Span<System<R>>& span) ZERKALO_INLINE_LAMBDA {
                    keep_convex<R>(best, span, solid, from, near, t_min);
                });
        }
    }
    for (CandidateMask left = mirrors_in(candidates); left != 0; left &= left - 1) {
        const int m = first_of(left);
        const auto hit = any_mirror_hit<R>(plan, m, o, d, from, t_min);
        auto nearer = active & hit.hit & (hit.t < best.t);
        if (plan.mirrors[m].flush != 0) nearer = nearer & (!flush_with<R>(plan.mirrors[m], best.id, best.face));
        best.t = select(nearer, hit.t, best.t);
        best.id = select(nearer, index_of<R>(kMaxSolids + m), best.id);
        best.from_inside = best.from_inside & (!nearer);
        best.x = select(nearer, hit.x, best.x);
        best.y = select(nearer, hit.y, best.y);
        best.z = select(nearer, hit.z, best.z);
    }
    return best;
}

/// Lanes in which convex solid k stands between a spot and its light: a wall of it lies strictly between.
template <class R>
ZERKALO_INLINE Mask<R> hidden_by_walls(const Span<System<R>>& span, Length<R> distance, Mask<R> own, Mask<R> inside,
                                       Mask<R> light_outside) {
    const auto zero = Length<R>(0);
    const auto crosses = (span.entry <= span.exit) & (span.entry < distance) & (span.exit > zero) &
                         ((span.entry > zero) | (span.exit < distance));
    return select(own, Mask<R>(inside & light_outside), Mask<R>(crosses));
}

/// As hide_by_solid(), for a spot on any side of any surface.
template <class R>
ZERKALO_ONCE void hide_anywhere(Mask<R>& visible, const PlanFor<R>& plan, const LightPlanFor<R>& light, int k,
                                const ToLight<R>& to, const Vec3<Length<R>>& p, const Departure<R>& spot) {
    const SolidPlanFor<R>& solid = plan.solids[k];
    const auto own = spot.id == Index<R>(solid.id);
    if (solid.shape == ShapeKind::mesh) {
        const auto hit = mesh_hit(plan.triangles + solid.mesh.first, solid.mesh.count, p, to.l, Length<R>(0), to.distance,
                                  sides_open_to<R>(solid, spot));
        visible = visible & (!hit.hit);
    } else if (light.data.distant) {
        // Only the surface's own digits are good enough here: look from the spot towards the light.
        with_span<Faces::none, R>(
            plan, k, PointOrigin<Length<R>>{p}, to.l, [&](const Span<System<R>>& span) ZERKALO_INLINE_LAMBDA {
                const auto ends = span.exit < to.distance;
                visible = visible & (!hidden_by_walls<R>(span, to.distance, own, spot.inside, ends));
            });
    } else {
        with_span<Faces::none, R>(
            plan, k, light.origin, -to.l, [&](const Span<System<R>>& span) ZERKALO_INLINE_LAMBDA {
                const auto begins = span.entry > Length<R>(0);
                visible = visible & (!hidden_by_walls<R>(span, to.distance, own, spot.inside, begins));
            });
    }
}

/// Lanes whose way to the light mirror m crosses.
template <class R>
ZERKALO_ONCE Mask<R> hidden_by_mirror(const PlanFor<R>& plan, int m, const ToLight<R>& to, const Vec3<Length<R>>& p,
                                      const Departure<R>& spot) {
    const auto hit = any_mirror_hit<R>(plan, m, p, to.l, spot, Length<R>(0));
    return Mask<R>(hit.hit & (hit.t < to.distance));
}

/// Do all ways to the light pass the solid's bounding sphere? Asked in fixed point alone: in float the question costs
/// as much as the answer to whether the solid hides the light.
template <class R>
ZERKALO_INLINE bool passed_by(const PlanFor<R>& plan, const LightPlanFor<R>& light, int k, const ToLight<R>& to,
                              Vec3<Length<R>> p, Mask<R> visible) {
    if constexpr (!Formats<R>::kFixed) {
        return false;
    } else {
        if (plan.exact_plan) return false;
        const SolidPlanFor<R>& solid = plan.solids[k];
        if (light.data.distant) return none(may_meet<R>(solid, p, to.l, visible));
        return !any_may_meet<R>(solid, light.data.position, to.l, visible);
    }
}

template <class R>
ZERKALO_INLINE Mask<R> visible_anywhere(const PlanFor<R>& plan, const LightPlanFor<R>& light, CandidateMask blockers,
                                        const ToLight<R>& to, Vec3<Length<R>> p, const Departure<R>& spot,
                                        Mask<R> lit) {
    Mask<R> visible = lit;
    for (CandidateMask left = solids_in(blockers); left != 0; left &= left - 1) {
        if (passed_by<R>(plan, light, first_of(left), to, p, visible)) continue;
        hide_anywhere<R>(visible, plan, light, first_of(left), to, p, spot);
        if (none(visible)) return visible;
    }
    for (CandidateMask left = mirrors_in(blockers); left != 0; left &= left - 1) {
        visible = visible & (!hidden_by_mirror<R>(plan, first_of(left), to, p, spot));
    }
    return visible;
}

}  // namespace zerkalo::inline ZERKALO_ISA
