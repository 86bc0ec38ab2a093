// Plans for rows that render tiles themselves: in an order, on threads, or into memory of their own.
#pragma once

#include "tools/stability/stage.hpp"

#include <memory>

namespace zerkalo::stability {

/// Throws Refused when prepare() refuses the scene.
inline std::unique_ptr<Plan> plan_of(const Scene& scene, Settings settings, int width, int height) {
    settings.width = width, settings.height = height;
    auto plan = std::make_unique<Plan>();
    if (const Status status = prepare(scene, settings, *plan); !status.ok()) throw Refused(status.reason);
    return plan;
}

}  // namespace zerkalo::stability
