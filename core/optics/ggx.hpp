// The microfacet lobe of a rough mirror: GGX normals of width alpha, white Fresnel, height-correlated Smith shadowing.
//
//     D(m) = alpha^2 / (pi (1 + (alpha^2 - 1) cos^2 m)^2)        f(i, o) = D(h) G2(i, o) / (4 cos_i cos_o)
//
// A ray reflects at a normal drawn from those that the viewer sees: it then weighs G2 / G1 <= 1. In the mirror's frame
// stretched by 1/alpha these normals lie half-way between the viewer and a point of a spherical cap, uniform in area.
// u = 1 is the cap's pole; small u are the rim, the steep normals. A ray that goes below the horizon is lost.
// Sources: Walter, Marschner, Li, Torrance, "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007; Heitz,
// "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), 2018; Dupuy, Benyoub, "Sampling Visible GGX Normals
// with Spherical Caps", CGF 42(8), 2023.
#pragma once

#include "core/geometry/unit.hpp"
#include "core/optics/directions.hpp"
#include "core/optics/point_sets.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class R>
ZERKALO_INLINE SineCosine<Direction<R>> azimuth_of(Phase<R> turn) {
    if constexpr (Formats<R>::kFixed) {
        return sincos_turn<Direction<R>>(turn);
    } else {
        return sincos_turn(turn);
    }
}

/// The normal that a viewer along the unit direction `v` meets; v and the result in the mirror's frame, z its normal.
template <class R>
ZERKALO_INLINE Vec3<Direction<R>> visible_normal(Vec3<Direction<R>> v, Direction<R> alpha, const SetPoint<R>& at) {
    using D = Direction<R>;
    const Vec3<D> seen = unit_of(Vec3<D>{as<D>(v.x * alpha), as<D>(v.y * alpha), v.z}).unit;
    const D u = as<D>(at.u), cap = D(1) + seen.z;
    // Heights over the cap's rim and under its pole, so that nothing cancels at either.
    const D above_rim = as<D>(u * cap), below_pole = as<D>((D(1) - u) * cap);
    const D radius = root<D>(max(below_pole * (D(2) - below_pole), Square<D>(0)));
    const SineCosine<D> azimuth = azimuth_of<R>(at.turn);
    const Vec3<D> h{as<D>(radius * azimuth.cosine) + seen.x, as<D>(radius * azimuth.sine) + seen.y, above_rim};
    return unit_of(Vec3<D>{as<D>(h.x * alpha), as<D>(h.y * alpha), h.z}).unit;
}

/// sqrt(alpha^2 + (1 - alpha^2) cos^2): cos + this is 2 cos / G1.
template <class D>
ZERKALO_INLINE D smith_root(D cosine, D alpha) {
    const Square<D> alpha2 = alpha * alpha, cosine2 = cosine * cosine;
    return root<D>(max(alpha2 + cosine2 - product<Square<D>>(alpha2, cosine2), Square<D>(0)));
}

/// G2 / G1 of rays above the horizon: between 0 and 1.
template <class D>
ZERKALO_INLINE Weight<D> ggx_weight(D cosine, D cosine_out, D alpha) {
    const D root_in = smith_root(cosine, alpha), root_out = smith_root(cosine_out, alpha);
    const Square<D> all = root_out * cosine + root_in * cosine_out;
    return min(quotient<Weight<D>>((cosine_out + root_out) * cosine, all), Weight<D>(1));
}

}  // namespace zerkalo::inline ZERKALO_ISA
