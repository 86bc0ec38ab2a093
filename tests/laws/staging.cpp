// See staging.hpp.
#include "tests/laws/staging.hpp"

#include <memory>
#include <stdexcept>
#include <string>

namespace zerkalo::laws {

Solid box(const Vec3<double>& base_centre, double side, double height, const Material& material) {
    Solid solid;
    solid.kind = SolidKind::prism;
    solid.sides = 4;
    solid.position = base_centre;
    solid.rotation = {0, kPi / 4, 0};
    solid.radius = side / std::numbers::sqrt2;
    solid.height = height;
    solid.material = material;
    return solid;
}

void add_five_solids(Scene& scene, double z) {
    const SolidKind kinds[] = {SolidKind::sphere, SolidKind::cone, SolidKind::prism, SolidKind::pyramid,
                               SolidKind::cylinder};
    for (int i = 0; i < 5; ++i) {
        Solid solid;
        solid.kind = kinds[i];
        solid.taper = kinds[i] == SolidKind::cone ? 0.25 : 1;
        solid.sides = 3 + i;
        solid.radius = 0.5;
        solid.height = 0.75;
        solid.position = {-2.0 + i, 1 + 0.25 * (i % 3), z + 0.375 * (i % 2)};
        solid.rotation = {0.3 * i, 0.5 - 0.2 * i, -0.25 * i};
        solid.material.color = {0.25 + 0.125 * i, 0.875 - 0.125 * i, 0.5};
        add(scene, solid);
    }
}

Scene simple_scene() {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    add_five_solids(scene, 1);
    add(scene, lamp({-3, 5, 4}));
    add(scene, ideal_mirror({0, 1, -1}, {0, 0, 1}, 4));
    scene.mirrors[0].diffuse = 0.25;
    scene.camera = camera_at({0.7, 2.1, 6}, {-0.1, -0.15, -1}, 0.8);
    return scene;
}

Scene five_solids_before_mirror_aslant(double curvature_radius) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    add_five_solids(scene, 1);
    add(scene, lamp({-3, 5, 4}));
    add(scene, lamp({1, 3, 6}));
    Mirror mirror = ideal_mirror({0.25, 1, -1}, {0.125, 0, 1}, 4);
    mirror.curvature_radius = curvature_radius;
    mirror.diffuse = 0.25;
    mirror.specular = 0.5;
    mirror.shininess = 20;
    add(scene, mirror);
    scene.camera = camera_at({0.7, 2.1, 6}, {-0.1, -0.15, -1}, 0.8);
    return scene;
}

Rgb<float> look(Scene scene, const Vec3<double>& origin, const Vec3<double>& view, const Settings& settings) {
    constexpr double kAnyAngle = 0.1;  // the centre of the only pixel lies on the axis
    scene.camera = camera_at(origin, view, kAnyAngle);
    Settings one_pixel = settings;
    one_pixel.width = one_pixel.height = 1;
    const auto plan = std::make_unique<Plan>();
    prepare_or_throw(scene, one_pixel, *plan);
    const Image seen = render(*plan, Isa::scalar);
    for (const Isa isa : available_isas()) {
        if (render(*plan, isa).hash() != seen.hash()) {
            throw std::runtime_error(std::string(name_of(isa)) + " and scalar see different light");
        }
    }
    return seen.at(0, 0);
}

}  // namespace zerkalo::laws
