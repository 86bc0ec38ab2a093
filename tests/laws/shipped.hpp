// The scenes that come with the program, as the tests want them.
#pragma once

#include "core/scene/scene.hpp"

#include <string>
#include <vector>

namespace zerkalo::laws {

struct ShippedScene {
    std::string name;  // of the file, without its extension
    Scene scene;
};

/// All of firmware/scenes, by name. Throws std::runtime_error with the diagnostics when one does not load.
const std::vector<ShippedScene>& shipped_scenes();

/// The same scene with polished mirrors; their highlights stay as they were.
Scene sharpened(Scene scene);

}  // namespace zerkalo::laws
