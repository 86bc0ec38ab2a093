// The sphere (seed formula 2.1, with a centre and a radius): |p - centre|^2 = radius^2.
//
// The discriminant is r^2 - l.l, where l is the point of the ray nearest to the centre: no square of the distance is
// formed and subtracted, so a far or a small sphere keeps its digits.
// Source: Haines, Guenther, Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019.
#pragma once

#include "core/geometry/ray.hpp"
#include "core/numeric/roots.hpp"
#include "core/shapes/shape_data.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// What the origin alone determines: hoisted out of every loop over directions.
template <class N>
struct SphereOrigin {
    Vec3<Length<N>> f;  // origin - centre
    Area<N> c;          // f.f - r^2: negative inside
};

template <class N, class S, class O>
ZERKALO_INLINE SphereOrigin<N> sphere_seen_from(const S& sphere, Vec3<O> o) {
    const Vec3<Length<N>> f = as<Length<N>>(o - sphere.centre);
    return {f, as<Area<N>>(dot(f, f) - sphere.radius2)};
}

/// The ends of the span where `disc`, the discriminant, is not negative.
template <class N, class B, class C, class D>
ZERKALO_INLINE Span<N> span_of_sphere(B b, C c, D disc) {
    const auto hit = disc >= D(0);
    Span<N> span = empty_span<N>();
    if (any(hit)) {
        const auto roots = roots_of_unit_quadratic<Length<N>>(b, c, max(disc, D(0)));
        span.entry = select(hit, min(roots.near_zero, roots.other), span.entry);
        span.exit = select(hit, max(roots.near_zero, roots.other), span.exit);
    }
    return span;
}

/// Span of the ball along unit directions d. A tangent ray is inside for no length and still has entry = exit.
template <class N, class S, class M>
ZERKALO_INLINE Span<N> sphere_span(const S& sphere, const SphereOrigin<M>& from, Vec3<Direction<N>> d) {
    using L = Length<N>;
    const auto b = as<L>(dot(from.f, d));
    const auto l = from.f - as<L>(d * b);
    return span_of_sphere<N>(b, as<Area<N>>(from.c), as<Area<N>>(sphere.radius2 - dot(l, l)));
}

/// The same from inside or close to the surface, with c good to its last digit: there b^2 - c keeps what r^2 - l.l
/// loses, the height above a ground that is nearly flat.
template <class N, class M>
ZERKALO_INLINE Span<N> sphere_span_close(const SphereOrigin<M>& from, Vec3<Direction<N>> d) {
    const auto b = as<Length<N>>(dot(from.f, d));
    const auto c = as<Area<N>>(from.c);
    return span_of_sphere<N>(b, c, as<Area<N>>(as<Area<N>>(b * b) - c));
}

/// Unit outward normal at a point of the surface.
template <class S, class L>
ZERKALO_INLINE Vec3<Direction<L>> sphere_normal(const S& sphere, Vec3<L> p) {
    return product<Direction<L>>(p - sphere.centre, sphere.inverse_radius);
}

}  // namespace zerkalo::inline ZERKALO_ISA
