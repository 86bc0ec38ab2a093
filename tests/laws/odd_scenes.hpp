// Scenes that nobody ships: every feature at once, and cameras, lamps and mirrors where one would not put them.
#pragma once

#include "core/render/settings.hpp"
#include "core/scene/scene.hpp"

#include <string>
#include <vector>

namespace zerkalo::laws {

struct OddScene {
    std::string name;  // fit for a file's name
    Scene scene;       // its mirrors are polished
    Settings settings;
};

const std::vector<OddScene>& odd_scenes();

}  // namespace zerkalo::laws
