// Flat-faced solids as lists of convex polygons: meet the face's plane, then ask every edge.
#include "tests/support/reference_shapes.hpp"

#include "tests/support/reference_quadric.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

namespace zerkalo::reference {
namespace {

using Corners = std::vector<Vector>;

struct Face {
    Corners corners;
    Vector normal;
};

/// Twice the vector area of a flat polygon; its direction is the normal of a counter-clockwise outline.
Vector vector_area(const Corners& corners) {
    Vector sum;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum = sum + cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum;
}

class Polyhedron final : public Shape {
public:
    explicit Polyhedron(const std::vector<Corners>& outlines) {
        for (const Corners& corners : outlines) {
            const Vector area = vector_area(corners);
            if (length(area) > 0) faces_.push_back({corners, normalized(area)});
        }
        enclose(outlines);
    }

    void cross(const Ray& ray, Nearest& nearest) const override {
        for (const Face& face : faces_) {
            const double approach = dot(ray.direction, face.normal);
            if (approach == 0) continue;
            const double t = dot(face.corners[0] - ray.origin, face.normal) / approach;
            if (inside(face, ray.origin + t * ray.direction)) nearest.offer(t, face.normal);
        }
    }

    Ball ball() const override { return ball_; }

private:
    bool inside(const Face& face, const Vector& p) const {
        // Neighbours overlap by this share of the solid's size, so that no ray slips through a shared edge.
        constexpr double kSeam = 1e-12;
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            const Vector& a = face.corners[i];
            const Vector edge = face.corners[(i + 1) % face.corners.size()] - a;
            const double inward = dot(reference::cross(edge, p - a), face.normal);
            if (!(inward >= -kSeam * ball_.radius * length(edge))) return false;
        }
        return true;
    }

    void enclose(const std::vector<Corners>& outlines) {
        Vector low = outlines[0][0], high = low;
        for (const Corners& corners : outlines)
            for (const Vector& p : corners) {
                low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
            }
        ball_ = {0.5 * (low + high), 0.5 * length(high - low)};
    }

    std::vector<Face> faces_;
    Ball ball_;
};

Vector placed(const Solid& solid, const Vector& local) { return from(solid.position) + rotated(local, solid.rotation); }

/// Corner k at (r cos a, y, r sin a), a = 2 pi k / sides, placed in the world.
Corners ring(const Solid& solid, double y) {
    Corners corners;
    for (int k = 0; k < solid.sides; ++k) {
        const double a = 2 * std::numbers::pi * k / solid.sides;
        corners.push_back(placed(solid, {solid.radius * std::cos(a), y, solid.radius * std::sin(a)}));
    }
    return corners;
}

/// Increasing angle runs from +x to +z, which is counter-clockwise seen from below: outward for a base.
std::vector<Corners> prism_faces(const Solid& solid) {
    const Corners base = ring(solid, 0), top = ring(solid, solid.height);
    std::vector<Corners> faces{base, Corners(top.rbegin(), top.rend())};
    for (std::size_t k = 0; k < base.size(); ++k) {
        const std::size_t next = (k + 1) % base.size();
        faces.push_back({base[k], top[k], top[next], base[next]});
    }
    return faces;
}

std::vector<Corners> pyramid_faces(const Solid& solid) {
    const Corners base = ring(solid, 0);
    const Vector apex = placed(solid, {0, solid.height, 0});
    std::vector<Corners> faces{base};
    for (std::size_t k = 0; k < base.size(); ++k) faces.push_back({base[k], apex, base[(k + 1) % base.size()]});
    return faces;
}

std::vector<Corners> mesh_faces(const Scene& scene, const Solid& solid) {
    std::vector<Corners> faces;
    for (int i = 0; i < solid.triangle_count; ++i) {
        const Triangle& triangle = scene.triangles[solid.first_triangle + i];
        Corners corners;
        for (const Vec3<double>* p : {&triangle.a, &triangle.b, &triangle.c})
            corners.push_back(placed(solid, solid.scale * from(*p)));
        faces.push_back(corners);
    }
    return faces;
}

}  // namespace

Vector rotated(const Vector& v, const Vec3<double>& angles) {
    const double cx = std::cos(angles.x), sx = std::sin(angles.x);
    const double cy = std::cos(angles.y), sy = std::sin(angles.y);
    const double cz = std::cos(angles.z), sz = std::sin(angles.z);
    const Vector a{v.x, cx * v.y - sx * v.z, sx * v.y + cx * v.z};
    const Vector b{cy * a.x + sy * a.z, a.y, -sy * a.x + cy * a.z};
    return {cz * b.x - sz * b.y, sz * b.x + cz * b.y, b.z};
}

std::unique_ptr<Shape> make_shape(const Scene& scene, const Solid& solid) {
    switch (solid.kind) {
        case SolidKind::sphere: return make_sphere(solid);
        case SolidKind::cylinder:
        case SolidKind::cone: return make_tube(solid);
        case SolidKind::prism: return std::make_unique<Polyhedron>(prism_faces(solid));
        case SolidKind::pyramid: return std::make_unique<Polyhedron>(pyramid_faces(solid));
        case SolidKind::mesh: break;
    }
    return std::make_unique<Polyhedron>(mesh_faces(scene, solid));
}

}  // namespace zerkalo::reference
