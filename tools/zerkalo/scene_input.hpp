// A scene from a file for the commands: diagnostics go to stderr, failure becomes the command's exit code.
#pragma once

#include "core/scene/scene.hpp"

#include <memory>
#include <string>

namespace zerkalo {

struct SceneInput {
    std::unique_ptr<const Scene> scene;
    std::string title;
};

/// Reads the scene file `path`. Throws Failure: io_failed when it cannot be read, scene_invalid when it is wrong, in
/// both cases after printing why.
SceneInput read_scene(const std::string& path);

}  // namespace zerkalo
