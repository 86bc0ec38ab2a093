// Where the camera and the lights stand: inside of a solid, close to one, or on a surface.
#include "core/render/derive.hpp"

namespace zerkalo {
namespace {

// A camera or light nearer to a solid than this share of its size counts as inside.
constexpr double kNearShare = 0x1p-10;
// A camera nearer to a surface than this share of all lengths is on it: float coordinates, and distances computed from
// them, differ by up to some eight roundings of 2^-24.
constexpr double kTouchShare = 0x1p-21;

template <class F>
Clearance clearance_of_tube(const TubeDataOf<F>& tube, const Constants<F>& to, const Point& p) {
    const Point f = p - to.point_of(tube.centre), axis = to.direction_of(tube.axis_y);
    const double y = dot(axis, f), slope = to.number_of(tube.slope), scale = to.number_of(tube.normal_scale);
    const Point across = f - axis * y;
    const double radius = length(across);
    const double caps = magnitude(y) - to.length_of(tube.half_height);
    const double side = (radius - (to.length_of(tube.mid_radius) + slope * y)) * scale;
    if (caps > side || radius == 0) return {caps > side ? caps : side, axis * (y < 0 ? -1.0 : 1.0)};
    return {side, (across * (1 / radius) - axis * slope) * scale};
}

template <class F>
Clearance clearance_of_half_spaces(const SlabOf<F>* slabs, const HalfSpacesDataOf<F>& body, const Constants<F>& to,
                                   const Point& p) {
    const Point f = p - to.point_of(body.centre);
    Clearance farthest{-kInfinity, {0, 0, 0}};
    for (std::int32_t s = body.first_slab; s < body.first_slab + body.slab_count; ++s) {
        const Point n = to.direction_of(slabs[s].n);
        const double along = dot(n, f), hi = to.length_of(slabs[s].hi), lo = to.length_of(slabs[s].lo);
        if (along - hi > farthest.distance) farthest = {along - hi, n};
        if (lo - along > farthest.distance) farthest = {lo - along, n * -1.0};
    }
    return farthest;
}

/// How far a mirror's surface, continued beyond its boundary, is from p; to first order near it.
double distance_from(const Mirror& mirror, const Point& p) {
    const Point f = p - mirror.position;
    return magnitude(dot(unit(mirror.normal), f) - dot(f, f) / (2 * mirror.curvature_radius));
}

}  // namespace

template <class F>
Clearance clearance_of(const PlanOf<F>& plan, const SolidPlanOf<F>& solid, const Constants<F>& to, const Point& p) {
    if (solid.shape == ShapeKind::tube) return clearance_of_tube(solid.tube, to, p);
    if (solid.shape == ShapeKind::half_spaces) {
        return clearance_of_half_spaces(plan.slabs, solid.half_spaces, to, p);
    }
    const Point f = p - to.point_of(solid.sphere.centre);
    const double distance = length(f), radius = to.unscaled(square_root(to.number_of(solid.sphere.radius2)));
    return {distance - radius, f * (distance > 0 ? 1 / distance : 0)};
}

template <class F>
bool near_or_inside(const PlanOf<F>& plan, const Constants<F>& to, const Point& p) {
    for (std::int32_t k = 0; k < plan.solid_count; ++k) {
        const SolidPlanOf<F>& solid = plan.solids[k];
        if (solid.shape == ShapeKind::mesh) continue;
        if (clearance_of(plan, solid, to, p).distance <= kNearShare * to.length_of(solid.bound_radius)) return true;
    }
    return false;
}

template <class F>
void derive_standing(const Scene& scene, const Constants<F>& to, PlanOf<F>& plan) {
    const Point& eye = scene.camera.position;
    const auto from_origin = [&to](const Point& p) { return length(to.seen(p)); };
    plan.camera.stands_on = -1, plan.camera.out_of_it = to.direction({0, 0, 0});
    for (std::int32_t m = 0; m < scene.mirror_count; ++m) {
        const Ball ball = ball_of(scene.mirrors[m]);
        const double touch = kTouchShare * (ball.radius + from_origin(eye) + from_origin(ball.centre));
        if (length(eye - ball.centre) > ball.radius + touch) continue;
        if (distance_from(scene.mirrors[m], eye) <= touch) plan.camera.stands_on = kMaxSolids + m;
    }
    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        const SolidPlanOf<F>& solid = plan.solids[k];
        if (solid.shape == ShapeKind::mesh) continue;
        const double size = to.length_of(solid.bound_radius);
        const double touch = kTouchShare * (size + from_origin(eye) + from_origin(scene.solids[k].position));
        const Clearance clearance = clearance_of(plan, solid, to, eye);
        if (magnitude(clearance.distance) > touch) continue;
        plan.camera.stands_on = k, plan.camera.out_of_it = to.direction(clearance.normal);
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

template bool near_or_inside(const Plan&, const Constants<FloatFormats>&, const Point&);
template bool near_or_inside(const DoublePlan&, const Constants<DoubleFormats>&, const Point&);
template bool near_or_inside(const FixedPlan&, const Constants<FixedFormats>&, const Point&);
template void derive_standing(const Scene&, const Constants<FloatFormats>&, Plan&);
template void derive_standing(const Scene&, const Constants<DoubleFormats>&, DoublePlan&);
template void derive_standing(const Scene&, const Constants<FixedFormats>&, FixedPlan&);

}  // namespace zerkalo
