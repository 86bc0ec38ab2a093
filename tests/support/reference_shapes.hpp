// The solids of the reference tracer: each offers every crossing of a ray with its surface, and nothing cleverer.
// Prism, pyramid and mesh are lists of flat faces; sphere and tube solve their quadratic in long double.
#pragma once

#include "core/scene/scene.hpp"
#include "tests/support/reference_vector.hpp"

#include <memory>

namespace zerkalo::reference {

struct Ray {
    Vector origin, direction;  // direction of unit length
};

/// The nearest of all crossings offered so far that are strictly beyond `t_min`.
struct Nearest {
    double t_min = 0;
    double t = kInfinity;
    Vector normal{};  // unit; outward for a solid, to the front for a mirror

    void offer(double distance, const Vector& unit_normal) {
        if (distance > t_min && distance < t) {
            t = distance;
            normal = unit_normal;
        }
    }
};

/// A ball that holds the whole of something.
struct Ball {
    Vector center;
    double radius = 0;
};

class Shape {
public:
    virtual ~Shape() = default;
    virtual void cross(const Ray& ray, Nearest& nearest) const = 0;
    virtual Ball ball() const = 0;
};

/// Rz Ry Rx v, column vectors, angles in radians (seed formulas 2.12-2.14).
Vector rotated(const Vector& v, const Vec3<double>& angles);

/// The shape of one solid of a scene; the scene is only read during the call.
std::unique_ptr<Shape> make_shape(const Scene& scene, const Solid& solid);

}  // namespace zerkalo::reference
