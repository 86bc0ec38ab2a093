// A sharp plane mirror is a window on the mirrored scene.
#include "tests/reference/scenes.hpp"

#include <gtest/gtest.h>

namespace zerkalo::reference {
namespace {

Scene before_the_mirror() {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    scene.camera.position = {0.5, 3.4, 4};
    scene.camera.view = {-0.12, -0.8, -1};
    scene.camera.fov = 0.8;
    scene.image = {80, 60};
    const SolidKind kinds[] = {SolidKind::sphere, SolidKind::cone, SolidKind::prism, SolidKind::pyramid};
    for (int i = 0; i < 4; ++i) {
        Solid solid;
        solid.kind = kinds[i];
        solid.taper = 0.3;
        solid.radius = 0.5;
        solid.position = {-1.5 + i, 0.3 * i, 0.9 + 0.2 * i};
        solid.rotation = {0.3 * i, 0.5, -0.2 * i};
        add(scene, solid);
    }
    add(scene, lamp({-2, 5, 4}));
    return scene;
}

/// z -> -z. Turns about x and y change their sense; every solid is its own mirror image in its local z.
Scene behind_the_mirror(Scene scene) {
    for (int i = 0; i < scene.solid_count; ++i) {
        Solid& solid = scene.solids[i];
        solid.position.z = -solid.position.z;
        solid.rotation.x = -solid.rotation.x;
        solid.rotation.y = -solid.rotation.y;
    }
    scene.lights[0].position.z = -scene.lights[0].position.z;
    return scene;
}

TEST(ReferencePlaneMirror, ImageIsTheMirroredSceneSeenDirectly) {
    Scene real = before_the_mirror();
    const Scene image = behind_the_mirror(real);
    Mirror mirror = ideal_mirror(1e6);
    mirror.color = {1, 0.5, 0.25};
    add(real, mirror);

    const World world(real), window(image);
    int in_mirror = 0, of_solids = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            const Ray ray = camera_ray(real.camera, 80, 60, x, y);
            if (world.first_hit(ray).kind != HitKind::mirror) continue;
            ++in_mirror;
            of_solids += window.first_hit(ray).kind == HitKind::solid;
            const Color seen = look(real, ray.origin, ray.direction);
            const Color direct = times({1, 0.5, 0.25}, look(image, ray.origin, ray.direction));
            EXPECT_LT(length(seen - direct), 1e-9) << "pixel " << x << ", " << y;
        }
    EXPECT_GT(in_mirror, 2000);
    EXPECT_GT(of_solids, 200);
}

TEST(ReferencePlaneMirror, PictureIsPixelByPixelThePixelFunction) {
    Scene scene = before_the_mirror();
    Mirror mirror = ideal_mirror(3);
    mirror.lobe_exponent = 30;
    add(scene, mirror);
    Settings settings;
    settings.width = 20;
    settings.height = 12;
    const Picture picture = reference_picture(scene, settings, 3, kSeed);
    ASSERT_EQ(picture.pixels.size(), 240u);
    int as_before = 0;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 20; ++x) {
            const Rgb<double> pixel = reference_pixel(scene, settings, x, y, 3, kSeed), &same = picture.at(x, y);
            EXPECT_TRUE(pixel.r == same.r && pixel.g == same.g && pixel.b == same.b) << x << ", " << y;
            for (const std::uint64_t seed : {kSeed + 1, kSeed + (std::uint64_t{1} << 40)})
                as_before += reference_pixel(scene, settings, x, y, 3, seed).r == same.r;
        }
    // Pixels that see no glossy mirror do not depend on the seed; most of them do see it.
    EXPECT_LT(as_before, 240);
}

TEST(ReferencePlaneMirror, SettingsWithoutASizeTakeThatOfTheScene) {
    Scene scene = before_the_mirror();
    const Picture picture = reference_picture(scene, Settings{}, 1, kSeed);
    EXPECT_EQ(picture.width, 80);
    EXPECT_EQ(picture.height, 60);
    Settings settings;
    settings.width = 80;
    settings.height = 60;
    EXPECT_EQ(compare(picture, reference_picture(scene, settings, 1, kSeed), 0).max, 0);
}

}  // namespace
}  // namespace zerkalo::reference
