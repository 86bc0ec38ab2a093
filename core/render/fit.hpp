// Whether a scene fits into the fixed-point formats, and the powers of two that bring it there.
#pragma once

#include "core/render/cull.hpp"
#include "core/status.hpp"

namespace zerkalo {

/// Chooses the scale of lengths and the exposure for a validated scene; or the field that the formats cannot hold, and
/// why. `origin`: where the camera's rays start.
Status fit(const Scene& scene, const Surroundings& around, const Vec3<double>& origin, Constants<FixedFormats>& to);

}  // namespace zerkalo
