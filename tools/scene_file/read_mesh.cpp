// [[solid]] of kind "mesh": triangles out of an STL file or out of the scene file itself.
#include "tools/scene_file/file_bytes.hpp"
#include "tools/scene_file/read_tables.hpp"
#include "tools/scene_file/stl.hpp"
#include "tools/scene_file/table_reader.hpp"

#include <system_error>
#include <utility>

namespace zerkalo::scene_file {
namespace {

constexpr std::size_t kMaxStlSize = std::size_t{1} << 20;  // 512 triangles in ASCII take a sixth of it

using Triangles = std::vector<Triangle>;

void read_stl_file(TableReader& reader, const std::filesystem::path& directory, int room, Triangles& triangles) {
    std::string name;
    if (!reader.text("stl", name)) return;
    const std::filesystem::path path = directory / name;
    const Position named_at = reader.place_of("stl");
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored)) {
        reader.error(named_at, "cannot read \"" + path.string() + "\": not a file");
        return;
    }
    FileBytes file = read_file(path, kMaxStlSize);
    if (!file.fault.empty()) {
        reader.error(named_at, "cannot read \"" + path.string() + "\": " + file.fault,
                     "the path is relative to the scene file");
        return;
    }
    const SourceText text(path.string(), std::move(file.bytes));
    if (file.too_large) {
        reader.report().error_in(text, {}, "larger than 1 MiB: " + too_many_triangles(room), named_at);
    } else if (const auto fault = read_stl(text, room, triangles)) {
        reader.report().error_in(text, fault->at, fault->message, named_at);
    } else if (triangles.empty()) {
        reader.report().error_in(text, {}, "no triangles", named_at);
    }
}

std::vector<Vec3<double>> read_vertices(TableReader& reader, const toml::array& array) {
    std::vector<Vec3<double>> vertices;
    for (const toml::node& node : array) {
        const auto corner =
            reader.numbers(node, "vertex " + std::to_string(vertices.size()) + " of \"vertices\"", 3, kCoordinate);
        vertices.push_back(corner ? Vec3<double>{(*corner)[0], (*corner)[1], (*corner)[2]} : Vec3<double>{0, 0, 0});
    }
    return vertices;
}

/// One triangle's three indices. False after an error.
bool read_indices(TableReader& reader, const toml::node& node, std::size_t number, std::size_t vertex_count,
                  std::size_t (&indices)[3]) {
    const toml::array* array = node.as_array();
    const std::string name = "triangle " + std::to_string(number) + " of \"triangles\"";
    if (array == nullptr || array->size() != 3) {
        reader.error(position_of(node), name + " must be three vertex numbers [a, b, c]");
        return false;
    }
    bool right = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto* index = (*array)[i].as_integer();
        if (index == nullptr || static_cast<std::uint64_t>(index->get()) >= vertex_count) {
            reader.error(position_of((*array)[i]), name + ": a vertex number must be a whole number from 0 to " +
                                                       std::to_string(vertex_count - 1) + ", not " +
                                                       described((*array)[i]));
            right = false;
        } else {
            indices[i] = static_cast<std::size_t>(index->get());
        }
    }
    return right;
}

const toml::array* filled_array(TableReader& reader, std::string_view key, const char* example) {
    const toml::node* node = reader.find(key);
    if (node == nullptr) return nullptr;
    const toml::array* array = node->as_array();
    if (array != nullptr && !array->empty()) return array;
    const std::string here = array != nullptr ? "an empty array" : described(*node);
    reader.error(position_of(*node), in_quotes(key) + " must be an array of arrays, not " + here, example);
    return nullptr;
}

void read_inline(TableReader& reader, int room, Triangles& triangles) {
    reader.require("vertices");
    reader.require("triangles");
    const toml::array* vertex_array =
        filled_array(reader, "vertices", "for example: [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], ...]");
    const toml::array* triangle_array = filled_array(reader, "triangles", "for example: [[0, 1, 2], [0, 2, 3], ...]");
    if (vertex_array == nullptr || triangle_array == nullptr) return;
    if (triangle_array->size() > static_cast<std::size_t>(room)) {
        reader.error(position_of(*triangle_array),
                     std::to_string(triangle_array->size()) + " triangles: " + too_many_triangles(room));
        return;
    }
    const std::vector<Vec3<double>> vertices = read_vertices(reader, *vertex_array);
    std::size_t number = 0;
    for (const toml::node& node : *triangle_array) {
        std::size_t corner[3];
        if (read_indices(reader, node, number, vertices.size(), corner)) {
            triangles.push_back({vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]});
        }
        ++number;
    }
}

}  // namespace

void read_mesh(const toml::table& table, const std::filesystem::path& directory, Report& report, Solid& solid,
               Scene& scene) {
    TableReader reader(table, "a mesh", report);
    const int room = kMaxTriangles - scene.triangle_count;
    Triangles triangles;
    const bool has_inline = reader.has("vertices") || reader.has("triangles");
    if (!reader.has("stl") && !has_inline) {
        reader.error(header_of(table), "missing triangles: a mesh needs \"stl\", or \"vertices\" and \"triangles\"");
    } else if (reader.at_most_one("stl", "vertices") && reader.at_most_one("stl", "triangles")) {
        has_inline ? read_inline(reader, room, triangles) : read_stl_file(reader, directory, room, triangles);
    }
    solid.first_triangle = scene.triangle_count;
    solid.triangle_count = static_cast<std::int32_t>(triangles.size());
    for (const Triangle& triangle : triangles) scene.triangles[scene.triangle_count++] = triangle;
}

}  // namespace zerkalo::scene_file
