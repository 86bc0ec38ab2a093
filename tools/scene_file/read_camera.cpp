// [camera]: position, view, angle, and the moves and turns of seed formulas 2.11-2.14.
#include "core/scene/edit.hpp"
#include "tools/scene_file/read_tables.hpp"
#include "tools/scene_file/table_reader.hpp"

#include <array>

namespace zerkalo::scene_file {
namespace {

constexpr std::array<std::string_view, 8> kCameraKeys{"position",           "look_at",          "view", "up",
                                                      "horizontal_fov_deg", "vertical_fov_deg", "move", "turn_deg"};

void read_view(TableReader& reader, Camera& camera) {
    const bool has_position = reader.point("position", camera.position);
    reader.exactly_one("look_at", "view");
    reader.direction("view", camera.view);
    reader.direction("up", camera.up);
    Vec3<double> target{};
    if (!reader.point("look_at", target) || !has_position) return;
    const Vec3<double>& eye = camera.position;
    camera.view = {target.x - eye.x, target.y - eye.y, target.z - eye.z};
    if (camera.view.x == 0 && camera.view.y == 0 && camera.view.z == 0) {
        reader.error(reader.place_of("look_at"), "\"look_at\" must not be the camera's own position");
    }
}

void read_opening(TableReader& reader, Camera& camera) {
    reader.exactly_one("horizontal_fov_deg", "vertical_fov_deg");
    double degrees = 0;
    if (reader.number("horizontal_fov_deg", kOpening, degrees)) {
        camera.fov = radians(degrees);
        camera.fov_axis = FovAxis::horizontal;
    }
    if (reader.number("vertical_fov_deg", kOpening, degrees)) {
        camera.fov = radians(degrees);
        camera.fov_axis = FovAxis::vertical;
    }
}

}  // namespace

void read_camera(const toml::table& table, Report& report, Camera& camera) {
    TableReader reader(table, "the camera", report);
    reader.allow(kCameraKeys);
    reader.require("position");
    read_view(reader, camera);
    read_opening(reader, camera);
    Vec3<double> delta{}, degrees{};
    if (reader.point("move", delta)) {
        camera = moved(camera, delta);
        reader.require_reachable("move", camera.position);
    }
    if (reader.point("turn_deg", degrees, kAngle)) {
        camera = turned(camera, {radians(degrees.x), radians(degrees.y), radians(degrees.z)});
    }
}

}  // namespace zerkalo::scene_file
