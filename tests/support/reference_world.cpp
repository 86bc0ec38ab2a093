// Nearest hit and visibility by brute force.
#include "tests/support/reference_world.hpp"

#include <algorithm>

namespace zerkalo::reference {
namespace {

// Rounding of a hit point is a few 1e-16 of the coordinates that went into it; rays that leave a surface at an angle
// of more than 1e-5 clear it well within 1e-10 of them. A long way travelled blurs by rounding only.
constexpr double kGuardOfSize = 1e-10;
constexpr double kGuardOfDistance = 1e-13;

/// False only when the whole line misses the ball by a clear margin.
bool may_meet(const Ray& ray, const Ball& ball) {
    constexpr double kMargin = 1 + 1e-6;
    const Vector to_center = ball.center - ray.origin;
    const Vector off = to_center - dot(to_center, ray.direction) * ray.direction;
    return length(off) <= kMargin * ball.radius;
}

double extent(const Ball& ball) { return length(ball.center) + ball.radius; }

}  // namespace

World::World(const Scene& scene) {
    for (int i = 0; i < scene.solid_count; ++i) {
        std::unique_ptr<Shape> shape = make_shape(scene, scene.solids[i]);
        const Ball ball = shape->ball();
        solids_.push_back({std::move(shape), ball});
    }
    for (int i = 0; i < scene.mirror_count; ++i) mirrors_.emplace_back(scene.mirrors[i]);
}

Hit World::first_hit(const Ray& ray, double t_min) const {
    Hit hit;
    Nearest nearest{t_min};
    double size = 0;
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        if (!may_meet(ray, solids_[i].ball)) continue;
        solids_[i].shape->cross(ray, nearest);
        if (nearest.t < hit.t) {
            hit.t = nearest.t;
            hit.kind = HitKind::solid;
            hit.index = static_cast<int>(i);
            size = extent(solids_[i].ball);
        }
    }
    for (std::size_t i = 0; i < mirrors_.size(); ++i) {
        mirrors_[i].cross(ray, nearest);
        if (nearest.t < hit.t) {
            hit.t = nearest.t;
            hit.kind = HitKind::mirror;
            hit.index = static_cast<int>(i);
            size = extent(mirrors_[i].ball());
        }
    }
    if (hit.kind == HitKind::none) return hit;
    hit.point = ray.origin + hit.t * ray.direction;
    hit.normal = nearest.normal;
    hit.front = dot(ray.direction, hit.normal) < 0;
    hit.guard = kGuardOfSize * size + kGuardOfDistance * hit.t;
    return hit;
}

bool World::visible(const Hit& from, const Vector& light) const {
    const Vector way = light - from.point;
    const double distance = length(way);
    return !(first_hit({from.point, normalized(way)}, from.guard).t < distance - from.guard);
}

}  // namespace zerkalo::reference
