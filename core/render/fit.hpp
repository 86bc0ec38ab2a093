// Whether a scene fits into the fixed-point formats, and the powers of two that bring it there.
#pragma once

#include "core/render/cull.hpp"
#include "core/status.hpp"

namespace zerkalo {

/// Chooses the scale of lengths and the exposure for a validated scene; or the field that the formats cannot hold, and
/// why. `origin`: what the plan's places count from. `start`: where the camera's rays start.
Status fit(const Scene& scene, const Surroundings& around, const Vec3<double>& origin, const Vec3<double>& start,
           Constants<FixedFormats>& to);

}  // namespace zerkalo
