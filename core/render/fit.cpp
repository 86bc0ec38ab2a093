#include "core/render/fit.hpp"

namespace zerkalo {
namespace {

// The box, and the longest way across the scene: below the 16 where lengths end, with room for rounding.
constexpr double kBox = 8, kLongestWay = 15;
// A scene of no size at all is left as it is.
constexpr double kMostScale = 0x1p300;
// What a camera or a light far away may take from the scale of the objects.
constexpr double kMostDistance = 128;
// The smallest solid or mirror, in the box: 65536 steps of a length.
constexpr double kLeastRadius = 0x1p-11;
// Below the 16 where ratios, curvatures and the radius of a cone at its bounding ball end.
constexpr double kMostRatio = 15;
constexpr double kMostRefraction = 8;
constexpr double kMostShininess = 0x1p36;
// Radiance ends at 128: what all lights together can make of a surface must stay below, and 2^8 times more may be
// scaled down, which leaves a radiance of 1 its 16 bits.
constexpr double kMostRadiance = 96;
constexpr std::int32_t kMostExposure = 8;

/// About places counted from `origin`.
struct Box {
    Point origin;
    Point low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};

    void add(const Point& world, double radius) {
        const Point p = world - origin;
        low = {lesser(low.x, p.x - radius), lesser(low.y, p.y - radius), lesser(low.z, p.z - radius)};
        high = {greater(high.x, p.x + radius), greater(high.y, p.y + radius), greater(high.z, p.z + radius)};
    }
    double farthest_coordinate() const {
        const double below = greater(magnitude(low.x), greater(magnitude(low.y), magnitude(low.z)));
        return greater(below, greater(magnitude(high.x), greater(magnitude(high.y), magnitude(high.z))));
    }

    static double lesser(double a, double b) { return a < b ? a : b; }
    static double greater(double a, double b) { return a > b ? a : b; }
};

/// The largest power of two that brings the box into +-8 and its diagonal below 15.
double scale_of(const Box& box) {
    const double farthest = box.farthest_coordinate(), way = length(box.high - box.low);
    double scale = 1;
    while (farthest * scale > kBox || way * scale > kLongestWay) scale /= 2;
    while (scale < kMostScale && farthest * scale * 2 <= kBox && way * scale * 2 <= kLongestWay) scale *= 2;
    return scale;
}

/// Who stands so far away that the solids and mirrors lose too many digits, if anybody does.
Status check_distances(const Scene& scene, const Point& start, const Box& objects, double scale) {
    // A box without objects has no size to lose.
    if (scene.solid_count + scene.mirror_count == 0 || scale * kMostDistance >= scale_of(objects)) return kOk;
    const char* reason = "is too far from the solids and mirrors for fixed point: at most 128 times their size";
    const Point middle = (objects.low + objects.high) * 0.5 + objects.origin;
    double farthest = length(start - middle);
    Status status{"position", reason, Part::camera, 0};
    for (std::int32_t j = 0; j < scene.light_count; ++j) {
        const double distance = length(scene.lights[j].position - middle);
        if (distance <= farthest) continue;
        farthest = distance;
        status = Status{"position", reason, Part::light, j};
    }
    return status;
}

Status check_solid(const Solid& solid, const Ball& ball, double scale, std::int32_t k) {
    const auto complain = [k](const char* field, const char* reason) { return Status{field, reason, Part::solid, k}; };
    if (ball.radius * scale < kLeastRadius) {
        return complain(solid.kind == SolidKind::mesh ? "scale" : "radius",
                        "is too small beside the whole scene for fixed point: at least 1/32768 of its box");
    }
    if (solid.kind == SolidKind::cylinder || solid.kind == SolidKind::cone) {
        const double slope = magnitude(slope_of(solid));
        if (slope > kMostRatio || slope * ball.radius * scale > kMostRatio / 2) {
            return complain("height", "is too small beside the radius for a cone in fixed point");
        }
    }
    const double index = solid.material.refractive_index;
    if (solid.material.transmission > 0 && (index > kMostRefraction || index * kMostRefraction < 1)) {
        return complain("refractive_index", "must lie in 1/8..8 in fixed point");
    }
    if (solid.material.shininess > kMostShininess) return complain("shininess", "must be at most 2^36 in fixed point");
    return kOk;
}

Status check_mirror(const Mirror& mirror, const Ball& ball, double scale, std::int32_t m) {
    const auto complain = [m](const char* field, const char* reason) { return Status{field, reason, Part::mirror, m}; };
    if (ball.radius * scale < kLeastRadius) {
        return complain("boundary", "is too small beside the whole scene for fixed point: at least 1/32768 of its box");
    }
    if (magnitude(mirror.curvature_radius) * scale * kMostRatio < 1) {
        return complain("curvature_radius", "is too small beside the whole scene for fixed point: at least 1/240 of its box");
    }
    const double shininess = mirror.shininess != kShininessOfLobe       ? mirror.shininess
                             : mirror.lobe_exponent < kInfinity ? mirror.lobe_exponent
                                                                        : 0;
    if (shininess > kMostShininess) {
        return complain(mirror.shininess != kShininessOfLobe ? "shininess" : "lobe_exponent",
                        "must be at most 2^36 in fixed point");
    }
    return kOk;
}

double brightest(const Rgb<double>& c) { return Box::greater(c.r, Box::greater(c.g, c.b)); }

/// The most that one light can add: K_d + K_s is at most 2. With the inverse square, at the distance 1 of the box.
double power_in_box(const Light& light, double scale) {
    const double power = 2 * brightest(light.color) * light.intensity;
    return light.falloff == Falloff::inverse_square ? power * scale * scale : power;
}

}  // namespace

Status fit(const Scene& scene, const Surroundings& around, const Vec3<double>& origin, const Vec3<double>& start,
           Constants<FixedFormats>& to) {
    Box box{origin};
    for (std::int32_t k = 0; k < scene.solid_count; ++k) box.add(around.solids[k].centre, around.solids[k].radius);
    for (std::int32_t m = 0; m < scene.mirror_count; ++m) box.add(around.mirrors[m].centre, around.mirrors[m].radius);
    const Box objects = box;
    box.add(start, 0);
    for (std::int32_t j = 0; j < scene.light_count; ++j) box.add(scene.lights[j].position, 0);
    const double scale = scale_of(box);
    if (const Status status = check_distances(scene, start, objects, scale); !status.ok()) return status;

    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        const Status status = check_solid(scene.solids[k], around.solids[k], scale, k);
        if (!status.ok()) return status;
    }
    for (std::int32_t m = 0; m < scene.mirror_count; ++m) {
        const Status status = check_mirror(scene.mirrors[m], around.mirrors[m], scale, m);
        if (!status.ok()) return status;
    }

    double radiance = brightest(scene.ambient) + brightest(scene.background);
    std::int32_t strongest = 0;
    for (std::int32_t j = 0; j < scene.light_count; ++j) {
        radiance += power_in_box(scene.lights[j], scale);
        if (power_in_box(scene.lights[j], scale) > power_in_box(scene.lights[strongest], scale)) strongest = j;
    }
    std::int32_t exposure = 0;
    for (double rest = radiance; rest > kMostRadiance && exposure <= kMostExposure; rest /= 2) ++exposure;
    if (exposure > kMostExposure) {
        const bool of_light = scene.light_count > 0 &&
                              power_in_box(scene.lights[strongest], scale) > brightest(scene.ambient) &&
                              power_in_box(scene.lights[strongest], scale) > brightest(scene.background);
        const char* reason = "is too bright for fixed point: all light together must stay below 24000";
        if (of_light) return Status{"intensity", reason, Part::light, strongest};
        const bool of_ambient = brightest(scene.ambient) > brightest(scene.background);
        return Status{of_ambient ? "ambient" : "background", reason, Part::scene, 0};
    }
    to = Constants<FixedFormats>(origin, scale, exposure);
    return kOk;
}

}  // namespace zerkalo
