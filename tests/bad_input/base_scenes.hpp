// Small good scenes that together use every feature: what bad numbers are put into.
#pragma once

#include "core/scene/scene.hpp"

#include <string>
#include <vector>

namespace zerkalo::bad_input {

struct BaseScene {
    std::string name;
    Scene scene;
};

/// One solid, one light, one mirror each: every kind, outline, curvature, lobe and falloff occurs.
const std::vector<BaseScene>& small_scenes();

/// All of them in one scene.
const BaseScene& crowded_scene();

}  // namespace zerkalo::bad_input
