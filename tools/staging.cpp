#include "tools/staging.hpp"

namespace zerkalo::staging {

Material glowing(const Rgb<double>& color) {
    Material material;
    material.color = color;
    material.ambient = 1;
    material.diffuse = material.specular = 0;
    return material;
}

Material chalk() {
    Material material;
    material.color = {1, 1, 1};
    material.diffuse = 1;
    material.ambient = material.specular = 0;
    return material;
}

Material clear_glass(double refractive_index) {
    Material material;
    material.ambient = material.diffuse = material.specular = 0;
    material.transmission = 1;
    material.refractive_index = refractive_index;
    return material;
}

Solid ball(const Vec3<double>& centre, double radius, const Material& material) {
    Solid solid;
    solid.position = centre;
    solid.radius = radius;
    solid.material = material;
    return solid;
}

Solid upright(SolidKind kind, const Vec3<double>& base, double radius, double height, const Material& material) {
    Solid solid = ball(base, radius, material);
    solid.kind = kind;
    solid.height = height;
    solid.taper = kind == SolidKind::cone ? 0 : 1;
    return solid;
}

Light lamp(const Vec3<double>& position) {
    Light light;
    light.position = position;
    return light;
}

Mirror ideal_mirror(const Vec3<double>& position, const Vec3<double>& normal, double side) {
    Mirror mirror;
    mirror.position = position;
    mirror.normal = normal;
    mirror.boundary.width = mirror.boundary.height = side;
    mirror.ambient = mirror.diffuse = mirror.specular = 0;
    mirror.reflection = 1;
    return mirror;
}

Camera camera_at(const Vec3<double>& position, const Vec3<double>& view, double fov) {
    Camera camera;
    camera.position = position;
    camera.view = view;
    camera.fov = fov;
    return camera;
}

void add(Scene& scene, const Solid& solid) { scene.solids[scene.solid_count++] = solid; }
void add(Scene& scene, const Light& light) { scene.lights[scene.light_count++] = light; }
void add(Scene& scene, const Mirror& mirror) { scene.mirrors[scene.mirror_count++] = mirror; }

}  // namespace zerkalo::staging
