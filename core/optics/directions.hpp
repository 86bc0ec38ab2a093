// Directions of light at a surface: reflection (seed formulas 1.1, 1.2) and refraction (Snell).
#pragma once

#include "core/geometry/unit.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Seed formula 1.2 for a ray that travels along d and meets a surface with unit normal n: d - 2 n (n.d).
template <class D>
ZERKALO_INLINE Vec3<D> reflect(Vec3<D> d, Vec3<D> n) {
    const D cosine = rounded<D>(dot(d, n));
    return fitting_difference(d, as<D>(n * (cosine + cosine)));
}

/// The same for a direction l that points away from the surface (towards the light): 2 n (n.l) - l.
template <class D, class W>
ZERKALO_INLINE Vec3<D> mirror_direction(Vec3<D> l, Vec3<D> n, W n_dot_l) {
    return fitting_difference(as<D>(n * (n_dot_l + n_dot_l)), l);
}

template <class R>
struct Refraction {
    Vec3<Direction<R>> d;  // unit direction behind the surface; meaningless where total
    Mask<R> total;         // total internal reflection: nothing goes through
};

/// Snell's law for d meeting the normal n (n.d < 0); eta = index before / index behind.
/// 1 - eta^2 sin^2 is taken as (1 - eta s)(1 + eta s), s = |d x n|: no cancellation at the critical angle.
template <class D, class E>
ZERKALO_INLINE Refraction<Numbers<D>> refract(Vec3<D> d, Vec3<D> n, E eta) {
    const Vec3<D> across = as<D>(cross(d, n));
    const D eta_sine = as<D>(eta * root<D>(dot(across, across)));
    const Square<D> cosine2 = (D(1) - eta_sine) * (D(1) + eta_sine);
    const auto total = cosine2 < Square<D>(0);
    const D cosine = -as<D>(dot(d, n));
    const E along_n = as<E>(eta * cosine) - as<E>(root<D>(max(cosine2, Square<D>(0))));
    return {as<D>(d * eta + n * along_n), total};
}

/// A direction that is unit but for rounding, put right: one Newton step turns an error e of the length into 1.5 e^2.
/// From wall to wall of a ball that error would grow by 1 + 12 cos^4 of the angle with each bounce: a length that is
/// wrong by e puts the next point 3 e cos^2 off the wall, its normal is as wrong, and the reflected length 4 cos^2 that.
template <class R>
ZERKALO_INLINE Vec3<R> unit_again(Vec3<R> d) {
    return d * (R(1.5f) - R(0.5f) * dot(d, d));
}
template <class A, Format F>
ZERKALO_INLINE Vec3<Fixed<A, F>> unit_again(Vec3<Fixed<A, F>> d) {
    return unit_of(d).unit;
}

/// Two unit vectors that make an orthonormal frame with the unit vector m, without a branch.
/// Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
template <class D>
struct Tangents {
    Vec3<D> t, b;
};
template <class D>
ZERKALO_INLINE Tangents<D> tangents_of(Vec3<D> m) {
    const D sign = flip_sign(D(1), m.z);
    const D a = quotient<D>(D(-1), sign + m.z);
    const D c = as<D>(as<D>(m.x * m.y) * a);
    const D sign_x = as<D>(sign * m.x);
    return {{D(1) + as<D>(as<D>(sign_x * m.x) * a), as<D>(sign * c), -sign_x},
            {c, sign + as<D>(as<D>(m.y * m.y) * a), -m.y}};
}

}  // namespace zerkalo::inline ZERKALO_ISA
