// How much a smooth surface between two transparent media reflects: Fresnel's equations.
//
// a, b: cosines before and behind the surface; s: sine before it; eta = index before / index behind. Amplitudes:
//
//     across the plane of incidence    r = (eta a - b) / (eta a + b) = (eta^2 - 1) / (eta a + b)^2
//     in the plane of incidence        r' = (a - eta b) / (a + eta b), |r'| = |r| |cos(i + t)| / cos(i - t)
//
// The forms on the left subtract numbers that are nearly equal where eta is near 1. Those on the right keep their
// digits at normal incidence, where r = (eta - 1) / (eta + 1), at grazing incidence and at the critical angle, where
// |r| = 1. Only cos(i + t) = a b - eta s^2 cancels, at Brewster's angle, where its square is nothing beside that of r.
// Source: Born, Wolf, "Principles of Optics", 7th edition, 1999, section 1.5.2 (Fresnel, 1823).
#pragma once

#include "core/geometry/algebra.hpp"
#include "core/numeric/fixed.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The reflected share of light that swings across the plane of incidence (s) and in it (p), each 0..1.
template <class R>
struct Reflectance {
    R across, within;
};

/// For unit d meeting the unit normal n (n.d < 0); eta = index before / index behind, above 0. Both are exactly 1 at
/// total internal reflection, and 1 where the equations say nothing (grazing incidence on an equal medium).
template <class R>
ZERKALO_INLINE Reflectance<R> fresnel_reflectance(Vec3<R> d, Vec3<R> n, R eta) {
    const Vec3<R> perpendicular = cross(d, n);
    const R sine2 = dot(perpendicular, perpendicular);
    const R eta_sine = eta * sqrt(sine2);
    const R behind2 = (R(1) - eta_sine) * (R(1) + eta_sine);
    const R before = max(-dot(d, n), R(0)), behind = sqrt(max(behind2, R(0)));
    const R sum = eta * before + behind;
    const R amplitude = (eta - R(1)) * (eta + R(1)) / (sum * sum);
    const R cosines = before * behind, sines = eta * sine2;
    const R ratio = (cosines - sines) / (cosines + sines);
    // The minimum takes its second operand where the first is not a number.
    const R across = select(behind2 < R(0), R(1), min(amplitude * amplitude, R(1)));
    return {across, min(across * (ratio * ratio), R(1))};
}

/// In fixed point by the forms on the left: their differences are exact, and what is lost of the quotients is a step of
/// the format, wherever they stand. Equations that say nothing reflect all.
template <class A, Format F, class E>
ZERKALO_INLINE auto fresnel_reflectance(Vec3<Fixed<A, F>> d, Vec3<Fixed<A, F>> n, E eta) {
    using D = Fixed<A, F>;
    using W = Weight<D>;
    const Vec3<D> perpendicular = as<D>(cross(d, n));
    const D eta_sine = as<D>(eta * root<D>(dot(perpendicular, perpendicular)));
    const auto behind2 = (D(1) - eta_sine) * (D(1) + eta_sine);
    const auto total = behind2 < decltype(behind2)(0);
    const D before = max(-as<D>(dot(d, n)), D(0)), behind = root<D>(max(behind2, decltype(behind2)(0)));
    const auto share = [total](E first, E second) ZERKALO_INLINE_LAMBDA {
        const E sum = first + second;
        const W amplitude = as<W>(quotient<E>(first - second, sum));
        return select(total | (sum <= E(0)), W(1), min(as<W>(amplitude * amplitude), W(1)));
    };
    return Reflectance<W>{share(as<E>(eta * before), as<E>(behind)), share(as<E>(before), as<E>(eta * behind))};
}

/// Of light without a direction of its own: half of it swings each way.
template <class R>
ZERKALO_INLINE R unpolarised(Reflectance<R> reflectance) {
    // As products, whose format has room for the sum of two shares.
    return as<R>(half_of(reflectance.across * R(1) + reflectance.within * R(1)));
}

}  // namespace zerkalo::inline ZERKALO_ISA
