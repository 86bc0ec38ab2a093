// The surface of a mirror, plane or spherical, in curvature form: one formula from R = 0.1 to infinity.
//
// In the frame of the vertex (z along the normal) the surface is  kappa |p|^2 - 2 z = 0,  kappa = 1/R, 0 = plane:
//     A = kappa,  B = kappa o.d - d_z,  C = kappa o.o - 2 o_z,   N = (-kappa x, -kappa y, 1 - kappa z), |N| = 1.
// No centre far away is subtracted, so R = 1e9 keeps every digit. The origin is first moved to the point of the ray
// nearest to the vertex. Only the hemisphere at the vertex exists (1 - kappa z > 0). A mirror has no thickness.
// Source: Spencer, Murty, "General Ray-Tracing Procedure", J. Opt. Soc. Am. 52, 1962 (curvatures instead of radii).
#pragma once

#include "core/geometry/ray.hpp"
#include "core/numeric/roots.hpp"
#include "core/shapes/boundary.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Where a ray meets the mirror: distance, and the point in the mirror's frame. Lanes without a hit: `hit` false.
template <class N>
struct MirrorHit {
    MaskOf<N> hit;
    Length<N> t, x, y;
    Length<N> z;  // 0 on a plane
};

template <class S, class A>
ZERKALO_INLINE Vec3<A> in_mirror_axes(const S& m, Vec3<A> v) {
    return {as<A>(dot(m.right, v)), as<A>(dot(m.v, v)), as<A>(dot(m.n, v))};
}

/// Origin in the mirror's frame.
template <class N, class S, class O>
ZERKALO_INLINE Vec3<Length<N>> mirror_seen_from(const S& m, Vec3<O> o) {
    return in_mirror_axes(m, as<Length<N>>(o - m.vertex));
}

/// Plane: the one crossing with t_min < t. `from`: mirror_seen_from(origin).
template <class N, class S, class O, class T>
ZERKALO_INLINE MirrorHit<N> plane_mirror_hit(const S& m, Vec3<O> from, Vec3<Direction<N>> d, T t_min) {
    using L = Length<N>;
    const auto d_z = rounded<Direction<N>>(dot(m.n, d));
    const L t = quotient<L>(-from.z, d_z);
    const auto ahead = ahead_of(t_min, t, t);
    if (none(ahead)) return {ahead, t, t, t, L(0)};
    const L x = from.x + as<L>(t * rounded<Direction<N>>(dot(m.right, d)));
    const L y = from.y + as<L>(t * rounded<Direction<N>>(dot(m.v, d)));
    return {MaskOf<N>(ahead & inside_boundary(m.boundary, x, y)), t, x, y, L(0)};
}

/// One root of a curved mirror, kept where it is ahead, inside the boundary and on the hemisphere at the vertex.
template <class N, class S, class T>
ZERKALO_INLINE MirrorHit<N> curved_candidate(const S& m, Vec3<Length<N>> o, Vec3<Direction<N>> d, Length<N> along,
                                             Length<N> shift, T t_min) {
    using L = Length<N>;
    using D = Direction<N>;
    const Vec3<L> p = o + as<L>(d * along);
    const L t = along + shift;
    const auto near = product<D>(p.z, Curvature<N>(m.kappa)) < D(1);
    const auto ahead = ahead_of(t_min, t, along);
    const auto exists = ahead & near;
    return {MaskOf<N>(exists & inside_boundary(m.boundary, p.x, p.y)), t, p.x, p.y, p.z};
}

/// Plane or sphere: the nearest of both crossings with t_min < t inside the boundary. `d_local`: in mirror axes.
template <class N, class S, class O, class T>
ZERKALO_INLINE MirrorHit<N> curved_mirror_hit(const S& m, Vec3<O> from, Vec3<Direction<N>> d_local, T t_min) {
    using L = Length<N>;
    using D = Direction<N>;
    const L shift = -as<L>(dot(from, d_local));
    const Vec3<L> o = from + as<L>(d_local * shift);
    const auto kappa = Curvature<N>(m.kappa);
    const D b = product<D>(as<L>(dot(o, d_local)), kappa) - D(d_local.z);
    const L c = product<L>(kappa, dot(o, o)) - (o.z + o.z);
    const auto disc = as<Square<N>>(b * b) - product<Square<N>>(c, kappa);
    const auto meets = disc >= Square<N>(0);
    if (none(meets)) return {meets, shift, shift, shift, shift};
    const auto roots = roots_of_quadratic<L, D, D>(kappa, b, c, max(disc, Square<N>(0)));
    const auto one = curved_candidate<N>(m, o, d_local, roots.near_zero, shift, t_min);
    const auto two = curved_candidate<N>(m, o, d_local, roots.other, shift, t_min);
    const MaskOf<N> take_two = two.hit & ((!one.hit) | (two.t < one.t));
    return {MaskOf<N>(meets & (one.hit | two.hit)), select(take_two, two.t, one.t), select(take_two, two.x, one.x),
            select(take_two, two.y, one.y), select(take_two, two.z, one.z)};
}

/// From a point of the mirror itself: C = 0, one root is the origin, the other is the chord -2 B / A. No epsilon.
template <class N, class S, class O, class T>
ZERKALO_INLINE MirrorHit<N> own_chord_hit(const S& m, Vec3<O> on_surface, Vec3<Direction<N>> d_local, T t_min) {
    using L = Length<N>;
    using D = Direction<N>;
    const auto kappa = Curvature<N>(m.kappa);
    const D b = product<D>(as<L>(dot(on_surface, d_local)), kappa) - D(d_local.z);
    const L chord = quotient<L>(-(b + b), kappa);
    return curved_candidate<N>(m, on_surface, d_local, chord, L(0), t_min);
}

/// Unit normal of the front at a point given in the mirror's frame, in world axes.
template <class S, class L>
ZERKALO_INLINE Vec3<Direction<L>> mirror_normal(const S& m, L x, L y, L z) {
    using D = Direction<L>;
    const auto kappa = Curvature<L>(m.kappa);
    const D across = -product<D>(x, kappa), upwards = -product<D>(y, kappa), forward = D(1) - product<D>(z, kappa);
    return as<D>(m.right * across + m.v * upwards + m.n * forward);
}

}  // namespace zerkalo::inline ZERKALO_ISA
