// Rotations and frames of set-up, in double: column vectors, fixed axes (seed formulas 2.12-2.14 as printed).
#pragma once

#include "core/geometry/algebra.hpp"
#include "core/numeric/setup.hpp"

namespace zerkalo::inline ZERKALO_ISA {

using Point = Vec3<double>;

inline double length(Point v) {
    // Scaled by the largest component, so that neither 1e200 nor 1e-200 leaves the range of a square.
    const double x = magnitude(v.x), y = magnitude(v.y), z = magnitude(v.z);
    const double largest = x > y ? (x > z ? x : z) : (y > z ? y : z);
    if (!(largest > 0)) return 0;
    const Point s = v * (1 / largest);
    return largest * square_root(dot(s, s));
}

/// The unit vector of v. Precondition: v is not zero.
inline Point unit(Point v) {
    const double x = magnitude(v.x), y = magnitude(v.y), z = magnitude(v.z);
    const double largest = x > y ? (x > z ? x : z) : (y > z ? y : z);
    const Point s{v.x / largest, v.y / largest, v.z / largest};
    const double norm = square_root(dot(s, s));
    return {s.x / norm, s.y / norm, s.z / norm};
}

inline Point rotated_x(Point p, double angle) {
    const auto [s, c] = sine_cosine(angle);
    return {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
}
inline Point rotated_y(Point p, double angle) {
    const auto [s, c] = sine_cosine(angle);
    return {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
}
inline Point rotated_z(Point p, double angle) {
    const auto [s, c] = sine_cosine(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

/// R_z R_y R_x p: about x first, then y, then z. Angles in radians.
inline Point rotated(Point p, Point angles) { return rotated_z(rotated_y(rotated_x(p, angles.x), angles.y), angles.z); }

/// The world axis with the smallest component along v (ties: x, y, z).
inline Point least_axis(Point v) {
    const double x = magnitude(v.x), y = magnitude(v.y), z = magnitude(v.z);
    if (x <= y && x <= z) return {1, 0, 0};
    if (y <= z) return {0, 1, 0};
    return {0, 0, 1};
}

/// `up`, or what serves instead where it is parallel to `axis` (a cross product of nothing but rounding).
inline Point usable_up(Point axis, Point up) {
    constexpr double kParallel = 0x1p-50;
    const Point u = unit(up);
    return length(cross(unit(axis), u)) <= kParallel ? least_axis(unit(axis)) : u;
}

inline Vec3<float> rounded(Point p) { return {float(p.x), float(p.y), float(p.z)}; }

}  // namespace zerkalo::inline ZERKALO_ISA
