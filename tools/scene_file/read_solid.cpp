// [[solid]]: its kind, its sizes, its place and its material.
#include "core/scene/edit.hpp"
#include "tools/scene_file/read_tables.hpp"
#include "tools/scene_file/table_reader.hpp"

#include <algorithm>
#include <array>

namespace zerkalo::scene_file {
namespace {

constexpr std::array<std::string_view, 12> kCommonKeys{"kind",       "position",     "rotate_deg",       "color",
                                                       "ambient",    "diffuse",      "specular",         "shininess",
                                                       "reflection", "transmission", "refractive_index", "fresnel"};
constexpr std::array<std::string_view, 6> kKinds{"pyramid",  "prism", "sphere",
                                                 "cylinder", "cone",  "mesh"};  // of SolidKind

/// The keys that belong to one kind alone; the first `required` of them must be there.
struct Sizes {
    std::array<std::string_view, 4> keys;
    std::size_t count, required;
};
constexpr std::array<Sizes, 6> kSizes{{{{"sides", "radius", "height"}, 3, 3},
                                       {{"sides", "radius", "height"}, 3, 3},
                                       {{"radius"}, 1, 1},
                                       {{"radius", "height", "taper"}, 3, 2},
                                       {{"radius", "height", "taper"}, 3, 2},
                                       {{"stl", "vertices", "triangles", "scale"}, 4, 0}}};

std::vector<std::string_view> keys_of_any_kind() {
    std::vector<std::string_view> keys(kCommonKeys.begin(), kCommonKeys.end());
    for (const Sizes& sizes : kSizes) {
        for (const std::string_view key : Words(sizes.keys).first(sizes.count)) {
            if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
        }
    }
    return keys;
}

void read_sizes(TableReader& reader, Solid& solid) {
    const Sizes& sizes = kSizes[static_cast<std::size_t>(solid.kind)];
    std::vector<std::string_view> keys(kCommonKeys.begin(), kCommonKeys.end());
    keys.insert(keys.begin() + 2, sizes.keys.begin(), sizes.keys.begin() + sizes.count);
    reader.allow(keys, keys_of_any_kind());
    for (const std::string_view key : Words(sizes.keys).first(sizes.required)) reader.require(key);
    if (solid.kind == SolidKind::cone) solid.taper = 0;
    reader.integer("sides", kMinSides, kMaxSides, solid.sides);
    reader.number("radius", kSize, solid.radius);
    reader.number("height", kSize, solid.height);
    reader.number("taper", kTaper, solid.taper);
    reader.number("scale", kSize, solid.scale);
}

void read_material(TableReader& reader, Material& material) {
    reader.color("color", kUnit, material.color);
    reader.number("ambient", kUnit, material.ambient);
    reader.number("diffuse", kUnit, material.diffuse);
    reader.number("specular", kUnit, material.specular);
    reader.number("shininess", kNotNegative, material.shininess);
    reader.number("reflection", kUnit, material.reflection);
    const bool transmission_is_wrong =
        !reader.number("transmission", kUnit, material.transmission) && reader.has("transmission");
    reader.number("refractive_index", kPositive, material.refractive_index);
    reader.truth("fresnel", material.fresnel);
    if (material.fresnel && material.transmission == 0 && !transmission_is_wrong) {
        reader.error(reader.place_of("fresnel"), "\"fresnel\" is for a solid that transmits light",
                     "write a \"transmission\" above 0 as well");
    }
    if (material.reflection + material.transmission > 1) {
        reader.error(reader.place_of("transmission"), "\"reflection\" and \"transmission\" together must be at most 1");
    }
}

}  // namespace

void read_solid(const toml::table& table, const std::filesystem::path& directory, Report& report, Solid& solid,
                Scene& scene) {
    TableReader untyped(table, "a solid", report);
    untyped.require("kind");
    const bool has_kind = untyped.choice("kind", kKinds, solid.kind);
    const std::string what = has_kind ? "a " + std::string(kKinds[static_cast<std::size_t>(solid.kind)]) : "a solid";
    TableReader reader(table, what, report);
    reader.require("position");
    if (has_kind) {
        read_sizes(reader, solid);
    } else {
        reader.allow(keys_of_any_kind());
    }
    reader.point("position", solid.position);
    Vec3<double> degrees{};
    if (reader.point("rotate_deg", degrees, kAngle)) {
        solid.rotation = {radians(degrees.x), radians(degrees.y), radians(degrees.z)};
    }
    read_material(reader, solid.material);
    if (has_kind && solid.kind == SolidKind::mesh) read_mesh(table, directory, report, solid, scene);
}

}  // namespace zerkalo::scene_file
