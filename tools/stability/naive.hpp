// The textbook formulas in float that several naive twins share. Nothing here is used to render.
#pragma once

#include "core/geometry/vec.hpp"

#include <cmath>

namespace zerkalo::stability::naive {

inline float dot(Vec3<float> a, Vec3<float> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3<float> minus(Vec3<float> a, Vec3<float> b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3<float> cross(Vec3<float> a, Vec3<float> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec3<float> along(Vec3<float> o, float t, Vec3<float> d) { return {o.x + t * d.x, o.y + t * d.y, o.z + t * d.z}; }
inline Vec3<float> times(Vec3<float> a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec3<float> unit(Vec3<float> a) { return times(a, 1 / std::sqrt(dot(a, a))); }
inline Vec3<float> rounded(const Vec3<double>& a) { return {float(a.x), float(a.y), float(a.z)}; }

/// A white matte surface at p with unit normal n under a lamp: max(0, N.L).
inline float lambert(Vec3<float> p, Vec3<float> n, Vec3<float> lamp) {
    const float cosine = dot(n, unit(minus(lamp, p)));
    return cosine > 0 ? cosine : 0;
}

/// The two roots of a t^2 + b t + c = 0 as (-b -+ sqrt(b^2 - 4ac)) / 2a.
struct Roots {
    bool real;
    float first, second;
};
inline Roots roots(float a, float b, float c) {
    const float discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return {false, 0, 0};
    const float root = std::sqrt(discriminant);
    return {true, (-b - root) / (2 * a), (-b + root) / (2 * a)};
}

/// The ray o + t d against the sphere.
inline Roots sphere(Vec3<float> o, Vec3<float> d, Vec3<float> centre, float radius) {
    const Vec3<float> f = minus(o, centre);
    return roots(dot(d, d), 2 * dot(f, d), dot(f, f) - radius * radius);
}

}  // namespace zerkalo::stability::naive
