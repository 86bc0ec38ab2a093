// Small scenes and one-ray probes for the tests of the reference tracer.
#pragma once

#include "tests/support/reference.hpp"
#include "tools/staging.hpp"

#include <numbers>

namespace zerkalo::reference {

using staging::add;
using staging::glowing;
using staging::lamp;

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kSeed = 20240607;

inline Settings depth(int limit) {
    Settings settings;
    settings.depth_limit = limit;
    return settings;
}

/// Radiance that arrives at `origin` from `direction` (any length).
inline Color look(const Scene& scene, const Vector& origin, const Vector& direction, int depth_limit = 6,
                  unsigned lobe_samples = 1) {
    Random random(kSeed);
    return Tracer(scene, depth(depth_limit), lobe_samples).radiance({origin, normalized(direction)}, random);
}

/// A mirror that only reflects, all of it: disc of that radius at the origin, facing +z.
inline Mirror ideal_mirror(double radius) {
    Mirror mirror;
    mirror.boundary.shape = BoundaryShape::disc;
    mirror.boundary.radius = radius;
    mirror.ambient = mirror.diffuse = mirror.specular = 0;
    mirror.reflection = 1;
    return mirror;
}

inline Solid ball(const Vec3<double>& center, double radius) {
    Solid solid;
    solid.kind = SolidKind::sphere;
    solid.position = center;
    solid.radius = radius;
    return solid;
}

}  // namespace zerkalo::reference
