#include "core/scene/edit.hpp"

#include "core/geometry/frame.hpp"

#include <limits>

namespace zerkalo {

Camera moved(const Camera& camera, const Vec3<double>& delta) {
    Camera out = camera;
    out.position = camera.position + delta;
    return out;
}

Light moved(const Light& light, const Vec3<double>& delta) {
    Light out = light;
    out.position = light.position + delta;
    return out;
}

Camera turned(const Camera& camera, const Vec3<double>& angles) {
    Camera out = camera;
    out.view = rotated(camera.view, angles);
    out.up = rotated(camera.up, angles);
    return out;
}

double radians(double degrees) {
    // Whole turns leave first, exactly, so that 1e9 degrees is as good as its remainder.
    constexpr double kExactTurns = 0x1p51;
    const double turns = degrees / 360;
    if (magnitude(turns) >= kExactTurns) return 0;
    const double rest = magnitude(turns) <= 1 ? degrees : degrees - 360 * nearest_integer(turns);
    return rest * (kPi / 180);
}

double exponent_of_polish(double polish) {
    if (!(polish >= 0 && polish <= 1)) return std::numeric_limits<double>::quiet_NaN();
    if (polish == 1) return kInfinity;
    const double rough = 1 - polish;
    const double alpha2 = (rough * rough) * (rough * rough);
    return (1 / alpha2 - 1) / 2;
}

}  // namespace zerkalo
