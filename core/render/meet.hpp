// One solid met by one packet of rays: the closed list of shapes and the two kinds of origin.
//
// A shared origin (camera, light) has its terms in the plan (SharedOrigin); a varying one (a mirror point) computes them
// per lane.
// The bits are the same either way: hoisting moves an operation, it never changes one.
#pragma once

#include "core/render/plan.hpp"
#include "core/shapes/half_spaces.hpp"
#include "core/shapes/mesh.hpp"
#include "core/shapes/mirror_surface.hpp"
#include "core/shapes/sphere.hpp"
#include "core/shapes/tube.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The plan that the kernels of a number system read, and its parts.
template <class R>
using PlanFor = PlanOf<Formats<R>>;
template <class R>
using SolidPlanFor = SolidPlanOf<Formats<R>>;
template <class R>
using MirrorPlanFor = MirrorPlanOf<Formats<R>>;
template <class R>
using LightPlanFor = LightPlanOf<Formats<R>>;

/// One origin a lane.
template <class L>
struct PointOrigin {
    Vec3<L> o;
};

template <class R, class F>
ZERKALO_INLINE auto sphere_origin(const SolidPlanOf<F>&, int k, const SharedOriginOf<F>& origin) {
    const SharedSolidOf<F>& shared = origin.solids[k];
    return SphereOrigin<Uniform<R>>{shared.from, shared.c};
}
template <class R, class F>
ZERKALO_INLINE auto sphere_origin(const SolidPlanOf<F>& solid, int, const PointOrigin<Length<R>>& origin) {
    return sphere_seen_from<System<R>>(solid.sphere, origin.o);
}

template <class R, class F>
ZERKALO_INLINE auto tube_origin(const SolidPlanOf<F>&, int k, const SharedOriginOf<F>& origin) {
    return origin.solids[k].from;
}
template <class R, class F>
ZERKALO_INLINE auto tube_origin(const SolidPlanOf<F>& solid, int, const PointOrigin<Length<R>>& origin) {
    return tube_seen_from<System<R>>(solid.tube, origin.o);
}

template <class R, class F>
ZERKALO_INLINE auto mirror_origin(const PlanOf<F>&, int m, const SharedOriginOf<F>& origin) {
    return origin.mirrors[m];
}
template <class R, class F>
ZERKALO_INLINE auto mirror_origin(const PlanOf<F>& plan, int m, const PointOrigin<Length<R>>& origin) {
    return mirror_seen_from<System<R>>(plan.mirrors[m].shape, origin.o);
}

template <Faces F, class R, class G>
ZERKALO_INLINE Span<System<R>> half_spaces_span(const PlanOf<G>& plan, const HalfSpacesDataOf<G>& body,
                                                const SharedOriginOf<G>& origin, Vec3<Direction<R>> d) {
    const SharedSlabOf<G>* shared = origin.slabs + body.first_slab;
    const auto seen = [shared](std::int32_t s) ZERKALO_INLINE_LAMBDA {
        return SlabOrigin<Uniform<R>>{shared[s].lo, shared[s].hi};
    };
    return slabs_span<F, System<R>>(plan.slabs + body.first_slab, body.slab_count, d, seen);
}
template <Faces F, class R, class G>
ZERKALO_INLINE Span<System<R>> half_spaces_span(const PlanOf<G>& plan, const HalfSpacesDataOf<G>& body,
                                                const PointOrigin<Length<R>>& origin, Vec3<Direction<R>> d) {
    const Vec3<Length<R>> o = origin.o - body.centre;
    const SlabOf<G>* slabs = plan.slabs + body.first_slab;
    const auto seen = [&](std::int32_t s) ZERKALO_INLINE_LAMBDA { return slab_seen_from<System<R>>(slabs[s], o); };
    return slabs_span<F, System<R>>(slabs, body.slab_count, d, seen);
}

/// Hands `use` the span of convex solid k along unit directions d. Each shape has its own call of `use`: spans that
/// meet in one place after the branch would travel through memory.
template <Faces F, class R, class O, class Use>
ZERKALO_INLINE void with_span(const PlanFor<R>& plan, int k, const O& origin, Vec3<Direction<R>> d, Use use) {
    using N = System<R>;
    const SolidPlanFor<R>& solid = plan.solids[k];
    if (solid.shape == ShapeKind::sphere) {
        use(sphere_span<N>(solid.sphere, sphere_origin<R>(solid, k, origin), d));
    } else if (solid.shape == ShapeKind::half_spaces) {
        use(half_spaces_span<F, R>(plan, solid.half_spaces, origin, d));
    } else if (solid.tube.tapered) {
        use(tube_span<true, F, N>(solid.tube, tube_origin<R>(solid, k, origin), d));
    } else {
        use(tube_span<false, F, N>(solid.tube, tube_origin<R>(solid, k, origin), d));
    }
}

/// The nearest crossing of a mirror of either form with t > t_min. `local_o`: mirror_seen_from(origin).
template <class R, class O>
ZERKALO_INLINE MirrorHit<System<R>> plane_or_curved(const MirrorPlanFor<R>& mirror, Vec3<O> local_o,
                                                    Vec3<Direction<R>> d, Length<R> t_min) {
    using N = System<R>;
    MirrorHit<N> hit;
    if (mirror.curved) {
        hit = curved_mirror_hit<N>(mirror.shape, local_o, in_mirror_axes(mirror.shape, d), t_min);
    } else {
        hit = plane_mirror_hit<N>(mirror.shape, local_o, d, t_min);
    }
    return hit;
}

/// Unit normal of the mirror's front at a point in its frame.
template <class R>
ZERKALO_INLINE Vec3<Direction<R>> front_normal(const MirrorPlanFor<R>& mirror, Length<R> x, Length<R> y, Length<R> z) {
    // Of a plane exactly n in fixed point; in floating point zeros may get another sign.
    if (Formats<R>::kFixed && !mirror.curved) return spread<Direction<R>>(mirror.shape.n);
    return mirror_normal(mirror.shape, x, y, z);
}

/// A point that a ray has met.
template <class R>
ZERKALO_INLINE Vec3<Length<R>> point_at(Vec3<Length<R>> o, Vec3<Direction<R>> d, Length<R> t) {
    return fitting_sum(o, rounded<Length<R>>(d * t));
}

/// Lanes whose ray comes near the solid's bounding sphere. Conservative: without the others nothing is missed.
template <class R>
    requires(!Formats<R>::kFixed)
ZERKALO_INLINE Mask<R> may_meet(const SolidPlanFor<R>& solid, Vec3<R> o, Vec3<R> d, Mask<R> active) {
    const Vec3<R> f = o - solid.bound_centre;
    const Vec3<R> l = f - d * dot(f, d);
    return active & (dot(l, l) <= solid.bound_radius * solid.bound_radius);
}

/// Room for the rounding of squares of lengths up to 15 and of unit directions.
template <class R>
constexpr auto kSquareRoom = Area<Uniform<R>>::from_raw(std::int64_t{1} << 35);

/// The same in fixed point, where |f|^2 - (f.d)^2 keeps its digits. The origins are points, or one that all lanes share.
template <class R, class A>
    requires(Formats<R>::kFixed)
ZERKALO_INLINE Mask<R> may_meet(const SolidPlanFor<R>& solid, Vec3<Fixed<A, Length<R>::kFormat>> o,
                                Vec3<Direction<R>> d, Mask<R> active) {
    const auto f = fitting_difference(o, solid.bound_centre);
    const auto along = rounded<Length<R>>(dot(f, d));
    const auto beyond =
        fitting_difference(dot_of_ways(f, f), fitting_sum(solid.bound_radius * solid.bound_radius, kSquareRoom<R>));
    return active & (along * along >= beyond);
}

/// Whether some ray of the packet may, of rays from one origin. No picture depends on a yes too many: packets in vector
/// registers ask in float.
template <class R>
ZERKALO_INLINE bool any_may_meet(const SolidPlanFor<R>& solid, Vec3<Length<Uniform<R>>> o, const Vec3<Direction<R>>& d,
                                 const Mask<R>& active) {
#if defined(ZERKALO_INT_VECTORS)
    if constexpr (IntLaneTraits<Mask<R>>::kInVectors) {
        // Room for the rounding of squares of lengths up to 15; one, as a direction, squared.
        constexpr float kRoom = 0x1p-10f * 0x1p54f, kOne2 = 0x1p60f;
        static_assert(Length<R>::kFraction == 27 && Direction<R>::kFraction == 30);
        const auto f = fitting_difference(o, solid.bound_centre);
        const float x = steps_of(f.x), y = steps_of(f.y), z = steps_of(f.z), r = steps_of(solid.bound_radius);
        const float beyond = (x * x + y * y + z * z - r * r - kRoom) * kOne2;
        const Floats along = steps_of(d.x) * x + steps_of(d.y) * y + steps_of(d.z) * z;
        return any_of(active, Words(along * along >= beyond));
    }
#endif
    return any(may_meet<R>(solid, o, d, active));
}

/// n, turned against d. At exactly 0 either side is right.
template <class R>
ZERKALO_INLINE Vec3<R> turned_against(Vec3<R> n, Vec3<R> d) {
    const auto flip = opposite_sign(dot(n, d));
    return {from_bits(to_bits(n.x) ^ flip), from_bits(to_bits(n.y) ^ flip), from_bits(to_bits(n.z) ^ flip)};
}
template <class A, Format F>
ZERKALO_INLINE Vec3<Fixed<A, F>> turned_against(Vec3<Fixed<A, F>> n, Vec3<Fixed<A, F>> d) {
    const auto along = dot(n, d);
    return select(along < decltype(along)(0), n, -n);
}

/// Unit normal at a point of a solid, turned against d (towards where the ray comes from), in the lanes of `here`.
template <class R>
ZERKALO_INLINE Vec3<Direction<R>> normal_towards(const PlanFor<R>& plan, const SolidPlanFor<R>& solid,
                                                 Vec3<Length<R>> p, Index<R> face, Vec3<Direction<R>> d, Mask<R> here) {
    using D = Direction<R>;
    Vec3<D> n;
    if (solid.shape == ShapeKind::sphere) {
        n = sphere_normal(solid.sphere, p);
    } else if (solid.shape == ShapeKind::tube) {
        n = tube_normal(solid.tube, p, face);
    } else if (solid.shape == ShapeKind::half_spaces) {
        n = half_spaces_normal<R>(solid.half_spaces, plan.slabs + solid.half_spaces.first_slab, face, here);
    } else {
        n = {D(0), D(1), D(0)};
        const auto* triangles = plan.triangles + solid.mesh.first;
        for (std::int32_t s = 0; s < solid.mesh.count; ++s) {
            const auto on_face = here & (face == index_of<R>(s));
            if (any(on_face)) n = select(on_face, spread<D>(triangles[s].normal), n);
        }
    }
    return turned_against(n, d);
}

}  // namespace zerkalo::inline ZERKALO_ISA
