// Loads a scene file (TOML, version 1): text -> Scene, or a list of everything that is wrong with it.
#pragma once

#include "core/scene/scene.hpp"
#include "tools/scene_file/diagnostic.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace zerkalo {

constexpr std::size_t kMaxSceneFileSize = std::size_t{1} << 20;
constexpr int kMaxDiagnostics = 20;

/// Either a scene, which has passed validate(), or diagnostics.
struct LoadResult {
    std::unique_ptr<Scene> scene;         // null when anything is wrong
    std::string title;                    // "" when the file gives none
    std::vector<Diagnostic> diagnostics;  // in the order of the text, at most kMaxDiagnostics
    int more_errors = 0;                  // found beyond those
    int exit_code = 0;                    // 0; 1: the file cannot be read; 3: its text or a file that it names is wrong

    bool ok() const { return scene != nullptr; }
};

/// Reads and checks a scene file. Relative STL paths begin at its directory. Never throws.
LoadResult load_scene(const std::filesystem::path& path);

/// The same for a text in memory. `name`: what diagnostics call it; `directory`: where relative STL paths begin.
LoadResult load_scene_text(std::string text, std::string name, const std::filesystem::path& directory);

/// All diagnostics as the user reads them; "" for a scene.
std::string to_text(const LoadResult& result);

}  // namespace zerkalo
