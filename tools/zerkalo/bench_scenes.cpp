#include "tools/zerkalo/bench_scenes.hpp"

#include <cmath>

namespace zerkalo {
namespace {

constexpr ImageSize kKernelImage{128, 128};

// A closed unit octahedron.
void add_octahedron(Scene& scene, Solid& solid) {
    solid.first_triangle = scene.triangle_count;
    solid.triangle_count = 8;
    for (int octant = 0; octant < 8; ++octant) {
        const double x = octant & 1 ? -1 : 1, y = octant & 2 ? -1 : 1, z = octant & 4 ? -1 : 1;
        const bool mirrored = x * y * z < 0;
        const Vec3<double> a{x, 0, 0}, b{0, y, 0}, c{0, 0, z};
        scene.triangles[scene.triangle_count++] = mirrored ? Triangle{a, c, b} : Triangle{a, b, c};
    }
}

Solid& add_solid(Scene& scene, SolidKind kind, Vec3<double> position) {
    Solid& solid = scene.solids[scene.solid_count++];
    solid.kind = kind;
    solid.position = position;
    solid.sides = kind == SolidKind::prism ? 6 : 4;
    solid.taper = kind == SolidKind::cone ? 0 : 1;
    if (kind == SolidKind::mesh) add_octahedron(scene, solid);
    return solid;
}

void add_mirror(Scene& scene, Vec3<double> position, double width, double height, double lobe_exponent) {
    Mirror& mirror = scene.mirrors[scene.mirror_count++];
    mirror.position = position;
    mirror.boundary.width = width;
    mirror.boundary.height = height;
    mirror.lobe_exponent = lobe_exponent;
    mirror.color = {0.95, 0.80, 0.45};
}

}  // namespace

std::unique_ptr<Scene> solid_scene(SolidKind kind) {
    auto scene = std::make_unique<Scene>();
    scene->image = kKernelImage;
    // Low and close on the slanted side, so that base, side and edge are asked but nothing is missed.
    scene->camera.position = {0.3, 0.35, 4};
    scene->camera.view = {-0.3, 0, -4};
    scene->camera.fov = 0.1;
    const bool centred = kind == SolidKind::sphere || kind == SolidKind::mesh;
    add_solid(*scene, kind, {0, centred ? 0.35 : 0, 0});
    return scene;
}

std::unique_ptr<Scene> shadow_scene() {
    auto scene = solid_scene(SolidKind::sphere);
    scene->light_count = 1;
    scene->lights[0].position = {2, 3, 5};
    return scene;
}

std::unique_ptr<Scene> mirror_scene(double lobe_exponent) {
    auto scene = std::make_unique<Scene>();
    scene->image = kKernelImage;
    scene->camera.position = {0, 0, 2};
    scene->camera.view = {0.5, 0, -1};
    add_mirror(*scene, {0, 0, 0}, 20, 20, lobe_exponent);
    // Where the middle of the view is reflected to.
    add_solid(*scene, SolidKind::sphere, {3, 0, 4}).radius = 2;
    return scene;
}

std::unique_ptr<Scene> ordinary_scene() {
    constexpr SolidKind kRow[] = {SolidKind::pyramid, SolidKind::prism, SolidKind::sphere, SolidKind::cylinder,
                                  SolidKind::cone};
    auto scene = std::make_unique<Scene>();
    scene->camera.position = {1.2, 2.3, 5.2};
    scene->camera.view = {-1.2, -1.5, -5.8};
    scene->background = {0.02, 0.03, 0.12};
    scene->light_count = 1;
    scene->lights[0].position = {-3, 4, 2};
    double x = -1.6;
    for (const SolidKind kind : kRow) {
        Solid& solid = add_solid(*scene, kind, {x, kind == SolidKind::sphere ? 0.4 : 0.0, x * x / 4});
        solid.radius = 0.4;
        x += 0.8;
    }
    add_mirror(*scene, {0, 1.25, -1.6}, 4, 2.5, 200);
    return scene;
}

}  // namespace zerkalo
