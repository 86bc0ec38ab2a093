// No length is special: a scene that is larger by a power of two gives the same bytes.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::laws {
namespace {

Vec3<double> times(double s, const Vec3<double>& v) { return {s * v.x, s * v.y, s * v.z}; }

/// Every length times s; lamps that fade keep their irradiance.
Scene larger(Scene scene, double s) {
    scene.camera.position = times(s, scene.camera.position);
    for (int k = 0; k < scene.solid_count; ++k) {
        Solid& solid = scene.solids[k];
        solid.position = times(s, solid.position);
        solid.radius *= s;
        solid.height *= s;
        solid.scale *= s;
    }
    for (int m = 0; m < scene.mirror_count; ++m) {
        Mirror& mirror = scene.mirrors[m];
        mirror.position = times(s, mirror.position);
        mirror.boundary.width *= s;
        mirror.boundary.height *= s;
        mirror.boundary.radius *= s;
        mirror.curvature_radius *= s;
    }
    for (int j = 0; j < scene.light_count; ++j) {
        scene.lights[j].position = times(s, scene.lights[j].position);
        if (scene.lights[j].falloff == Falloff::inverse_square) scene.lights[j].intensity *= s * s;
    }
    return scene;
}

/// Glass, a hollow mirror, a mesh, two lamps of which one fades.
Scene rich_scene() {
    Scene scene = simple_scene();
    scene.solids[0].material = clear_glass(1.5);
    scene.solids[0].material.reflection = 0.25;
    scene.solids[0].material.transmission = 0.75;
    scene.mirrors[0].curvature_radius = 8;
    const Vec3<double> a{0, 0, 0}, b{0.5, 0, 0}, c{0, 0.5, 0}, d{0, 0, 0.5};
    const Triangle faces[] = {{a, c, b}, {a, b, d}, {a, d, c}, {b, c, d}};
    for (const Triangle& face : faces) scene.triangles[scene.triangle_count++] = face;
    Solid mesh;
    mesh.kind = SolidKind::mesh;
    mesh.position = {0, 2, 1};
    mesh.triangle_count = 4;
    add(scene, mesh);
    Light fading = lamp({3, 4, 3});
    fading.falloff = Falloff::inverse_square;
    fading.intensity = 12;
    add(scene, fading);
    return scene;
}

void expect_same_bytes_at_every_size(const Scene& scene, const Settings& settings) {
    const Image image = render(scene, settings), in_double = render_double(scene, settings);
    for (const int exponent : {-40, -23, -1, 1, 7, 40}) {
        const Scene other = larger(scene, std::ldexp(1, exponent));
        EXPECT_EQ(pixels_apart(image, render(other, settings)), 0) << "2^" << exponent;
        EXPECT_EQ(pixels_apart(in_double, render_double(other, settings)), 0) << "in double, 2^" << exponent;
    }
}

TEST(Scaling, PowersOfTwoLeaveEveryByteOfAPolishedMirror) {
    expect_same_bytes_at_every_size(simple_scene(), of_size(64, 48));
}

TEST(Scaling, PowersOfTwoLeaveEveryByteOfAnUnpolishedMirror) {
    for (const Lobe lobe : {Lobe::phong, Lobe::max_phong}) {
        Scene scene = simple_scene();
        scene.mirrors[0].lobe_exponent = 40;
        scene.mirrors[0].lobe = lobe;
        expect_same_bytes_at_every_size(scene, of_size(64, 48));
    }
}

TEST(Scaling, PowersOfTwoLeaveEveryByteOfGlassMeshesAndHollowMirrors) {
    expect_same_bytes_at_every_size(rich_scene(), of_size(64, 48));
}

TEST(P14, DoublingEveryDistanceQuartersTheLightOfLampsThatFade) {
    Scene scene = simple_scene();
    scene.background = {0, 0, 0};
    scene.ambient = {0, 0, 0};
    scene.lights[0].falloff = Falloff::inverse_square;
    scene.lights[0].intensity = 16;
    Scene twice = larger(scene, 2);
    twice.lights[0].intensity = 16;
    const Image near = render(scene, of_size(64, 48)), far = render(twice, of_size(64, 48));
    EXPECT_EQ(pixels_apart(scaled(near, 0.25f), far), 0);
    EXPECT_GT(largest_difference(near, far), 0.01);
}

}  // namespace
}  // namespace zerkalo::laws
