// Cylinder, cone and frustum with caps: one tapered tube (seed formula 2.2 with the exponent put right),
//
//     F(p) = x^2 + z^2 - (r + k y)^2,  |y| <= h,   r the radius at mid height, k the slope, y along the axis.
//
// With o2, d2 the parts across the axis, m = r + k o_y, n = k d_y, the discriminant in its Minkowski form is
//     B^2 - A C = |m d2 - n o2|^2 - (o2 x d2)^2        (Lagrange's identity for the metric diag(1, 1, -1)),
// taken after moving the origin to the point of the ray nearest to the centre: no large square is subtracted.
// The caps are a slab, so lateral or cap is decided by clipping, and no rim can leak. The slab also drops the other
// nappe, where r + k y < 0. Source of the family: Hill, Computer Graphics Using OpenGL (linear taper).
#pragma once

#include "core/geometry/ray.hpp"
#include "core/numeric/roots.hpp"
#include "core/shapes/shape_data.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// A vector in the tube's own axes.
template <class T, class A>
ZERKALO_INLINE Vec3<A> in_tube_axes(const T& tube, Vec3<A> v) {
    A x = v.x, y = v.y, z = v.z;
    if (!tube.upright) {
        x = rounded<A>(dot(tube.axis_x, v));
        y = rounded<A>(dot(tube.axis_y, v));
        z = rounded<A>(dot(tube.axis_z, v));
    }
    return {x, y, z};
}

/// Origin in the tube's axes, from its centre.
template <class N, class T, class O>
ZERKALO_INLINE Vec3<Length<N>> tube_seen_from(const T& tube, Vec3<O> o) {
    return in_tube_axes(tube, as<Length<N>>(o - tube.centre));
}

/// Where the ray is inside the infinite double cone (or cylinder); the caps' slab picks the right nappe.
template <bool Tapered, class N, class T>
ZERKALO_INLINE Span<N> lateral_span(const T& tube, Vec3<Length<N>> o, Vec3<Direction<N>> d) {
    using L = Length<N>;
    using A = Area<N>;
    L m = L(tube.mid_radius);
    if constexpr (Tapered) m = m + as<L>(tube.slope * o.y);
    A a = as<A>(fitting_sum(d.x * d.x, d.z * d.z));
    A b = as<A>(fitting_sum(o.x * d.x, o.z * d.z));
    A w_x = as<A>(m * d.x);
    A w_z = as<A>(m * d.z);
    Ratio<N> n = Ratio<N>(0);
    if constexpr (Tapered) {
        n = rounded<Ratio<N>>(tube.slope * d.y);
        a = fitting_difference(a, n * n);
        b = fitting_difference(b, m * n);
        w_x = fitting_difference(w_x, n * o.x);
        w_z = fitting_difference(w_z, n * o.z);
    }
    const L x = rounded<L>(fitting_difference(o.x * d.z, o.z * d.x));
    // Of a cylinder a part of its radius.
    const L v_x = Tapered ? as<L>(w_x) : rounded<L>(w_x), v_z = Tapered ? as<L>(w_z) : rounded<L>(w_z);
    const A disc = fitting_difference(fitting_sum(v_x * v_x, v_z * v_z), x * x);
    const A zero = A(0);
    auto exists = (disc >= zero) | (a < zero);
    if constexpr (Formats<N>::kFixed) exists = exists & (dot_of_ways(o, o) <= A(tube.reach2));
    Span<N> span = empty_span<N>();
    if (none(exists)) return span;

    const A c = fitting_difference(fitting_sum(o.x * o.x, o.z * o.z), m * m);
    // An area: along a wall that is nearly parallel to the axis and the ray, b is far below a step of a length.
    const auto roots = roots_of_quadratic<L, A, L>(a, b, c, max(disc, zero));
    const L far = far_away<L>();
    L entry = min(roots.near_zero, roots.other);
    L exit = max(roots.near_zero, roots.other);
    if constexpr (Tapered) {
        // A steep ray (A < 0) stays inside beyond its last root where the radius grows, or before its first.
        const auto steep = a < zero;
        if (any(steep)) {
            const auto widening = n > Ratio<N>(0);
            const L first = entry;
            entry = select(steep, select(widening, exit, -far), entry);
            exit = select(steep, select(widening, far, first), exit);
        }
    }
    // Along the axis of a cylinder (or a generator through the apex) there is no root: inside for ever, or never.
    const auto no_root = (a == zero) & (b == zero);
    if (any(no_root)) {
        const auto inside = c <= zero;
        entry = select(no_root, select(inside, -far, far), entry);
        exit = select(no_root, select(inside, far, -far), exit);
    }
    span.entry = select(exists, entry, span.entry);
    span.exit = select(exists, exit, span.exit);
    return span;
}

/// Span of the closed tube. `from`: tube_seen_from(origin). Tapered must equal tube.tapered.
template <bool Tapered, Faces F, class N, class T, class O>
ZERKALO_INLINE Span<N> tube_span(const T& tube, Vec3<O> from, Vec3<Direction<N>> direction) {
    using L = Length<N>;
    const Vec3<Direction<N>> d = in_tube_axes(tube, direction);
    // Recentre: t is measured from the point nearest to the centre, and moved back at the end.
    const L t_nearest = -rounded<L>(dot(from, d));
    const Vec3<L> o = fitting_sum(from, rounded<L>(d * t_nearest));
    Span<N> span = lateral_span<Tapered, N>(tube, o, d);
    if (none(span.entry <= span.exit)) return span;

    const auto at = quotients<L>(L(-tube.half_height) - o.y, L(tube.half_height) - o.y, d.y);
    const L enter = min(at.first, at.second);
    const L leave = max(at.first, at.second);
    const auto cap = index_of<N>(kCapFace), side = index_of<N>(kLateralFace);
    if constexpr (F != Faces::none) span.face_in = select(enter > span.entry, cap, side);
    if constexpr (F == Faces::both) span.face_out = select(leave < span.exit, cap, side);
    span.entry = max(enter, span.entry) + t_nearest;
    span.exit = min(leave, span.exit) + t_nearest;
    return span;
}

/// Unit normal on the given face at a point of the surface, outward on the lateral face, along the axis on a cap.
/// At the apex of a cone the lateral normal is that of the axis.
template <class T, class L, class I>
ZERKALO_INLINE Vec3<Direction<L>> tube_normal(const T& tube, Vec3<L> p, I face) {
    using D = Direction<L>;
    const Vec3<L> q = in_tube_axes(tube, p - tube.centre);
    const L across = root<L>(q.x * q.x + q.z * q.z);
    const auto cap = index_of<L>(kCapFace);
    const L none = L(0);
    const auto axial = (face == cap) | (across == none);
    const auto scale = quotient<Inverse<L>>(D(tube.normal_scale), select(axial, L(1), across));
    const D x = select(axial, D(0), product<D>(q.x, scale));
    const D y = select(axial, D(1), D(product<D>(-tube.slope, tube.normal_scale)));
    const D z = select(axial, D(0), product<D>(q.z, scale));
    Vec3<D> n{x, y, z};
    if (!tube.upright) n = as<D>(tube.axis_x * x + tube.axis_y * y + tube.axis_z * z);
    return n;
}

}  // namespace zerkalo::inline ZERKALO_ISA
