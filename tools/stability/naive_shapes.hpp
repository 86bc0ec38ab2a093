// Textbook intersections in float beside the sphere: the triangle, the cone about its apex. Nothing here is used to
// render.
#pragma once

#include "tools/stability/naive.hpp"

#include <initializer_list>
#include <limits>

namespace zerkalo::stability::naive {

/// Where the ray meets the triangle; infinite where it does not. Moeller, Trumbore, 1997, with their absolute threshold
/// of the determinant.
inline float to_triangle(Vec3<float> o, Vec3<float> d, Vec3<float> a, Vec3<float> b, Vec3<float> c, float threshold) {
    constexpr float kMiss = std::numeric_limits<float>::infinity();
    const Vec3<float> e1 = minus(b, a), e2 = minus(c, a), p = cross(d, e2);
    const float determinant = dot(e1, p);
    if (std::abs(determinant) < threshold) return kMiss;
    const Vec3<float> s = minus(o, a), q = cross(s, e1);
    const float u = dot(s, p) / determinant, v = dot(d, q) / determinant, t = dot(e2, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : kMiss;
}

inline bool meets_triangle(Vec3<float> o, Vec3<float> d, Vec3<float> a, Vec3<float> b, Vec3<float> c, float threshold) {
    return std::isfinite(to_triangle(o, d, a, b, c, threshold));
}

/// Where a ray meets a wall, and the wall's unit normal.
struct WallHit {
    bool real;
    Vec3<float> normal;
};

/// The side of a tapered tube on y = 0..height as a cone about its apex, below which it lies; a cylinder where both
/// radii are equal. The nearer root that lies on the tube counts.
inline WallHit tube_wall(Vec3<float> o, Vec3<float> d, float base, float top, float height) {
    const float tangent = (base - top) / height, apex = base == top ? 0 : base / tangent;
    const float square = tangent * tangent, q = base == top ? 0 : o.y - apex;
    const float a = d.x * d.x + d.z * d.z - square * d.y * d.y;
    const float b = 2 * (o.x * d.x + o.z * d.z - square * q * d.y);
    const float c = o.x * o.x + o.z * o.z - (base == top ? base * base : square * q * q);
    const Roots both = roots(a, b, c);
    if (!both.real) return {false, {0, 0, 0}};
    for (const float t : {std::fmin(both.first, both.second), std::fmax(both.first, both.second)}) {
        const Vec3<float> p = along(o, t, d);
        if (t <= 0 || p.y < 0 || p.y > height || (base != top && p.y > apex)) continue;
        return {true, unit({p.x, tangent * std::sqrt(p.x * p.x + p.z * p.z), p.z})};
    }
    return {false, {0, 0, 0}};
}

}  // namespace zerkalo::stability::naive
