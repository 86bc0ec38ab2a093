// One solid met by one packet of rays: the closed list of shapes and the two kinds of origin.
//
// A shared origin (camera, light) has its terms in the plan (SharedOrigin); a varying one (a mirror point) computes them per lane.
// The bits are the same either way: hoisting moves an operation, it never changes one.
#pragma once

#include "core/render/plan.hpp"
#include "core/shapes/half_spaces.hpp"
#include "core/shapes/mesh.hpp"
#include "core/shapes/mirror_surface.hpp"
#include "core/shapes/sphere.hpp"
#include "core/shapes/tube.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// One origin a lane.
template <class R>
struct PointOrigin {
    Vec3<R> o;
};

template <class R>
ZERKALO_INLINE auto sphere_origin(const SolidPlan&, int k, const SharedOrigin& origin) {
    const SharedSolid& shared = origin.solids[k];
    return SphereOrigin<FloatNumbers<float>>{shared.from, shared.c};
}
template <class R>
ZERKALO_INLINE auto sphere_origin(const SolidPlan& solid, int, const PointOrigin<R>& origin) {
    return sphere_seen_from<FloatNumbers<R>>(solid.sphere, origin.o);
}

template <class R>
ZERKALO_INLINE auto tube_origin(const SolidPlan&, int k, const SharedOrigin& origin) {
    return origin.solids[k].from;
}
template <class R>
ZERKALO_INLINE auto tube_origin(const SolidPlan& solid, int, const PointOrigin<R>& origin) {
    return tube_seen_from<FloatNumbers<R>>(solid.tube, origin.o);
}

template <class R>
ZERKALO_INLINE auto mirror_origin(const Plan&, int m, const SharedOrigin& origin) {
    return origin.mirrors[m];
}
template <class R>
ZERKALO_INLINE auto mirror_origin(const Plan& plan, int m, const PointOrigin<R>& origin) {
    return mirror_seen_from<FloatNumbers<R>>(plan.mirrors[m].shape, origin.o);
}

template <Faces F, class R>
ZERKALO_INLINE Span<FloatNumbers<R>> half_spaces_span(const Plan& plan, const HalfSpacesData& body,
                                                      const SharedOrigin& origin, Vec3<R> d) {
    Span<FloatNumbers<R>> span = whole_span<FloatNumbers<R>>();
    const SharedSlab* shared = origin.slabs + body.first_slab;
    const Slab* slabs = plan.slabs + body.first_slab;
    for (std::int32_t s = 0; s < body.slab_count; ++s) {
        clip<F>(span, slabs[s], SlabOrigin<FloatNumbers<float>>{shared[s].lo, shared[s].hi}, d);
        if (none(span.entry <= span.exit)) break;
    }
    return span;
}
template <Faces F, class R>
ZERKALO_INLINE Span<FloatNumbers<R>> half_spaces_span(const Plan& plan, const HalfSpacesData& body,
                                                      const PointOrigin<R>& origin, Vec3<R> d) {
    Span<FloatNumbers<R>> span = whole_span<FloatNumbers<R>>();
    const Vec3<R> o = origin.o - body.centre;
    const Slab* slabs = plan.slabs + body.first_slab;
    for (std::int32_t s = 0; s < body.slab_count; ++s) {
        clip<F>(span, slabs[s], slab_seen_from<FloatNumbers<R>>(slabs[s], o), d);
        if (none(span.entry <= span.exit)) break;
    }
    return span;
}

/// Hands `use` the span of convex solid k along unit directions d. Each shape has its own call of `use`: spans that
/// meet in one place after the branch would travel through memory.
template <Faces F, class R, class O, class Use>
ZERKALO_INLINE void with_span(const Plan& plan, int k, const O& origin, Vec3<R> d, Use use) {
    using N = FloatNumbers<R>;
    const SolidPlan& solid = plan.solids[k];
    if (solid.shape == ShapeKind::sphere) {
        use(sphere_span<N>(solid.sphere, sphere_origin<R>(solid, k, origin), d));
    } else if (solid.shape == ShapeKind::half_spaces) {
        use(half_spaces_span<F>(plan, solid.half_spaces, origin, d));
    } else if (solid.tube.tapered) {
        use(tube_span<true, F, N>(solid.tube, tube_origin<R>(solid, k, origin), d));
    } else {
        use(tube_span<false, F, N>(solid.tube, tube_origin<R>(solid, k, origin), d));
    }
}

/// The nearest crossing of a mirror of either form with t > t_min. `local_o`: mirror_seen_from(origin).
template <class R, class O>
ZERKALO_INLINE MirrorHit<FloatNumbers<R>> plane_or_curved(const MirrorPlan& mirror, Vec3<O> local_o, Vec3<R> d,
                                                          R t_min) {
    using N = FloatNumbers<R>;
    MirrorHit<N> hit;
    if (mirror.curved) {
        hit = curved_mirror_hit<N>(mirror.shape, local_o, in_mirror_axes(mirror.shape, d), t_min);
    } else {
        hit = plane_mirror_hit<N>(mirror.shape, local_o, d, t_min);
    }
    return hit;
}

/// Lanes whose ray comes near the solid's bounding sphere. Conservative: without the others nothing is missed.
template <class R>
ZERKALO_INLINE Mask<R> may_meet(const SolidPlan& solid, Vec3<R> o, Vec3<R> d, Mask<R> active) {
    const Vec3<R> f = o - solid.bound_centre;
    const Vec3<R> l = f - d * dot(f, d);
    return active & (dot(l, l) <= R(solid.bound_radius * solid.bound_radius));
}

/// Unit normal at a point of a solid, turned against d (towards where the ray comes from), in the lanes of `here`.
template <class R>
ZERKALO_INLINE Vec3<R> normal_towards(const Plan& plan, const SolidPlan& solid, Vec3<R> p, R face, Vec3<R> d,
                                      Mask<R> here) {
    Vec3<R> n;
    if (solid.shape == ShapeKind::sphere) {
        n = sphere_normal(solid.sphere, p);
    } else if (solid.shape == ShapeKind::tube) {
        n = tube_normal(solid.tube, p, face);
    } else if (solid.shape == ShapeKind::half_spaces) {
        n = half_spaces_normal<R>(solid.half_spaces, plan.slabs + solid.half_spaces.first_slab, face, here);
    } else {
        n = spread<R>(Vec3<float>{0, 1, 0});
        const TriangleData* triangles = plan.triangles + solid.mesh.first;
        for (std::int32_t s = 0; s < solid.mesh.count; ++s) {
            const auto on_face = here & (face == R(float(s)));
            if (any(on_face)) n = select(on_face, spread<R>(triangles[s].normal), n);
        }
    }
    // Flip where the normal points along the ray; at exactly 0 either side is right.
    const Bits<R> flip = opposite_sign(dot(n, d));
    return {from_bits(to_bits(n.x) ^ flip), from_bits(to_bits(n.y) ^ flip), from_bits(to_bits(n.z) ^ flip)};
}

}  // namespace zerkalo::inline ZERKALO_ISA
