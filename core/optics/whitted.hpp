// Whitted's local light (seed formula 1.5 without its transported terms), one light at a time:
//
//     I = I_a K_a C  +  sum over visible lights with N.L > 0 of  E ( K_d C (N.L)  +  F K_s (R.V)^n )
//
//     I_a K_a C        SurfaceData::ambient            (the ambient term)
//     E K_d C cos a    `diffuse` in light_share()      (Lambert, seed formula 1.4)
//     E K_s cos^n w    `highlight` in light_share()    (Phong, seed formula 1.3), F tints it on mirrors
//     I_r K_r, I_t K_t are the reflected and the refracted ray: render/trace.hpp
// Source: Whitted, "An Improved Illumination Model for Shaded Display", Comm. ACM 23(6), 1980; Phong, 1975.
#pragma once

#include "core/numeric/elementary.hpp"
#include "core/optics/directions.hpp"
#include "core/optics/optics_data.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The way from a surface point to a light.
template <class R>
struct ToLight {
    Vec3<R> l;  // unit
    R distance, n_dot_l;
};

template <class R>
ZERKALO_INLINE ToLight<R> towards(const LightData& light, Vec3<R> p, Vec3<R> n) {
    const Vec3<R> way = light.position - p;
    const R distance = sqrt(dot(way, way));
    const Vec3<R> l = way * (R(1) / distance);
    return {l, distance, dot(n, l)};
}

/// What one visible light adds. v: unit, towards the viewer. Lanes outside `lit` are meaningless.
template <class R>
ZERKALO_INLINE Rgb<R> light_share(const LightData& light, const ToLight<R>& to, Vec3<R> n, Vec3<R> v,
                                  const SurfaceData& surface, Mask<R> lit) {
    Rgb<R> share = scaled(spread<R>(surface.diffuse), to.n_dot_l);
    if (surface.shininess == 0) {
        // Whatever the angle: max(0, R.V)^0 = 1, the constant lobe.
        share = share + spread<R>(surface.specular);
    } else {
        // (R.V)^n through the chord between R and V: x = |R - V|^2 / 2 = 1 - R.V, so R.V > 0 is x < 1.
        const Vec3<R> chord = mirror_direction(to.l, n, to.n_dot_l) - v;
        const R x = dot(chord, chord) * R(0.5f);
        const auto bright = lit & (x < R(1)) & (x * R(surface.shininess) < R(light.highlight_limit));
        if (any(bright)) {
            const R highlight = select(bright, power_of_one_minus(x, R(surface.shininess)), R(0));
            share = share + scaled(spread<R>(surface.specular), highlight);
        }
    }
    share = spread<R>(light.power) * share;
    if (light.inverse_square) {
        // A light on the surface itself: the largest float instead of infinity, so that zero stays zero.
        const R scale = min(R(1) / (to.distance * to.distance), R(0x1.fffffep+127f));
        const R brightest = R(kBrightest);
        share = {min(share.r * scale, brightest), min(share.g * scale, brightest), min(share.b * scale, brightest)};
    }
    return share;
}

}  // namespace zerkalo::inline ZERKALO_ISA
