#include "tools/scene_file/read_scene.hpp"

#include "tools/scene_file/read_tables.hpp"
#include "tools/scene_file/table_reader.hpp"

#include <array>

namespace zerkalo::scene_file {
namespace {

constexpr std::array<std::string_view, 9> kSceneKeys{"version", "title", "ambient", "background", "image",
                                                     "camera",  "light", "solid",   "mirror"};
constexpr std::int64_t kVersion = 1;

/// False when the file is of another version: then nothing else in it can be judged.
bool is_our_version(TableReader& reader) {
    reader.require("version");
    const toml::node* node = reader.find("version");
    if (node == nullptr) return true;
    const auto* version = node->as_integer();
    if (version != nullptr && version->get() == kVersion) return true;
    reader.error(position_of(*node),
                 "\"version\" must be 1, the only one that this program reads, not " + described(*node));
    return false;
}

/// A table that must be there once, or null after an error.
const toml::table* single_table(TableReader& reader, std::string_view name) {
    reader.require(name);
    const toml::node* node = reader.find(name);
    if (node == nullptr || node->is_table()) return node == nullptr ? nullptr : node->as_table();
    const std::string brackets = "[" + std::string(name) + "]";
    const toml::array* array = node->as_array();
    const bool doubled = array != nullptr && !array->empty() && (*array)[0].is_table();
    const Position at = doubled ? position_of((*array)[0]) : position_of(*node);
    reader.error(at, in_quotes(name) + " must be one table, not " + described(*node),
                 "write " + brackets + (doubled ? ", in single brackets" : " and its keys on the lines below"));
    return nullptr;
}

/// The tables of a list, at most `capacity` of them.
std::vector<const toml::table*> list_of_tables(TableReader& reader, std::string_view name, int capacity) {
    std::vector<const toml::table*> tables;
    const toml::node* node = reader.find(name);
    if (node == nullptr) return tables;
    const std::string doubled = "[[" + std::string(name) + "]]";
    const toml::array* array = node->as_array();
    if (array == nullptr) {
        reader.error(position_of(*node), in_quotes(name) + " must be a list of tables, not " + described(*node),
                     "write " + doubled + ", in double brackets");
        return tables;
    }
    for (const toml::node& element : *array) {
        if (!element.is_table()) {
            reader.error(position_of(element),
                         "every " + std::string(name) + " must be a table, not " + described(element),
                         "write " + doubled + " and its keys on the lines below");
        } else if (static_cast<int>(tables.size()) == capacity) {
            reader.error(position_of(element), "too many: a scene holds at most " + std::to_string(capacity) +
                                                   " tables " + doubled + ", here are " +
                                                   std::to_string(array->size()));
            break;
        } else {
            tables.push_back(element.as_table());
        }
    }
    return tables;
}

}  // namespace

Tables read_scene(const toml::table& root, const std::filesystem::path& directory, Report& report, Scene& scene,
                  std::string& title) {
    TableReader reader(root, "a scene", report);
    Tables tables;
    tables.root = &root;
    if (!is_our_version(reader)) return tables;
    reader.allow(kSceneKeys);
    reader.text("title", title);
    reader.color("ambient", kNotNegative, scene.ambient);
    reader.color("background", kNotNegative, scene.background);
    tables.image = single_table(reader, "image");
    tables.camera = single_table(reader, "camera");
    tables.lights = list_of_tables(reader, "light", kMaxLights);
    tables.solids = list_of_tables(reader, "solid", kMaxSolids);
    tables.mirrors = list_of_tables(reader, "mirror", kMaxMirrors);
    if (tables.image != nullptr) read_image(*tables.image, report, scene.image);
    if (tables.camera != nullptr) read_camera(*tables.camera, report, scene.camera);
    for (const toml::table* table : tables.lights) read_light(*table, report, scene.lights[scene.light_count++]);
    for (const toml::table* table : tables.solids) {
        read_solid(*table, directory, report, scene.solids[scene.solid_count++], scene);
    }
    for (const toml::table* table : tables.mirrors) read_mirror(*table, report, scene.mirrors[scene.mirror_count++]);
    return tables;
}

}  // namespace zerkalo::scene_file
