// One function for every table of a scene file: reads it into its part of the scene, degrees into radians.
#pragma once

#include "core/scene/scene.hpp"
#include "tools/scene_file/report.hpp"
#include "tools/scene_file/toml_tree.hpp"

#include <filesystem>

namespace zerkalo::scene_file {

void read_image(const toml::table& table, Report& report, ImageSize& image);
void read_camera(const toml::table& table, Report& report, Camera& camera);
void read_light(const toml::table& table, Report& report, Light& light);
void read_mirror(const toml::table& table, Report& report, Mirror& mirror);

/// A mesh adds its triangles to the scene's; `directory` is where a relative STL path begins.
void read_solid(const toml::table& table, const std::filesystem::path& directory, Report& report, Solid& solid,
                Scene& scene);
void read_mesh(const toml::table& table, const std::filesystem::path& directory, Report& report, Solid& solid,
               Scene& scene);

}  // namespace zerkalo::scene_file
