// What a pixel must see, in double and closed form: the judge of the cases whose pictures are known. Shares no code
// with the renderer.
#pragma once

#include "core/scene/scene.hpp"

#include <cmath>
#include <limits>

namespace zerkalo::stability::exact {

using Vec = Vec3<double>;

inline double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec times(const Vec& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec plus(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec minus(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec cross(const Vec& a, const Vec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec along(const Vec& o, double t, const Vec& d) { return plus(o, times(d, t)); }
inline double length(const Vec& a) { return std::sqrt(dot(a, a)); }
inline Vec unit(const Vec& a) { return times(a, 1 / length(a)); }

/// o + t d, |d| = 1.
struct Ray {
    Vec o, d;
};
inline Vec at(const Ray& ray, double t) { return along(ray.o, t, ray.d); }

/// The ray through the centre of pixel (i, j), row 0 on top; the camera's angle is the horizontal one.
inline Ray through_pixel(const Camera& camera, int width, int height, int i, int j) {
    const Vec view = unit(camera.view);
    const Vec right = unit(cross(view, camera.up)), up = cross(right, view);
    const double half = std::tan(camera.fov / 2);
    const double x = (2 * (i + 0.5) / width - 1) * half;
    const double y = (1 - 2 * (j + 0.5) / height) * half * height / width;
    return {camera.position, unit(plus(view, plus(times(right, x), times(up, y))))};
}

/// What a white matte surface shows at p with unit normal n under a lamp of intensity 1: max(0, N.L).
inline double lambert(const Vec& p, const Vec& n, const Vec& lamp) {
    const double cosine = dot(n, unit(minus(lamp, p)));
    return cosine > 0 ? cosine : 0;
}

/// Where the ray enters and leaves a sphere; nowhere (entry above exit) if it passes by.
struct Span {
    double entry, exit;
};
inline Span sphere(const Ray& ray, const Vec& centre, double radius) {
    const double nearest = dot(minus(centre, ray.o), ray.d);
    const Vec l = minus(at(ray, nearest), centre);
    const double half2 = radius * radius - dot(l, l);
    if (half2 < 0) return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    return {nearest - std::sqrt(half2), nearest + std::sqrt(half2)};
}

/// By how much the line of the ray passes outside of a sphere; below 0 where it passes through.
inline double miss_of_sphere(const Ray& ray, const Vec& centre, double radius) {
    const Vec l = minus(at(ray, dot(minus(centre, ray.o), ray.d)), centre);
    return length(l) - radius;
}

/// Which side of an outline a pixel lies on, given its distance beyond it: 1 in, -1 out, 0 within a hair of it.
inline int side_of_outline(double beyond, double hair) { return beyond < -hair ? 1 : beyond > hair ? -1 : 0; }

}  // namespace zerkalo::stability::exact
