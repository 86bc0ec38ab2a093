// Where the camera and the lights stand: inside of a solid, close to one, or on a surface.
#include "core/render/derive.hpp"

namespace zerkalo {
namespace {

// A camera or light nearer to a solid than this share of its size counts as inside.
constexpr double kNearShare = 0x1p-10;
// A camera nearer to a surface than this share of all lengths is on it: float coordinates, and distances computed from
// them, differ by up to some eight roundings of 2^-24.
constexpr double kTouchShare = 0x1p-21;

Clearance clearance_of_tube(const TubeData& tube, const Point& p) {
    const Point f = p - tube.centre;
    const double y = dot(tube.axis_y, f);
    const Point across = f - tube.axis_y * y;
    const double radius = length(across);
    const double caps = magnitude(y) - tube.half_height;
    const double side = (radius - (tube.mid_radius + double(tube.slope) * y)) * tube.normal_scale;
    const Point up{tube.axis_y.x, tube.axis_y.y, tube.axis_y.z};
    if (caps > side || radius == 0) return {caps > side ? caps : side, up * (y < 0 ? -1.0 : 1.0)};
    return {side, (across * (1 / radius) - up * double(tube.slope)) * double(tube.normal_scale)};
}

Clearance clearance_of_half_spaces(const Slab* slabs, const HalfSpacesData& body, const Point& p) {
    Clearance farthest{-kInfinity, {0, 0, 0}};
    for (std::int32_t s = body.first_slab; s < body.first_slab + body.slab_count; ++s) {
        const Point n{slabs[s].n.x, slabs[s].n.y, slabs[s].n.z};
        const double along = dot(n, p - body.centre);
        if (along - slabs[s].hi > farthest.distance) farthest = {along - slabs[s].hi, n};
        if (slabs[s].lo - along > farthest.distance) farthest = {slabs[s].lo - along, n * -1.0};
    }
    return farthest;
}

/// How far a mirror's surface, continued beyond its boundary, is from p; to first order near it.
double distance_from(const Mirror& mirror, const Point& p) {
    const Point f = p - mirror.position;
    return magnitude(dot(unit(mirror.normal), f) - dot(f, f) / (2 * mirror.curvature_radius));
}

}  // namespace

Clearance clearance_of(const Plan& plan, const SolidPlan& solid, const Vec3<double>& world) {
    const Point p = world - plan.origin;
    if (solid.shape == ShapeKind::tube) return clearance_of_tube(solid.tube, p);
    if (solid.shape == ShapeKind::half_spaces) return clearance_of_half_spaces(plan.slabs, solid.half_spaces, p);
    const Point f = p - solid.sphere.centre;
    const double distance = length(f);
    return {distance - square_root(double(solid.sphere.radius2)), f * (distance > 0 ? 1 / distance : 0)};
}

bool near_or_inside(const Plan& plan, const Vec3<double>& world) {
    for (std::int32_t k = 0; k < plan.solid_count; ++k) {
        const SolidPlan& solid = plan.solids[k];
        if (solid.shape == ShapeKind::mesh) continue;
        if (clearance_of(plan, solid, world).distance <= kNearShare * solid.bound_radius) return true;
    }
    return false;
}

void derive_standing(const Scene& scene, Plan& plan) {
    const Point& eye = scene.camera.position;
    const auto from_origin = [&plan](const Point& p) { return length(p - plan.origin); };
    plan.camera.stands_on = -1, plan.camera.out_of_it = {0, 0, 0};
    for (std::int32_t m = 0; m < scene.mirror_count; ++m) {
        const Ball ball = ball_of(scene.mirrors[m]);
        const double touch = kTouchShare * (ball.radius + from_origin(eye) + from_origin(ball.centre));
        if (length(eye - ball.centre) > ball.radius + touch) continue;
        if (distance_from(scene.mirrors[m], eye) <= touch) plan.camera.stands_on = float(kMaxSolids + m);
    }
    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        const SolidPlan& solid = plan.solids[k];
        if (solid.shape == ShapeKind::mesh) continue;
        const double touch = kTouchShare * (solid.bound_radius + from_origin(eye) + length(solid.bound_centre));
        const Clearance clearance = clearance_of(plan, solid, eye);
        if (magnitude(clearance.distance) > touch) continue;
        plan.camera.stands_on = float(k), plan.camera.out_of_it = rounded(clearance.normal);
    }
}

void derive_close_spheres(const Scene& scene, Plan& plan) {
    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        if (plan.solids[k].shape != ShapeKind::sphere) continue;
        const Solid& ball = scene.solids[k];
        const Point f = scene.camera.position - ball.position;
        const double distance = length(f);
        plan.camera_origin.solids[k] = {rounded(f), float((distance - ball.radius) * (distance + ball.radius))};
    }
}

}  // namespace zerkalo
