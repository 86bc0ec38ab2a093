// Light from behind a surface adds nothing, not even a highlight (what the course work's formulas 1.3, 1.4 leave out).
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

namespace zerkalo::laws {
namespace {

/// A ball with a very broad highlight and nothing else, its lamp behind it, the camera before it.
Scene ball_before_its_lamp() {
    Scene scene;
    Material material = chalk();
    material.diffuse = 0;
    material.specular = 1;
    material.shininess = 1;
    add(scene, ball({0, 0, 0}, 1, material));
    add(scene, lamp({0.5, 0, -10}));
    scene.camera = camera_at({0, 0, 10}, {0, 0, -1}, 0.25);
    return scene;
}

/// The same in the general kernel, which a second mirror asks for, far away from everything.
Scene with_two_mirrors_elsewhere(Scene scene) {
    for (const double x : {-300.0, 300.0}) add(scene, ideal_mirror({x, 0, 40}, {0, 1, 0}, 1));
    return scene;
}

TEST(Highlight, IsNotSeenWhereTheLightIsBehindTheSurface) {
    const Scene alone = ball_before_its_lamp();
    for (const Scene& scene : {alone, with_two_mirrors_elsewhere(alone)}) {
        Scene dark = scene;
        dark.light_count = 0;
        const Image image = render(scene, of_size(64, 64));
        EXPECT_EQ(pixels_apart(image, render(dark, of_size(64, 64))), 0) << scene.mirror_count << " mirrors";
        Scene before = scene;
        before.lights[0].position.z = 10;
        EXPECT_GT(pixels_apart(image, render(before, of_size(64, 64))), 1000) << "the same lamp before it shows";
    }
}

}  // namespace
}  // namespace zerkalo::laws
