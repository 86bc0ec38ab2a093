#include "core/scene/validate.hpp"

#include "core/geometry/frame.hpp"
#include "core/scene/outline.hpp"

namespace zerkalo {
namespace {

bool finite(double x) { return x - x == 0; }
bool within(double x, double low, double high) { return x >= low && x <= high; }

/// Collects the first complaint about one part of the scene.
struct Checker {
    Part part;
    std::int32_t index;
    Status status = kOk;

    void require(bool good, const char* field, const char* reason) {
        if (status.ok() && !good) status = Status{field, reason, part, index};
    }
    void coordinate(const Vec3<double>& p, const char* field) {
        require(within(p.x, -kMaxCoordinate, kMaxCoordinate) && within(p.y, -kMaxCoordinate, kMaxCoordinate) &&
                    within(p.z, -kMaxCoordinate, kMaxCoordinate),
                field, "must be finite and at most 1e15 in size");
    }
    void direction(const Vec3<double>& v, const char* field) {
        require(finite(v.x) && finite(v.y) && finite(v.z), field, "must be finite");
        require(v.x != 0 || v.y != 0 || v.z != 0, field, "must not be the zero vector");
    }
    void rotation(const Vec3<double>& angles, const char* field) {
        constexpr double kRoom = 1 + 0x1p-50;  // for the rounding of degrees to radians
        constexpr double kLargest = kMaxAngleDegrees / 180 * kPi * kRoom;
        require(within(angles.x, -kLargest, kLargest) && within(angles.y, -kLargest, kLargest) &&
                    within(angles.z, -kLargest, kLargest),
                field, "must be finite and at most 1e7 degrees in size");
    }
    template <class Choice>
    void choice(Choice x, Choice last, const char* field) {
        require(x <= last, field, "must be one of its enumerators");
    }
    void size(double x, const char* field) {
        require(x > 0 && x <= kMaxCoordinate, field, "must be greater than 0 and at most 1e15");
    }
    void share(double x, const char* field) { require(within(x, 0, 1), field, "must lie in 0..1"); }
    void share(const Rgb<double>& c, const char* field) {
        require(within(c.r, 0, 1) && within(c.g, 0, 1) && within(c.b, 0, 1), field, "must have components in 0..1");
    }
    void brightness(double x, const char* field) { require(x >= 0 && finite(x), field, "must be finite and >= 0"); }
    void brightness(const Rgb<double>& c, const char* field) {
        require(c.r >= 0 && c.g >= 0 && c.b >= 0 && finite(c.r) && finite(c.g) && finite(c.b), field,
                "must have finite components >= 0");
    }
};

Status check_camera(const Camera& camera) {
    Checker check{Part::camera, 0};
    check.coordinate(camera.position, "position");
    check.direction(camera.view, "view");
    check.direction(camera.up, "up");
    check.choice(camera.fov_axis, FovAxis::vertical, "fov_axis");
    check.require(camera.fov > 0 && camera.fov < kPi,
                  camera.fov_axis == FovAxis::horizontal ? "horizontal_fov_deg" : "vertical_fov_deg",
                  "must be greater than 0 and less than 180 degrees");
    return check.status;
}

Status check_light(const Light& light, std::int32_t index) {
    Checker check{Part::light, index};
    check.coordinate(light.position, "position");
    check.brightness(light.color, "color");
    check.brightness(light.intensity, "intensity");
    check.choice(light.falloff, Falloff::inverse_square, "falloff");
    return check.status;
}

void check_material(Checker& check, const Material& m) {
    check.share(m.color, "color");
    check.share(m.ambient, "ambient");
    check.share(m.diffuse, "diffuse");
    check.share(m.specular, "specular");
    check.brightness(m.shininess, "shininess");
    check.share(m.reflection, "reflection");
    check.share(m.transmission, "transmission");
    check.require(m.reflection + m.transmission <= 1, "transmission", "and reflection together must not exceed 1");
    check.require(m.refractive_index > 0 && finite(m.refractive_index), "refractive_index",
                  "must be finite and greater than 0");
    check.require(!m.fresnel || m.transmission > 0, "fresnel", "needs a transmission greater than 0");
}

bool same(const Vec3<double>& a, const Vec3<double>& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

const Vec3<double>& corner(const Triangle& t, int k) { return k == 0 ? t.a : k == 1 ? t.b : t.c; }

/// Every directed edge must occur once, and once the other way round.
bool is_closed(const Triangle* triangles, std::int32_t count) {
    for (std::int32_t i = 0; i < 3 * count; ++i) {
        const auto& from = corner(triangles[i / 3], i % 3);
        const auto& to = corner(triangles[i / 3], (i + 1) % 3);
        int along = 0, against = 0;
        for (std::int32_t j = 0; j < 3 * count; ++j) {
            const auto& a = corner(triangles[j / 3], j % 3);
            const auto& b = corner(triangles[j / 3], (j + 1) % 3);
            along += same(from, a) && same(to, b);
            against += same(from, b) && same(to, a);
        }
        if (along != 1 || against != 1) return false;
    }
    return true;
}

double signed_volume(const Triangle* triangles, std::int32_t count) {
    double sum = 0;
    for (std::int32_t k = 0; k < count; ++k) {
        const Triangle& t = triangles[k];
        const Vec3<double> o = triangles[0].a;
        sum += dot(t.a - o, cross(t.b - o, t.c - o));
    }
    return sum / 6;
}

void check_mesh(Checker& check, const Scene& scene, const Solid& solid) {
    check.size(solid.scale, "scale");
    check.require(solid.triangle_count >= 4, "triangles", "must be at least 4: a closed surface");
    const std::int64_t end = std::int64_t{solid.first_triangle} + solid.triangle_count;
    check.require(solid.first_triangle >= 0 && end <= scene.triangle_count, "triangles",
                  "must lie inside the scene's triangles");
    if (!check.status.ok()) return;
    const Triangle* first = scene.triangles + solid.first_triangle;
    for (std::int32_t k = 0; k < solid.triangle_count; ++k) {
        check.coordinate(first[k].a, "vertices");
        check.coordinate(first[k].b, "vertices");
        check.coordinate(first[k].c, "vertices");
        const Vec3<double> area = cross(first[k].b - first[k].a, first[k].c - first[k].a);
        check.require(length(area) > 0, "triangles", "must not contain a triangle without area");
    }
    if (!check.status.ok()) return;
    check.require(is_closed(first, solid.triangle_count), "triangles",
                  "must form a closed surface: every edge shared by exactly two, in opposite senses");
    check.require(signed_volume(first, solid.triangle_count) > 0, "triangles",
                  "must turn counter-clockwise seen from outside");
}

Status check_solid(const Scene& scene, const Solid& solid, std::int32_t index) {
    Checker check{Part::solid, index};
    check.choice(solid.kind, SolidKind::mesh, "kind");
    check.coordinate(solid.position, "position");
    check.rotation(solid.rotation, "rotate_deg");
    const bool polyhedron = solid.kind == SolidKind::pyramid || solid.kind == SolidKind::prism;
    const bool tube = solid.kind == SolidKind::cylinder || solid.kind == SolidKind::cone;
    if (polyhedron) check.require(solid.sides >= kMinSides && solid.sides <= kMaxSides, "sides", "must lie in 3..64");
    if (solid.kind != SolidKind::mesh) check.size(solid.radius, "radius");
    if (polyhedron || tube) check.size(solid.height, "height");
    if (tube) check.require(within(solid.taper, 0, kMaxCoordinate), "taper", "must be >= 0 and at most 1e15");
    if (solid.kind == SolidKind::mesh) check_mesh(check, scene, solid);
    check_material(check, solid.material);
    return check.status;
}

/// Convex in either sense, with area: all turns to the same side, once around.
bool is_convex_polygon(const Boundary& b) {
    double turning = 0;
    for (std::int32_t k = 0; k < b.corner_count; ++k) {
        const auto& p = b.corners[k];
        const auto& q = b.corners[(k + 1) % b.corner_count];
        for (std::int32_t j = 0; j < b.corner_count; ++j) {
            const auto& r = b.corners[j];
            const double side = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
            if (j == k || j == (k + 1) % b.corner_count) continue;
            if (side == 0 || side * turning < 0) return false;
            turning = side;
        }
    }
    return true;
}

void check_boundary(Checker& check, const Boundary& b) {
    check.choice(b.shape, BoundaryShape::polygon, "boundary.shape");
    if (b.shape == BoundaryShape::rectangle || b.shape == BoundaryShape::ellipse) {
        check.size(b.width, "boundary.width");
        check.size(b.height, "boundary.height");
    }
    if (b.shape == BoundaryShape::disc) check.size(b.radius, "boundary.radius");
    if (b.shape != BoundaryShape::polygon) return;
    check.require(b.corner_count >= 3 && b.corner_count <= kMaxCorners, "boundary.points", "must be 3 to 16 corners");
    if (!check.status.ok()) return;
    for (std::int32_t k = 0; k < b.corner_count; ++k) {
        check.coordinate({b.corners[k].x, b.corners[k].y, 0}, "boundary.points");
    }
    if (check.status.ok()) {
        check.require(is_convex_polygon(b), "boundary.points", "must form a convex polygon with no three in a line");
    }
}

Status check_mirror(const Mirror& mirror, std::int32_t index) {
    Checker check{Part::mirror, index};
    check.coordinate(mirror.position, "position");
    check.direction(mirror.normal, "normal");
    check.direction(mirror.up, "up");
    check_boundary(check, mirror.boundary);
    const double radius = magnitude(mirror.curvature_radius);
    check.require(radius == radius, "curvature_radius", "must be a number (inf for a plane mirror)");
    check.require(radius != 0, "curvature_radius", "must not be 0");
    if (check.status.ok()) {
        check.require(farthest_point(mirror.boundary) < radius, "curvature_radius",
                      "must be greater in size than the distance from the vertex to the boundary's farthest point");
    }
    check.choice(mirror.lobe, Lobe::ggx, "lobe");
    check.require(mirror.lobe_exponent >= 0, "lobe_exponent", "must be >= 0 (inf for a polished mirror)");
    check.share(mirror.color, "color");
    check.share(mirror.ambient, "ambient");
    check.share(mirror.diffuse, "diffuse");
    check.share(mirror.specular, "specular");
    check.share(mirror.reflection, "reflection");
    check.require(mirror.shininess == kShininessOfLobe || (mirror.shininess >= 0 && finite(mirror.shininess)),
                  "shininess", "must be finite and >= 0");
    return check.status;
}

Status check_counts(const Scene& scene) {
    Checker check{Part::scene, 0};
    check.require(scene.light_count >= 0 && scene.light_count <= kMaxLights, "light", "must be at most 8");
    check.require(scene.solid_count >= 0 && scene.solid_count <= kMaxSolids, "solid", "must be at most 32");
    check.require(scene.mirror_count >= 0 && scene.mirror_count <= kMaxMirrors, "mirror", "must be at most 8");
    check.require(scene.triangle_count >= 0 && scene.triangle_count <= kMaxTriangles, "triangles",
                  "must be at most 512 in all meshes together");
    check.brightness(scene.ambient, "ambient");
    check.brightness(scene.background, "background");
    return check.status;
}

}  // namespace

Status validate(const Scene& scene) {
    if (const Status status = check_counts(scene); !status.ok()) return status;
    Checker image{Part::image, 0};
    image.require(scene.image.width >= 1 && scene.image.width <= 65536, "width", "must lie in 1..65536");
    image.require(scene.image.height >= 1 && scene.image.height <= 65536, "height", "must lie in 1..65536");
    image.require(std::int64_t{scene.image.width} * scene.image.height <= std::int64_t{1} << 28, "height",
                  "times width must be at most 2^28 pixels");
    if (!image.status.ok()) return image.status;
    if (const Status status = check_camera(scene.camera); !status.ok()) return status;
    for (std::int32_t k = 0; k < scene.light_count; ++k) {
        if (const Status status = check_light(scene.lights[k], k); !status.ok()) return status;
    }
    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        if (const Status status = check_solid(scene, scene.solids[k], k); !status.ok()) return status;
    }
    for (std::int32_t k = 0; k < scene.mirror_count; ++k) {
        if (const Status status = check_mirror(scene.mirrors[k], k); !status.ok()) return status;
    }
    return kOk;
}

}  // namespace zerkalo
