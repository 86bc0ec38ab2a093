// What a key, a finger or a line of a scene file does to a scene: pure functions (seed formulas 2.11-2.14).
#pragma once

#include "core/scene/scene.hpp"

namespace zerkalo {

/// Shifts the position only (2.11). Scene units.
Camera moved(const Camera& camera, const Vec3<double>& delta);
Light moved(const Light& light, const Vec3<double>& delta);

/// Turns view and up about the fixed axes x, then y, then z (2.12-2.14, column vectors). Radians, up to 1e7 degrees.
Camera turned(const Camera& camera, const Vec3<double>& angles);

/// Degrees to radians, rounded once.
double radians(double degrees);

/// Polish 0..1 -> exponent of the mirror's lobe, ((1-p)^-4 - 1)/2; 1 gives infinity, the sharp mirror. Any other number
/// gives NaN, which prepare() refuses.
double exponent_of_polish(double polish);

}  // namespace zerkalo
