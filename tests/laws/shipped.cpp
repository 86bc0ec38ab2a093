// See shipped.hpp.
#include "tests/laws/shipped.hpp"

#include "tools/scene_file/scene_file.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace zerkalo::laws {
namespace {

std::vector<ShippedScene> load_all() {
    std::vector<ShippedScene> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(ZERKALO_SOURCE_DIR "/firmware/scenes")) {
        if (entry.path().extension() != ".toml") continue;
        const LoadResult result = load_scene(entry.path());
        if (!result.ok()) throw std::runtime_error(to_text(result));
        scenes.push_back({entry.path().stem().string(), *result.scene});
    }
    if (scenes.empty()) throw std::runtime_error("firmware/scenes holds no scene");
    std::sort(scenes.begin(), scenes.end(),
              [](const ShippedScene& a, const ShippedScene& b) { return a.name < b.name; });
    return scenes;
}

}  // namespace

const std::vector<ShippedScene>& shipped_scenes() {
    static const std::vector<ShippedScene> scenes = load_all();
    return scenes;
}

Scene sharpened(Scene scene) {
    for (int m = 0; m < scene.mirror_count; ++m) {
        Mirror& mirror = scene.mirrors[m];
        const bool follows_lobe = mirror.shininess == kShininessOfLobe && mirror.lobe_exponent < kInfinity;
        if (follows_lobe) mirror.shininess = mirror.lobe_exponent;
        mirror.lobe_exponent = kInfinity;
    }
    return scene;
}

}  // namespace zerkalo::laws
