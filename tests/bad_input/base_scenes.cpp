#include "tests/bad_input/base_scenes.hpp"

#include <algorithm>
#include <iterator>

namespace zerkalo::bad_input {
namespace {

Scene empty_stage() {
    Scene scene;
    scene.image = {64, 48};
    scene.camera = {{0.6, 1.1, 4.5}, {-0.1, -0.15, -1}, {0.1, 1, 0}, 0.75, FovAxis::horizontal};
    scene.ambient = {0.9, 1.0, 0.8};
    scene.background = {0.1, 0.2, 0.3};
    scene.light_count = 1;
    scene.lights[0] = {{-3, 4, 2}, {1, 0.9, 0.8}, 1.2, Falloff::none};
    return scene;
}

Solid solid_of(SolidKind kind, double taper) {
    Solid solid;
    solid.kind = kind;
    solid.position = {0.1, 0.3, 0.2};
    solid.rotation = {0.2, 0.4, -0.3};
    solid.radius = 0.6, solid.height = 1.1, solid.taper = taper;
    solid.sides = 5;
    return solid;
}

Mirror mirror_of(BoundaryShape shape, double curvature_radius, Lobe lobe, double exponent) {
    Mirror mirror;
    mirror.position = {0, 0.9, -1.4};
    mirror.normal = {0.1, 0, 2};
    Boundary& outline = mirror.boundary;
    outline.shape = shape;
    outline.width = 3.5, outline.height = 2.5, outline.radius = 1.5;
    if (shape == BoundaryShape::polygon) {
        const Vec2<double> corners[] = {{-1.5, -1}, {1, -1.2}, {1.6, 0.3}, {-1, 1.1}};
        std::copy(std::begin(corners), std::end(corners), outline.corners);
        outline.corner_count = static_cast<std::int32_t>(std::size(corners));
    }
    mirror.curvature_radius = curvature_radius;
    mirror.lobe = lobe, mirror.lobe_exponent = exponent;
    mirror.color = {0.95, 0.8, 0.45};
    return mirror;
}

Scene scene_with(const Solid& solid, const Mirror& mirror) {
    Scene scene = empty_stage();
    scene.solid_count = scene.mirror_count = 1;
    scene.solids[0] = solid;
    scene.mirrors[0] = mirror;
    return scene;
}

void make_glass(Material& material) {
    material.reflection = 0.3, material.transmission = 0.6;
    material.refractive_index = 1.4;
}

void add_tetrahedron(Scene& scene, Solid& mesh) {
    const Vec3<double> a{0, 0, 0}, b{1, 0.1, 0}, c{0, 0.9, 0.1}, d{0.1, 0, 1};
    const Triangle faces[] = {{a, c, b}, {a, b, d}, {a, d, c}, {b, c, d}};
    mesh.first_triangle = scene.triangle_count;
    mesh.triangle_count = static_cast<std::int32_t>(std::size(faces));
    std::copy(std::begin(faces), std::end(faces), scene.triangles + scene.triangle_count);
    scene.triangle_count += mesh.triangle_count;
}

std::vector<BaseScene> all_small_scenes() {
    constexpr double flat = kInfinity, sharp = kInfinity;
    std::vector<BaseScene> scenes;
    scenes.push_back({"sphere, hollow glossy disc",
                      scene_with(solid_of(SolidKind::sphere, 1), mirror_of(BoundaryShape::disc, 5, Lobe::phong, 60))});
    Scene& sphere = scenes.back().scene;
    make_glass(sphere.solids[0].material);
    sphere.lights[0].falloff = Falloff::inverse_square, sphere.lights[0].intensity = 20;

    scenes.push_back(
        {"prism, bulging sharp ellipse",
         scene_with(solid_of(SolidKind::prism, 1), mirror_of(BoundaryShape::ellipse, -4, Lobe::phong, sharp))});
    scenes.back().scene.solids[0].material.transmission = 0.7;

    scenes.push_back(
        {"pyramid, flat glossy polygon",
         scene_with(solid_of(SolidKind::pyramid, 1), mirror_of(BoundaryShape::polygon, flat, Lobe::max_phong, 200))});
    scenes.back().scene.solids[0].material.reflection = 0.4;

    scenes.push_back(
        {"cylinder, flat glossy rectangle",
         scene_with(solid_of(SolidKind::cylinder, 0.8), mirror_of(BoundaryShape::rectangle, flat, Lobe::phong, 30))});
    scenes.back().scene.camera.fov_axis = FovAxis::vertical;

    scenes.push_back(
        {"cone, hollow sharp polygon",
         scene_with(solid_of(SolidKind::cone, 0), mirror_of(BoundaryShape::polygon, 6, Lobe::max_phong, sharp))});
    scenes.back().scene.mirrors[0].shininess = 40;
    scenes.back().scene.camera.position = {20, 30, 500}, scenes.back().scene.camera.view = {-0.04, -0.06, -1};
    scenes.back().scene.camera.fov = 0.01;

    scenes.push_back(
        {"mesh, flat sharp rectangle",
         scene_with(solid_of(SolidKind::mesh, 1), mirror_of(BoundaryShape::rectangle, flat, Lobe::max_phong, sharp))});
    Scene& mesh = scenes.back().scene;
    add_tetrahedron(mesh, mesh.solids[0]);
    make_glass(mesh.solids[0].material);

    scenes.push_back(
        {"sphere, flat rough disc",
         scene_with(solid_of(SolidKind::sphere, 1), mirror_of(BoundaryShape::disc, flat, Lobe::ggx, 30))});
    return scenes;
}

BaseScene all_in_one() {
    Scene scene = empty_stage();
    scene.light_count = 2;
    scene.lights[1] = {{3, 3, 3}, {0.4, 0.6, 1}, 9, Falloff::inverse_square};
    for (const BaseScene& base : small_scenes()) {
        Solid& solid = scene.solids[scene.solid_count];
        solid = base.scene.solids[0];
        solid.position.x += 1.3 * (scene.solid_count++ - 2.5);
        if (solid.kind == SolidKind::mesh) add_tetrahedron(scene, solid);
        Mirror& mirror = scene.mirrors[scene.mirror_count];
        mirror = base.scene.mirrors[0];
        mirror.position.x += 2.5 * (scene.mirror_count++ - 2.5);
    }
    return {"everything", scene};
}

}  // namespace

const std::vector<BaseScene>& small_scenes() {
    static const std::vector<BaseScene> scenes = all_small_scenes();
    return scenes;
}

const BaseScene& crowded_scene() {
    static const BaseScene scene = all_in_one();
    return scene;
}

}  // namespace zerkalo::bad_input
