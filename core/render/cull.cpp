#include "core/render/cull.hpp"

namespace zerkalo {
namespace {

constexpr double kRoomPixels = 1;          // beyond the half pixel that an antialiased pixel reaches
constexpr double kRoomRelative = 0x1p-20;  // of a size or distance: far above double's rounding, below float's effect

/// Slopes from low to high along one image axis -> pixel interval of an image with n pixels and the given half width.
void interval(double low, double high, double tan_half, std::int32_t n, std::int32_t& first, std::int32_t& end) {
    const double scale = n / (2 * tan_half);
    const double a = n / 2.0 + low * scale - kRoomPixels;
    const double b = n / 2.0 + high * scale + kRoomPixels;
    first = a <= 0 ? 0 : a >= n ? n : static_cast<std::int32_t>(a);
    end = b <= 0 ? 0 : b >= n ? n : static_cast<std::int32_t>(b) + 1;
    if (end > n) end = n;
}

/// x to the right, y upwards, both as slopes against the viewing direction.
PixelBounds bounds_of_slopes(const Viewpoint& eye, double left, double right, double bottom, double top) {
    PixelBounds out;
    interval(left, right, eye.tan_half_width, eye.width, out.left, out.right);
    interval(-top, -bottom, eye.tan_half_height, eye.height, out.top, out.bottom);
    return out;
}

/// Slopes of the two tangents from the origin to a circle at (across, ahead) with ahead > r.
void tangent_slopes(double across, double ahead, double r, double& low, double& high) {
    const double middle = across * ahead;
    const double swing = r * square_root(across * across + (ahead - r) * (ahead + r));
    const double scale = 1 / ((ahead - r) * (ahead + r));
    low = (middle - swing) * scale;
    high = (middle + swing) * scale;
}

Point mirrored(const Point& p, const Mirror& mirror, const Point& n) {
    return p - n * (2 * dot(n, p - mirror.position));
}

/// Pixels on which the shadow of a hull on a plane mirror can appear; whole picture where it has no bound.
PixelBounds shadow_bounds(const Viewpoint& eye, const Mirror& mirror, const Point& light, Hull& hull) {
    const Point n = unit(mirror.normal);
    const double light_height = dot(n, light - mirror.position);
    for (std::int32_t k = 0; k < hull.count; ++k) {
        const double height = dot(n, hull.points[k] - mirror.position);
        const double fall = light_height - height;
        // Only a corner between light and plane throws its shadow to a bounded place.
        if (!(magnitude(fall) > kRoomRelative * magnitude(light_height)) || fall * light_height <= 0) {
            return whole_picture(eye);
        }
        hull.points[k] = light + (hull.points[k] - light) * (light_height / fall);
    }
    return bounds_of_hull(eye, hull);
}

/// Does the hull of a point and a ball come near another ball? Signed distance to the tangent cone, and depth along it.
bool can_block(const Point& light, const Ball& receiver, const Ball& blocker) {
    const Point axis = receiver.centre - light, f = blocker.centre - light;
    const double depth = length(axis), radius = blocker.radius * (1 + kRoomRelative) + kRoomRelative * depth;
    if (depth <= receiver.radius * (1 + kRoomRelative) || length(f) <= radius) return true;
    const Point m = axis * (1 / depth);
    const double sine = receiver.radius / depth;
    const double along = dot(f, m), across = length(cross(f, m));
    if (along < -radius || along > depth + receiver.radius + radius) return false;
    return across * square_root(1 - sine * sine) - along * sine <= radius;
}

/// A plane mirror cannot stand between two things on one side of it.
bool plane_separates(const Mirror& mirror, const Point& light, const Ball& receiver) {
    const Point n = unit(mirror.normal);
    const double from = dot(n, light - mirror.position), to = dot(n, receiver.centre - mirror.position);
    const double room = receiver.radius * (1 + kRoomRelative) + kRoomRelative * magnitude(from);
    return !(from > 0 && to > room) && !(from < 0 && to < -room);
}

std::uint64_t blockers_between(const Scene& scene, const Surroundings& around, const Point& light,
                               const Ball& receiver) {
    std::uint64_t mask = 0;
    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        if (can_block(light, receiver, around.solids[k])) mask |= std::uint64_t{1} << k;
    }
    for (std::int32_t m = 0; m < scene.mirror_count; ++m) {
        const bool plane = !(magnitude(scene.mirrors[m].curvature_radius) < kInfinity);
        if (plane && !plane_separates(scene.mirrors[m], light, receiver)) continue;
        if (can_block(light, receiver, around.mirrors[m])) mask |= std::uint64_t{1} << (kMaxSolids + m);
    }
    return mask;
}

/// Is there something to cull behind the only mirror?
bool one_plane_mirror(const Scene& scene, const PlanHead& plan) {
    return scene.mirror_count == 1 && !(magnitude(scene.mirrors[0].curvature_radius) < kInfinity) && !plan.exact_plan;
}

SharedBound shared_bound(const Point& light, const SolidPlan& solid, const Constants<FloatFormats>& to) {
    const Point c = Point{solid.bound_centre.x, solid.bound_centre.y, solid.bound_centre.z} - to.seen(light);
    const double radius = solid.bound_radius;
    // Room for the rounding of a unit direction and of the products, a few 2^-24 each.
    constexpr double kRoom = 0x1p-20;
    const double beyond = dot(c, c) * (1 - kRoom) - radius * radius * (1 + kRoom);
    return {rounded(c), float(beyond)};
}

}  // namespace

PixelBounds whole_picture(const Viewpoint& eye) { return {0, 0, eye.width, eye.height}; }

PixelBounds bounds_of_hull(const Viewpoint& eye, const Hull& hull) {
    double left = kInfinity, right = -kInfinity, bottom = kInfinity, top = -kInfinity;
    for (std::int32_t k = 0; k < hull.count; ++k) {
        const Point f = hull.points[k] - eye.position;
        const double ahead = dot(eye.view, f);
        if (!(ahead > kRoomRelative * length(f))) return whole_picture(eye);
        const double x = dot(eye.right, f) / ahead, y = dot(eye.up, f) / ahead;
        if (x < left) left = x;
        if (x > right) right = x;
        if (y < bottom) bottom = y;
        if (y > top) top = y;
    }
    return bounds_of_slopes(eye, left, right, bottom, top);
}

PixelBounds bounds_of_ball(const Viewpoint& eye, const Ball& ball) {
    const Point f = ball.centre - eye.position;
    const double ahead = dot(eye.view, f), r = ball.radius * (1 + kRoomRelative);
    if (!(ahead > r * (1 + kRoomRelative))) return whole_picture(eye);
    double left, right, bottom, top;
    tangent_slopes(dot(eye.right, f), ahead, r, left, right);
    tangent_slopes(dot(eye.up, f), ahead, r, bottom, top);
    return bounds_of_slopes(eye, left, right, bottom, top);
}

template <class F>
void derive_bounds(const Scene& scene, const Viewpoint& eye, PlanOf<F>& plan) {
    Hull hull;
    for (std::int32_t m = 0; m < scene.mirror_count; ++m) {
        hull_of(scene.mirrors[m], hull);
        plan.mirror_bounds.set(m, plan.exact_plan ? whole_picture(eye) : bounds_of_hull(eye, hull));
    }
    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        const Solid& solid = scene.solids[k];
        const bool ball = solid.kind == SolidKind::sphere;
        hull_of(scene, solid, hull);
        plan.solid_bounds.set(k, plan.exact_plan ? whole_picture(eye)
                                 : ball          ? bounds_of_ball(eye, ball_of(scene, solid))
                                                 : bounds_of_hull(eye, hull));
    }
}

template <class F>
void derive_shadow_bounds(const Scene& scene, const Viewpoint& eye, PlanOf<F>& plan) {
    Hull hull;
    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        for (std::int32_t j = 0; j < scene.light_count; ++j) {
            plan.shadow_bounds[j].set(k, whole_picture(eye));
            if (!one_plane_mirror(scene, plan)) continue;
            hull_of(scene, scene.solids[k], hull);
            plan.shadow_bounds[j].set(k, shadow_bounds(eye, scene.mirrors[0], scene.lights[j].position, hull));
        }
    }
}

void derive_image_bounds(const Scene& scene, const Viewpoint& eye, Plan& plan) {
    Hull hull;
    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        const Solid& solid = scene.solids[k];
        plan.image_bounds.set(k, whole_picture(eye));
        if (!one_plane_mirror(scene, plan)) continue;
        const Mirror& mirror = scene.mirrors[0];
        hull_of(scene, solid, hull);
        const Point n = unit(mirror.normal);
        for (std::int32_t c = 0; c < hull.count; ++c) hull.points[c] = mirrored(hull.points[c], mirror, n);
        const Ball image{mirrored(solid.position, mirror, n), solid.radius};
        const bool ball = solid.kind == SolidKind::sphere;
        plan.image_bounds.set(k, ball ? bounds_of_ball(eye, image) : bounds_of_hull(eye, hull));
    }
}

void derive_light_bounds(const Scene& scene, const Constants<FloatFormats>& to, Plan& plan) {
    for (std::int32_t j = 0; j < scene.light_count; ++j) {
        for (std::int32_t k = 0; k < scene.solid_count; ++k) {
            plan.lights[j].bounds[k] = shared_bound(scene.lights[j].position, plan.solids[k], to);
        }
    }
}

template <class F>
void derive_blockers(const Scene& scene, const Surroundings& around, PlanOf<F>& plan) {
    const std::uint64_t everything =
        ((std::uint64_t{1} << scene.solid_count) - 1) | ((std::uint64_t{1} << scene.mirror_count) - 1) << kMaxSolids;
    for (std::int32_t j = 0; j < scene.light_count; ++j) {
        const Point& light = scene.lights[j].position;
        for (std::int32_t k = 0; k < scene.solid_count; ++k) {
            std::uint64_t& mask = plan.solids[k].blockers.of_light[j];
            mask = plan.exact_plan ? everything : blockers_between(scene, around, light, around.solids[k]);
            // The outside of a convex solid cannot shade itself.
            const bool convex = scene.solids[k].kind != SolidKind::mesh;
            if (convex) mask &= ~(std::uint64_t{1} << k);
        }
        for (std::int32_t m = 0; m < scene.mirror_count; ++m) {
            std::uint64_t& mask = plan.mirrors[m].blockers.of_light[j];
            mask = plan.exact_plan ? everything : blockers_between(scene, around, light, around.mirrors[m]);
            const bool plane = !(magnitude(scene.mirrors[m].curvature_radius) < kInfinity);
            if (plane) mask &= ~(std::uint64_t{1} << (kMaxSolids + m));
        }
    }
}

template void derive_bounds(const Scene&, const Viewpoint&, Plan&);
template void derive_bounds(const Scene&, const Viewpoint&, DoublePlan&);
template void derive_bounds(const Scene&, const Viewpoint&, FixedPlan&);
template void derive_shadow_bounds(const Scene&, const Viewpoint&, Plan&);
template void derive_shadow_bounds(const Scene&, const Viewpoint&, DoublePlan&);
template void derive_shadow_bounds(const Scene&, const Viewpoint&, FixedPlan&);
template void derive_blockers(const Scene&, const Surroundings&, Plan&);
template void derive_blockers(const Scene&, const Surroundings&, DoublePlan&);
template void derive_blockers(const Scene&, const Surroundings&, FixedPlan&);

}  // namespace zerkalo
