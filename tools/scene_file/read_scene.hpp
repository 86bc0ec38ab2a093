// The whole tree of a scene file into a Scene, and the way back from a part of the scene to its table.
#pragma once

#include "core/scene/scene.hpp"
#include "core/status.hpp"
#include "tools/scene_file/report.hpp"
#include "tools/scene_file/toml_tree.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace zerkalo::scene_file {

/// The table that each part of the scene came from.
struct Tables {
    const toml::table* root = nullptr;
    const toml::table* image = nullptr;
    const toml::table* camera = nullptr;
    std::vector<const toml::table*> lights, solids, mirrors;
};

/// Reads everything; what is wrong goes to the report. `scene` counts only when the report stays empty.
Tables read_scene(const toml::table& root, const std::filesystem::path& directory, Report& report, Scene& scene,
                  std::string& title);

/// The place of the value that a Status speaks of; of its table's header when the key is absent.
Position locate(const Status& status, const Tables& tables);

}  // namespace zerkalo::scene_file
