// Plane: (P - vertex).n = 0. Sphere: |P - C| = |R| with C = vertex + R n, expanded about the vertex so that a huge R
// costs no digits: |q|^2 - 2 R q.n = 0, q = P - vertex.
#include "tests/support/reference_mirror.hpp"

#include "tests/support/reference_quadric.hpp"

#include <algorithm>

namespace zerkalo::reference {
namespace {

bool in_rectangle(const Boundary& b, double x, double y) {
    return 2 * std::abs(x) <= b.width && 2 * std::abs(y) <= b.height;
}

bool in_ellipse(double width, double height, double x, double y) {
    const double u = 2 * x / width, w = 2 * y / height;
    return u * u + w * w <= 1;
}

/// Inside a convex polygon the point lies on the same side of every edge, whichever way round the corners go.
bool in_polygon(const Boundary& b, double x, double y) {
    bool left = true, right = true;
    for (int i = 0; i < b.corner_count; ++i) {
        const Vec2<double>& p = b.corners[i];
        const Vec2<double>& q = b.corners[(i + 1) % b.corner_count];
        const double side = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
        left = left && side >= 0;
        right = right && side <= 0;
    }
    return left || right;
}

}  // namespace

MirrorSurface::MirrorSurface(const Mirror& mirror)
    : mirror_(mirror), vertex_(from(mirror.position)), normal_(normalized(from(mirror.normal))) {
    const Vector up = usable_up(from(mirror.up), from(mirror.normal));
    right_ = normalized(reference::cross(up, normal_));
    v_ = reference::cross(normal_, right_);
}

void MirrorSurface::cross(const Ray& ray, Nearest& nearest) const {
    const Vector q = ray.origin - vertex_;
    const double slope = dot(ray.direction, normal_);
    if (std::isinf(mirror_.curvature_radius)) {
        if (slope != 0) offer_if_inside(ray, -dot(q, normal_) / slope, nearest);
        return;
    }
    // Solve from the point of the ray next to the vertex.
    const long double radius = mirror_.curvature_radius;
    const long double shift = -dot(q, ray.direction);
    const double s = static_cast<double>(shift);
    const Vector near = q + s * ray.direction;
    const Roots roots = roots_of(dot(ray.direction, ray.direction), dot(near, ray.direction) - radius * slope,
                                 dot(near, near) - 2 * radius * dot(near, normal_));
    for (int i = 0; i < roots.count; ++i) offer_if_inside(ray, s + roots.t[i], nearest);
}

void MirrorSurface::offer_if_inside(const Ray& ray, long double t, Nearest& nearest) const {
    const double distance = static_cast<double>(t);
    const Vector q = (ray.origin - vertex_) + distance * ray.direction;
    // The unit vector from the surface to the centre, or away from it for R < 0; for the plane it is n.
    const Vector front = normal_ - 1 / mirror_.curvature_radius * q;
    const bool near_hemisphere = dot(front, normal_) > 0;
    if (near_hemisphere && inside_outline(dot(q, right_), dot(q, v_))) nearest.offer(distance, normalized(front));
}

bool MirrorSurface::inside_outline(double x, double y) const {
    const Boundary& b = mirror_.boundary;
    switch (b.shape) {
        case BoundaryShape::rectangle: return in_rectangle(b, x, y);
        case BoundaryShape::disc: return in_ellipse(2 * b.radius, 2 * b.radius, x, y);
        case BoundaryShape::ellipse: return in_ellipse(b.width, b.height, x, y);
        case BoundaryShape::polygon: break;
    }
    return in_polygon(b, x, y);
}

Ball MirrorSurface::ball() const {
    const Boundary& b = mirror_.boundary;
    if (b.shape == BoundaryShape::disc) return {vertex_, b.radius};
    if (b.shape != BoundaryShape::polygon) return {vertex_, 0.5 * std::hypot(b.width, b.height)};
    double farthest = 0;
    for (int i = 0; i < b.corner_count; ++i) farthest = std::max(farthest, std::hypot(b.corners[i].x, b.corners[i].y));
    return {vertex_, farthest};
}

}  // namespace zerkalo::reference
