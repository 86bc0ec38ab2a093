// [[light]]: a point light.
#include "core/scene/edit.hpp"
#include "tools/scene_file/read_tables.hpp"
#include "tools/scene_file/table_reader.hpp"

#include <array>

namespace zerkalo::scene_file {
namespace {

constexpr std::array<std::string_view, 5> kLightKeys{"position", "color", "intensity", "falloff", "move"};
constexpr std::array<std::string_view, 2> kFalloffs{"none", "inverse_square"};  // in the order of Falloff

}  // namespace

void read_light(const toml::table& table, Report& report, Light& light) {
    TableReader reader(table, "a light", report);
    reader.allow(kLightKeys);
    reader.require("position");
    reader.point("position", light.position);
    reader.color("color", kNotNegative, light.color);
    reader.number("intensity", kNotNegative, light.intensity);
    reader.choice("falloff", kFalloffs, light.falloff);
    Vec3<double> delta{};
    if (reader.point("move", delta)) {
        light = moved(light, delta);
        reader.require_reachable("move", light.position);
    }
}

}  // namespace zerkalo::scene_file
