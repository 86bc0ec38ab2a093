// Three doubles and their algebra, for the reference tracer alone: it shares no operation with the renderer it judges.
// Colours use the same type; `times` multiplies them channel by channel.
#pragma once

#include "core/geometry/vec.hpp"

#include <cmath>

namespace zerkalo::reference {

struct Vector {
    double x = 0, y = 0, z = 0;
};

using Color = Vector;

inline Vector from(const Vec3<double>& v) { return {v.x, v.y, v.z}; }
inline Color from(const Rgb<double>& c) { return {c.r, c.g, c.b}; }

inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
inline Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vector times(const Color& a, const Color& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

inline double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(const Vector& a) { return std::hypot(a.x, a.y, a.z); }
inline Vector normalized(const Vector& a) { return 1 / length(a) * a; }

/// The world axis of which `axis` has least (ties: x, y, z).
inline Vector least_axis(const Vector& axis) {
    const double x = std::abs(axis.x), y = std::abs(axis.y), z = std::abs(axis.z);
    if (x <= y && x <= z) return {1, 0, 0};
    if (y <= z) return {0, 1, 0};
    return {0, 0, 1};
}

/// `up` itself, or, where it is parallel to `axis`, the world axis that serves instead.
inline Vector usable_up(const Vector& up, const Vector& axis) {
    // Two given vectors are parallel when their cross product is no more than the rounding of its own terms.
    constexpr double kRounding = 4e-16;
    const bool parallel = length(cross(up, axis)) <= kRounding * length(up) * length(axis);
    return parallel ? least_axis(axis) : up;
}

}  // namespace zerkalo::reference
