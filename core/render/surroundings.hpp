// Where everything is, and what is far from it.
#pragma once

#include "core/render/cull.hpp"

namespace zerkalo {

void derive_surroundings(const Scene& scene, Surroundings& around);

/// Farther than 64 radii of the scene: from there a float origin would waste its digits.
bool is_far(const Point& p, const Surroundings& around);

/// A scene far from the world's origin, by its own size, would waste the digits of floats that count from there. They
/// count from a point near the scene instead: a multiple of a power of two that grows with the scene, so that places on
/// a grid stay on it, and a scene that is shifted by such multiples gives the same bits.
Point origin_for(const Ball& all);

/// How far a far camera's origin is moved along its view; 0 of a near one.
double pull_of(const Viewpoint& eye, const Surroundings& around);

}  // namespace zerkalo
