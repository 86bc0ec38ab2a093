// Sphere and tapered tube by their textbook equations in long double, from a ray origin moved next to the solid.
#include "tests/support/reference_quadric.hpp"

#include <algorithm>

namespace zerkalo::reference {
namespace {

struct Local {
    long double x, y, z;
};

Local minus(const Vector& a, const Vector& b) {
    return {static_cast<long double>(a.x) - b.x, static_cast<long double>(a.y) - b.y,
            static_cast<long double>(a.z) - b.z};
}

long double inner(const Local& a, const Local& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Local along(const Local& o, const Local& d, long double t) { return {o.x + t * d.x, o.y + t * d.y, o.z + t * d.z}; }

class Sphere final : public Shape {
public:
    explicit Sphere(const Solid& solid) : center_(from(solid.position)), radius_(solid.radius) {}

    void cross(const Ray& ray, Nearest& nearest) const override {
        const Local d{ray.direction.x, ray.direction.y, ray.direction.z};
        const Local far = minus(ray.origin, center_);
        const long double shift = -inner(far, d) / inner(d, d);
        const Local o = along(far, d, shift);
        const long double r = radius_;
        const Roots roots = roots_of(inner(d, d), inner(o, d), inner(o, o) - r * r);
        for (int i = 0; i < roots.count; ++i) {
            const Local p = along(o, d, roots.t[i]);
            const Vector n{static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
            nearest.offer(static_cast<double>(shift + roots.t[i]), normalized(n));
        }
    }

    Ball ball() const override { return {center_, radius_}; }

private:
    Vector center_;
    double radius_;
};

class Tube final : public Shape {
public:
    explicit Tube(const Solid& solid)
        : base_(from(solid.position)),
          ex_(rotated({1, 0, 0}, solid.rotation)),
          ey_(rotated({0, 1, 0}, solid.rotation)),
          ez_(rotated({0, 0, 1}, solid.rotation)),
          radius_(solid.radius),
          height_(solid.height),
          top_radius_(solid.radius * solid.taper),
          slope_((static_cast<long double>(solid.taper) - 1) * solid.radius / solid.height) {}

    void cross(const Ray& ray, Nearest& nearest) const override {
        const Local d = in_own_axes({ray.direction.x, ray.direction.y, ray.direction.z});
        const Local far = in_own_axes(minus(ray.origin, base_));
        const long double shift = -(far.x * d.x + (far.y - height_ / 2) * d.y + far.z * d.z) / inner(d, d);
        const Local o = along(far, d, shift);
        cross_side(o, d, shift, nearest);
        cross_cap(o, d, shift, 0, radius_, -1, nearest);
        cross_cap(o, d, shift, height_, top_radius_, 1, nearest);
    }

    Ball ball() const override {
        const double half = static_cast<double>(height_) / 2;
        const double widest = static_cast<double>(std::max(radius_, top_radius_));
        return {base_ + half * ey_, std::hypot(half, widest)};
    }

private:
    void cross_side(const Local& o, const Local& d, long double shift, Nearest& nearest) const {
        const long double width = radius_ + slope_ * o.y, dw = slope_ * d.y;
        const Roots roots = roots_of(d.x * d.x + d.z * d.z - dw * dw, o.x * d.x + o.z * d.z - width * dw,
                                     o.x * o.x + o.z * o.z - width * width);
        for (int i = 0; i < roots.count; ++i) {
            const Local p = along(o, d, roots.t[i]);
            if (!(p.y >= 0 && p.y <= height_)) continue;
            const Local gradient{p.x, -slope_ * (radius_ + slope_ * p.y), p.z};
            // At the very tip of a cone there is no gradient: take the axis.
            const bool tip = inner(gradient, gradient) == 0;
            nearest.offer(static_cast<double>(shift + roots.t[i]), tip ? ey_ : normalized(in_world(gradient)));
        }
    }

    void cross_cap(const Local& o, const Local& d, long double shift, long double y, long double radius, int side,
                   Nearest& nearest) const {
        if (d.y == 0) return;
        const long double t = (y - o.y) / d.y;
        const Local p = along(o, d, t);
        if (p.x * p.x + p.z * p.z <= radius * radius) nearest.offer(static_cast<double>(shift + t), side * ey_);
    }

    Local in_own_axes(const Local& v) const {
        return {inner(v, {ex_.x, ex_.y, ex_.z}), inner(v, {ey_.x, ey_.y, ey_.z}), inner(v, {ez_.x, ez_.y, ez_.z})};
    }

    Vector in_world(const Local& v) const {
        return static_cast<double>(v.x) * ex_ + static_cast<double>(v.y) * ey_ + static_cast<double>(v.z) * ez_;
    }

    Vector base_, ex_, ey_, ez_;
    long double radius_, height_, top_radius_, slope_;
};

}  // namespace

Roots roots_of(long double a, long double b, long double c) {
    const long double discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return {};
    const long double q = -(b + std::copysign(std::sqrt(discriminant), b));
    Roots roots;
    if (a != 0) roots.t[roots.count++] = q / a;
    if (q != 0) roots.t[roots.count++] = c / q;
    return roots;
}

std::unique_ptr<Shape> make_sphere(const Solid& solid) { return std::make_unique<Sphere>(solid); }

std::unique_ptr<Shape> make_tube(const Solid& solid) { return std::make_unique<Tube>(solid); }

}  // namespace zerkalo::reference
