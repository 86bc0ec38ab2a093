// [[mirror]]: a plane or spherical mirror, its outline, its polish and its colour.
#include "core/scene/edit.hpp"
#include "tools/scene_file/read_tables.hpp"
#include "tools/scene_file/table_reader.hpp"

#include <array>

namespace zerkalo::scene_file {
namespace {

constexpr std::array<std::string_view, 14> kMirrorKeys{
    "position", "normal", "up",      "boundary", "curvature_radius", "lobe",      "lobe_exponent",
    "polish",   "color",  "ambient", "diffuse",  "specular",         "shininess", "reflection"};
constexpr std::array<std::string_view, 3> kLobes{"phong", "max_phong", "ggx"};                 // in the order of Lobe
constexpr std::array<std::string_view, 4> kShapes{"rectangle", "disc", "ellipse", "polygon"};  // of BoundaryShape
constexpr std::array<std::string_view, 5> kBoundaryKeys{"shape", "width", "height", "radius", "points"};
constexpr std::array<std::string_view, 3> kSizedKeys{"shape", "width", "height"};
constexpr std::array<std::string_view, 2> kDiscKeys{"shape", "radius"};
constexpr std::array<std::string_view, 2> kPolygonKeys{"shape", "points"};

constexpr Words keys_of(BoundaryShape shape) {
    switch (shape) {
        case BoundaryShape::disc: return kDiscKeys;
        case BoundaryShape::polygon: return kPolygonKeys;
        case BoundaryShape::rectangle:
        case BoundaryShape::ellipse: break;
    }
    return kSizedKeys;
}

void read_corners(TableReader& reader, Boundary& boundary) {
    const toml::node* node = reader.find("points");
    if (node == nullptr) return;
    const toml::array* points = node->as_array();
    const std::size_t count = points == nullptr ? 0 : points->size();
    if (points == nullptr || count < 3 || count > kMaxCorners) {
        const std::string here = points == nullptr ? described(*node) : std::to_string(count);
        reader.error(position_of(*node),
                     "\"points\" must be 3 to " + std::to_string(kMaxCorners) + " corners [x, y], not " + here);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const auto corner =
            reader.numbers((*points)[i], "corner " + std::to_string(i + 1) + " of \"points\"", 2, kCoordinate);
        if (corner) boundary.corners[i] = {(*corner)[0], (*corner)[1]};
    }
    boundary.corner_count = static_cast<std::int32_t>(count);
}

void read_boundary(TableReader& mirror, Boundary& boundary) {
    const toml::node* node = mirror.find("boundary");
    if (node == nullptr) return;
    const toml::table* table = node->as_table();
    if (table == nullptr) {
        mirror.error(position_of(*node), "\"boundary\" must be a table, not " + described(*node),
                     "for example: boundary = { shape = \"disc\", radius = 1.0 }");
        return;
    }
    TableReader untyped(*table, "a boundary", mirror.report());
    untyped.require("shape");
    if (!untyped.choice("shape", kShapes, boundary.shape)) {
        untyped.allow(kBoundaryKeys);
        return;
    }
    const std::string_view shape = kShapes[static_cast<std::size_t>(boundary.shape)];
    const std::string article = boundary.shape == BoundaryShape::ellipse ? "an " : "a ";
    TableReader reader(*table, article + std::string(shape), mirror.report());
    const Words keys = keys_of(boundary.shape);
    reader.allow(keys, kBoundaryKeys);
    for (const std::string_view key : keys) reader.require(key);
    reader.number("width", kSize, boundary.width);
    reader.number("height", kSize, boundary.height);
    reader.number("radius", kSize, boundary.radius);
    read_corners(reader, boundary);
}

void read_lobe(TableReader& reader, Mirror& mirror) {
    reader.choice("lobe", kLobes, mirror.lobe);
    reader.at_most_one("polish", "lobe_exponent");
    double polish = 1;
    if (reader.number("polish", kUnit, polish)) mirror.lobe_exponent = exponent_of_polish(polish);
    reader.number("lobe_exponent", kLobeExponent, mirror.lobe_exponent);
}

}  // namespace

void read_mirror(const toml::table& table, Report& report, Mirror& mirror) {
    TableReader reader(table, "a mirror", report);
    reader.allow(kMirrorKeys);
    for (const std::string_view key : {"position", "normal", "boundary"}) reader.require(key);
    reader.point("position", mirror.position);
    reader.direction("normal", mirror.normal);
    reader.direction("up", mirror.up);
    read_boundary(reader, mirror.boundary);
    double radius = kInfinity;
    if (reader.number("curvature_radius", kCurvature, radius) && radius == 0) {
        reader.error(reader.place_of("curvature_radius"), "\"curvature_radius\" must not be 0",
                     "write inf for a flat mirror");
    }
    mirror.curvature_radius = radius;
    read_lobe(reader, mirror);
    reader.color("color", kUnit, mirror.color);
    reader.number("ambient", kUnit, mirror.ambient);
    reader.number("diffuse", kUnit, mirror.diffuse);
    reader.number("specular", kUnit, mirror.specular);
    reader.number("shininess", kNotNegative, mirror.shininess);
    reader.number("reflection", kUnit, mirror.reflection);
}

}  // namespace zerkalo::scene_file
