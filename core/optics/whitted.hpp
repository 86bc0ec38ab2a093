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

#include "core/geometry/unit.hpp"
#include "core/numeric/elementary.hpp"
#include "core/numeric/double_elementary.hpp"
#include "core/numeric/fixed_elementary.hpp"
#include "core/optics/directions.hpp"
#include "core/optics/optics_data.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The way from a surface point to a light.
template <class R>
struct ToLight {
    Vec3<Direction<R>> l;  // unit
    Length<R> distance;
    Weight<R> n_dot_l;
};

template <class F, class L, class D>
ZERKALO_INLINE ToLight<Numbers<L>> towards(const LightDataOf<F>& light, Vec3<L> p, Vec3<D> n) {
    const auto way = unit_of(fitting_difference(light.position, p));
    return {way.unit, way.length, rounded<Weight<L>>(dot(n, way.unit))};
}

/// 1 / d^2
template <class R>
ZERKALO_INLINE R inverse_square(R distance) {
    return R(1) / (distance * distance);
}
template <class A, Format F>
ZERKALO_INLINE auto inverse_square(Fixed<A, F> distance) {
    return reciprocal<Inverse<Fixed<A, F>>>(distance * distance);
}

/// Whether a highlight of exponent n counts in some lane: where x = 1 - R.V is less than 1 and than limit / n. No
/// picture depends on a yes too many: packets in vector registers ask in float, the others not at all.
template <class R>
ZERKALO_INLINE bool may_shine([[maybe_unused]] const ToLight<R>& to, [[maybe_unused]] const Vec3<Direction<R>>& n,
                              [[maybe_unused]] const Vec3<Direction<R>>& v,
                              [[maybe_unused]] Exponent<Uniform<R>> limit,
                              [[maybe_unused]] Exponent<Uniform<R>> shininess, [[maybe_unused]] const Mask<R>& lit) {
#if defined(ZERKALO_INT_VECTORS)
    if constexpr (IntLaneTraits<Mask<R>>::kInVectors) {
        // Room for the rounding of unit vectors and their products; R.V = 2 (N.L)(N.V) - L.V.
        constexpr float kRoom = 0x1p-16f, kOne = 0x1p30f;
        static_assert(Direction<R>::kFraction == 30 && Weight<R>::kFraction == 30);
        const float own_reach = float(limit.raw) / float(shininess.raw), reach = own_reach < 1 ? own_reach : 1;
        const Floats x = steps_of(v.x), y = steps_of(v.y), z = steps_of(v.z), n_dot_l = steps_of(to.n_dot_l);
        const Floats n_dot_v = steps_of(n.x) * x + steps_of(n.y) * y + steps_of(n.z) * z;
        const Floats l_dot_v = steps_of(to.l.x) * x + steps_of(to.l.y) * y + steps_of(to.l.z) * z;
        const float least = (1 - kRoom - reach) * (kOne * kOne * kOne);
        return any_of(lit, Words((n_dot_l + n_dot_l) * n_dot_v - l_dot_v * kOne > least));
    }
#endif
    return true;
}

/// What one visible light adds. v: unit, towards the viewer. Lanes outside `lit` are meaningless.
template <class F, class R>
ZERKALO_INLINE Rgb<Radiance<R>> light_share(const LightDataOf<F>& light, const ToLight<R>& to, Vec3<Direction<R>> n,
                                            Vec3<Direction<R>> v, const SurfaceDataOf<F>& surface, Mask<R> lit) {
    using W = Weight<R>;
    Rgb<W> share = rounded<W>(scaled(spread<W>(surface.diffuse), to.n_dot_l));
    if (surface.shininess == typename F::Exponent(0)) {
        // Whatever the angle: max(0, R.V)^0 = 1, the constant lobe.
        share = share + spread<W>(surface.specular);
    } else if (may_shine<R>(to, n, v, light.highlight_limit, surface.shininess, lit)) {
        // (R.V)^n through the chord between R and V: x = |R - V|^2 / 2 = 1 - R.V, so R.V > 0 is x < 1.
        const auto chord = mirror_direction(to.l, n, to.n_dot_l) - v;
        const auto x = half_of(dot(chord, chord));
        const auto n_x = share_product<Exponent<R>>(x, Exponent<R>(surface.shininess));
        const auto bright = lit & (x < decltype(half_of(dot(v, v)))(1)) & (n_x < Exponent<R>(light.highlight_limit));
        if (any(bright)) {
            auto asked = x;
            // Lane by lane: the other lanes get a cheap answer.
            if constexpr (Formats<R>::kFixed) asked = select(bright, x, decltype(half_of(dot(v, v)))(1));
            const W highlight = select(bright, as<W>(power_of_one_minus(asked, Exponent<R>(surface.shininess))), W(0));
            share = share + rounded<W>(scaled(spread<W>(surface.specular), highlight));
        }
    }
    // Lights together have half of the range at most (render/fit.hpp), and shares are below 2.
    const auto arriving = rounded<Radiance<R>>(spread<Radiance<R>>(light.power) * share);
    if (!light.inverse_square) return arriving;
    // A light on the surface itself: a large number instead of infinity, so that zero stays zero.
    const auto falloff = min(inverse_square(to.distance), Inverse<R>(light.falloff_limit));
    return product<Radiance<R>>(arriving, falloff);
}

}  // namespace zerkalo::inline ZERKALO_ISA
