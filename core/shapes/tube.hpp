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
template <class A>
ZERKALO_INLINE Vec3<A> in_tube_axes(const TubeData& tube, Vec3<A> v) {
    A x = v.x, y = v.y, z = v.z;
    if (!tube.upright) {
        x = dot(tube.axis_x, v);
        y = dot(tube.axis_y, v);
        z = dot(tube.axis_z, v);
    }
    return {x, y, z};
}

/// Origin in the tube's axes, from its centre.
template <class N, class O>
ZERKALO_INLINE Vec3<Length<N>> tube_seen_from(const TubeData& tube, Vec3<O> o) {
    return in_tube_axes(tube, as<Length<N>>(o - tube.centre));
}

/// Where the ray is inside the infinite double cone (or cylinder); the caps' slab picks the right nappe.
template <bool Tapered, class N>
ZERKALO_INLINE Span<N> lateral_span(const TubeData& tube, Vec3<Length<N>> o, Vec3<Direction<N>> d) {
    using R = Length<N>;
    R m = R(tube.mid_radius);
    if constexpr (Tapered) m = m + R(tube.slope) * o.y;
    R a = d.x * d.x + d.z * d.z;
    R b = o.x * d.x + o.z * d.z;
    R w_x = m * d.x;
    R w_z = m * d.z;
    R n = R(0);
    if constexpr (Tapered) {
        n = R(tube.slope) * d.y;
        a = a - n * n;
        b = b - m * n;
        w_x = w_x - n * o.x;
        w_z = w_z - n * o.z;
    }
    const R x = o.x * d.z - o.z * d.x;
    const R disc = w_x * w_x + w_z * w_z - x * x;
    const auto exists = (disc >= R(0)) | (a < R(0));
    Span<N> span = empty_span<N>();
    if (none(exists)) return span;

    const R c = o.x * o.x + o.z * o.z - m * m;
    const auto roots = roots_of_quadratic<R>(a, b, c, max(disc, R(0)));
    const R far = far_away<R>();
    R entry = min(roots.near_zero, roots.other);
    R exit = max(roots.near_zero, roots.other);
    if constexpr (Tapered) {
        // A steep ray (A < 0) stays inside beyond its last root where the radius grows, or before its first.
        const auto steep = a < R(0);
        if (any(steep)) {
            const auto widening = n > R(0);
            const R first = entry;
            entry = select(steep, select(widening, exit, -far), entry);
            exit = select(steep, select(widening, far, first), exit);
        }
    }
    // Along the axis of a cylinder (or a generator through the apex) there is no root: inside for ever, or never.
    const auto no_root = (a == R(0)) & (b == R(0));
    if (any(no_root)) {
        const auto inside = c <= R(0);
        entry = select(no_root, select(inside, -far, far), entry);
        exit = select(no_root, select(inside, far, -far), exit);
    }
    span.entry = select(exists, entry, span.entry);
    span.exit = select(exists, exit, span.exit);
    return span;
}

/// Span of the closed tube. `from`: tube_seen_from(origin). Tapered must equal tube.tapered.
template <bool Tapered, Faces F, class N, class O>
ZERKALO_INLINE Span<N> tube_span(const TubeData& tube, Vec3<O> from, Vec3<Direction<N>> direction) {
    using R = Length<N>;
    const Vec3<R> d = in_tube_axes(tube, direction);
    // Recentre: t is measured from the point nearest to the centre, and moved back at the end.
    const R t_nearest = -dot(from, d);
    const Vec3<R> o = from + d * t_nearest;
    Span<N> span = lateral_span<Tapered, N>(tube, o, d);
    if (none(span.entry <= span.exit)) return span;

    const R at_base = (R(-tube.half_height) - o.y) / d.y;
    const R at_top = (R(tube.half_height) - o.y) / d.y;
    const R enter = min(at_base, at_top);
    const R leave = max(at_base, at_top);
    if constexpr (F != Faces::none) span.face_in = select(enter > span.entry, R(kCapFace), R(kLateralFace));
    if constexpr (F == Faces::both) span.face_out = select(leave < span.exit, R(kCapFace), R(kLateralFace));
    span.entry = max(enter, span.entry) + t_nearest;
    span.exit = min(leave, span.exit) + t_nearest;
    return span;
}

/// Unit normal on the given face at a point of the surface, outward on the lateral face, along the axis on a cap.
/// At the apex of a cone the lateral normal is that of the axis.
template <class R>
ZERKALO_INLINE Vec3<R> tube_normal(const TubeData& tube, Vec3<R> p, R face) {
    const Vec3<R> q = in_tube_axes(tube, p - tube.centre);
    const R across = sqrt(q.x * q.x + q.z * q.z);
    const auto axial = (face == R(kCapFace)) | (across == R(0));
    const R scale = R(tube.normal_scale) / select(axial, R(1), across);
    const R x = select(axial, R(0), q.x * scale);
    const R y = select(axial, R(1), R(-tube.slope * tube.normal_scale));
    const R z = select(axial, R(0), q.z * scale);
    Vec3<R> n{x, y, z};
    if (!tube.upright) n = tube.axis_x * x + tube.axis_y * y + tube.axis_z * z;
    return n;
}

}  // namespace zerkalo::inline ZERKALO_ISA
