#include "core/render/surroundings.hpp"

namespace zerkalo {
namespace {

// A camera or light farther than this many scene radii would waste the digits of a float origin.
constexpr double kFarRadii = 64;

Ball ball_around(const Ball* balls, std::int32_t count) {
    if (count == 0) return {{0, 0, 0}, 0};
    Ball all = balls[0];
    for (std::int32_t k = 1; k < count; ++k) {
        const Point way = balls[k].centre - all.centre;
        const double distance = length(way);
        if (distance + balls[k].radius <= all.radius) continue;
        if (distance + all.radius <= balls[k].radius) {
            all = balls[k];
            continue;
        }
        const double radius = (distance + all.radius + balls[k].radius) / 2;
        all.centre = all.centre + way * ((radius - all.radius) / distance);
        all.radius = radius;
    }
    return all;
}

/// The nearest whole number; halves go to the even one, so that it changes sign with x.
double nearest_whole(double x) {
    constexpr double kShift = 0x1.8p52;
    return magnitude(x) < 0x1p51 ? (x + kShift) - kShift : x;
}

}  // namespace

void derive_surroundings(const Scene& scene, Surroundings& around) {
    Ball balls[kMaxSolids + kMaxMirrors];
    std::int32_t count = 0;
    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        around.solids[k] = ball_of(scene, scene.solids[k]);
        balls[count++] = around.solids[k];
    }
    for (std::int32_t m = 0; m < scene.mirror_count; ++m) {
        around.mirrors[m] = ball_of(scene.mirrors[m]);
        balls[count++] = around.mirrors[m];
    }
    around.all = ball_around(balls, count);
}

bool is_far(const Point& p, const Surroundings& around) {
    return around.all.radius > 0 && length(p - around.all.centre) > kFarRadii * around.all.radius;
}

Point origin_for(const Ball& all) {
    if (!(all.radius > 0)) return {0, 0, 0};
    double step = 1;
    while (step < kFarRadii * all.radius) step *= 2;
    while (step / 2 >= kFarRadii * all.radius) step /= 2;
    const auto near = [step](double x) { return nearest_whole(x / step) * step; };
    return {near(all.centre.x), near(all.centre.y), near(all.centre.z)};
}

double pull_of(const Viewpoint& eye, const Surroundings& around) {
    if (!is_far(eye.position, around)) return 0;
    const double pull = dot(around.all.centre - eye.position, eye.view);
    return pull > 0 ? pull : 0;
}

}  // namespace zerkalo
