// From a field of the scene back to the text that it came from.
#include "tools/scene_file/read_scene.hpp"
#include "tools/scene_file/table_reader.hpp"

#include <string_view>

namespace zerkalo::scene_file {
namespace {

const toml::table* table_of(const Status& status, const Tables& tables) {
    const auto at = [&status](const std::vector<const toml::table*>& list) {
        return list.at(static_cast<std::size_t>(status.index));
    };
    switch (status.part) {
        case Part::image: return tables.image;
        case Part::camera: return tables.camera;
        case Part::light: return at(tables.lights);
        case Part::solid: return at(tables.solids);
        case Part::mirror: return at(tables.mirrors);
        case Part::scene:
        case Part::settings:
        case Part::none: break;
    }
    return tables.root;
}

/// The value of a key, "boundary.key" being the key of a table in the table, or null.
const toml::node* value_of(const toml::table& table, std::string_view key) {
    const std::size_t point = key.find('.');
    if (point == std::string_view::npos) return table.get(key);
    return table.get(key.substr(0, point))->as_table()->get(key.substr(point + 1));
}

}  // namespace

Position locate(const Status& status, const Tables& tables) {
    const toml::table& table = *table_of(status, tables);
    const std::string_view field = status.field;
    if (const toml::node* node = value_of(table, field)) return position_of(*node);
    // The triangles of a mesh that an STL file gives are wrong where the file is named.
    const toml::node* file = table.get("stl");
    if (field == "triangles" && file != nullptr) return position_of(*file);
    return header_of(table);
}

}  // namespace zerkalo::scene_file
