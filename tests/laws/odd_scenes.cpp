// See odd_scenes.hpp.
#include "tests/laws/odd_scenes.hpp"

#include "tests/laws/staging.hpp"

#include <cmath>
#include <functional>

namespace zerkalo::laws {
namespace {

/// Five solids before a tinted mirror, two lamps.
Scene plain_scene() {
    Scene scene;
    scene.background = {0.1, 0.15, 0.3};
    add_five_solids(scene, 1);
    add(scene, lamp({-3, 5, 4}));
    add(scene, lamp({2, 4, 5}));
    scene.lights[1].color = {0.6, 0.5, 0.4};
    Mirror mirror = ideal_mirror({0, 1, -1}, {0, 0, 1}, 5);
    mirror.color = {0.95, 0.8, 0.45};
    mirror.ambient = 0.05;
    mirror.diffuse = 0.2;
    mirror.specular = 0.3;
    mirror.shininess = 40;
    mirror.reflection = 0.8;
    add(scene, mirror);
    scene.camera = camera_at({1.2, 2.3, 6}, {-0.2, -0.2, -1}, 0.8);
    return scene;
}

void colour_the_lamps(Scene& scene) {
    const Rgb<double> colours[] = {{1, 0.1, 0.1}, {0.1, 1, 0.1}, {0.1, 0.2, 1}, {1, 1, 0.2}};
    scene.light_count = 0;
    for (int j = 0; j < 4; ++j) {
        Light light = lamp({3.0 * j - 4.5, 4.0 + j % 2, 3.5});
        light.color = colours[j];
        light.intensity = j % 2 ? 12 : 0.5;
        light.falloff = j % 2 ? Falloff::inverse_square : Falloff::none;
        add(scene, light);
    }
}

void make_glass_that_also_reflects(Scene& scene) {
    Material glass = clear_glass(1.5);
    glass.reflection = 0.3;
    glass.transmission = 0.6;
    glass.diffuse = glass.ambient = 0.1;
    scene.solids[0].material = scene.solids[2].material = glass;
    scene.solids[4].material.reflection = 0.4;
}

void make_fresnel_glass(Scene& scene) {
    make_glass_that_also_reflects(scene);
    scene.solids[0].material.fresnel = scene.solids[2].material.fresnel = true;
    scene.solids[3].material = clear_glass(2.4);
    scene.solids[3].material.fresnel = true;
}

void curve(Scene& scene, double radius, BoundaryShape shape) {
    Mirror& mirror = scene.mirrors[0];
    mirror.curvature_radius = radius;
    mirror.boundary.shape = shape;
    mirror.boundary.width = 5;
    mirror.boundary.height = 3;
    mirror.boundary.radius = 2.25;
}

void cut_a_polygon(Scene& scene) {
    Boundary& boundary = scene.mirrors[0].boundary;
    boundary.shape = BoundaryShape::polygon;
    const Vec2<double> corners[] = {{-2.5, -1.5}, {1.5, -2}, {2.5, 0}, {1.0, 2.25}, {-2, 1.5}};
    boundary.corner_count = 0;
    for (const Vec2<double>& corner : corners) boundary.corners[boundary.corner_count++] = corner;
}

void put_camera_into_glass(Scene& scene) {
    Solid shell = ball(scene.camera.position, 0.5, clear_glass(1.3));
    shell.position.x += 0.125;
    add(scene, shell);
}

void put_camera_into_wood(Scene& scene) {
    Solid shell = box({1.2, 1.8, 6}, 1, 1, Material{});
    add(scene, shell);
}

void put_lamp_into_solid(Scene& scene) { scene.lights[0].position = scene.solids[0].position; }

void look_from_behind(Scene& scene) { scene.camera = camera_at({-1, 2.5, -7}, {0.1, -0.15, 1}, 0.8); }

void step_back_a_million(Scene& scene) {
    constexpr double kFar = 6e6;
    scene.camera = camera_at({0.2 * kFar, 1 + 0.25 * kFar, kFar}, {-0.2, -0.25, -1}, 6 / kFar);
}

void move_lamp_far_away(Scene& scene) { scene.lights[0].position = {-3e6, 5e6, 4e6}; }

void pierce_solids(Scene& scene) { scene.mirrors[0].position.z = 1.25; }

void widen_the_tubes(Scene& scene) {
    scene.solids[1].taper = 1.75;
    scene.solids[4].kind = SolidKind::cone;
    scene.solids[4].taper = 3;
    scene.solids[4].rotation = {2.5, 0.5, -1};
    scene.solids[2].sides = 64;
    scene.solids[2].rotation = {1, 2, 3};
}

void face_a_second_mirror(Scene& scene) {
    Mirror mirror = ideal_mirror({0, 1.5, 9}, {-0.1, 0.05, -1}, 6);
    mirror.color = {0.6, 0.9, 0.7};
    mirror.reflection = 0.9;
    add(scene, mirror);
}

void hang_up_eight_mirrors(Scene& scene) {
    while (scene.mirror_count < kMaxMirrors) {
        const double angle = 0.9 * scene.mirror_count;
        Mirror mirror = ideal_mirror({4 * std::sin(angle), 1, 1 + 4 * std::cos(angle)},
                                     {-std::sin(angle), 0.1, -std::cos(angle)}, 1.5);
        mirror.curvature_radius = scene.mirror_count % 2 ? 5 : -4;
        mirror.diffuse = 0.2;
        add(scene, mirror);
    }
}

std::vector<OddScene> all_odd_scenes() {
    struct Change {
        const char* name;
        std::function<void(Scene&)> make;
        int depth_limit;
    };
    const Change changes[] = {
        {"four-coloured-lamps", colour_the_lamps, 6},
        {"branching-glass", make_glass_that_also_reflects, 6},
        {"fresnel-glass", make_fresnel_glass, 6},
        {"concave-ellipse", [](Scene& s) { curve(s, 7, BoundaryShape::ellipse); }, 6},
        {"convex-rectangle", [](Scene& s) { curve(s, -6, BoundaryShape::rectangle); }, 6},
        {"deep-dish", [](Scene& s) { curve(s, 2.3, BoundaryShape::disc); }, 6},
        {"polygon", cut_a_polygon, 6},
        {"camera-in-glass", put_camera_into_glass, 6},
        {"camera-in-wood", put_camera_into_wood, 6},
        {"lamp-in-solid", put_lamp_into_solid, 6},
        {"back-of-the-mirror", look_from_behind, 6},
        {"far-camera", step_back_a_million, 6},
        {"far-lamp", move_lamp_far_away, 6},
        {"pierced-mirror", pierce_solids, 6},
        {"wide-tubes", widen_the_tubes, 6},
        {"facing-depth-0", face_a_second_mirror, 0},
        {"facing-depth-1", face_a_second_mirror, 1},
        {"facing-depth-2", face_a_second_mirror, 2},
        {"facing-depth-6", face_a_second_mirror, 6},
        {"eight-mirrors", hang_up_eight_mirrors, 6},
    };
    std::vector<OddScene> scenes;
    for (const Change& change : changes) {
        OddScene odd{change.name, plain_scene(), {}};
        odd.settings.width = 96;
        odd.settings.height = 72;
        odd.settings.depth_limit = change.depth_limit;
        change.make(odd.scene);
        scenes.push_back(odd);
    }
    return scenes;
}

}  // namespace

const std::vector<OddScene>& odd_scenes() {
    static const std::vector<OddScene> scenes = all_odd_scenes();
    return scenes;
}

}  // namespace zerkalo::laws
