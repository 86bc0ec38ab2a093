// Where a light adds nothing, not even a highlight: behind a surface (which the course work's formulas 1.3 and 1.4
// leave out), and on the back of a mirror.
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

TEST(Highlight, IsNotSeenOnTheBackOfAMirror) {
    Scene alone;
    Mirror mirror = ideal_mirror({0, 0, 0}, {0, 0, 1}, 2);
    mirror.specular = 1;
    mirror.shininess = 1;
    add(alone, mirror);
    add(alone, lamp({1, 0, 10}));
    alone.camera = camera_at({0, 0, 10}, {0, 0, -1}, 0.25);
    for (const Scene& front : {alone, with_two_mirrors_elsewhere(alone)}) {
        Scene back = front;
        back.mirrors[0].normal = {0, 0, -1};
        Scene dark = back;
        dark.light_count = 0;
        const Image unlit = render(dark, of_size(64, 64));
        EXPECT_EQ(pixels_apart(render(back, of_size(64, 64)), unlit), 0) << front.mirror_count << " mirrors";
        EXPECT_GT(pixels_apart(render(front, of_size(64, 64)), unlit), 1000) << "the front shines";
    }
}

// A lamp at height 4 over a floor, a mirror of half-width 1 half-way: a shadow twice as wide, whichever side is up.
TEST(Shadow, OfAMirrorIsThatOfItsOutline) {
    for (const double up : {-1.0, 1.0}) {
        Scene alone;
        alone.ambient = {0, 0, 0};
        add(alone, box({0, -1, 0}, 64, 1, chalk()));
        add(alone, lamp({0, 4, 0}));
        add(alone, ideal_mirror({0, 2, 0}, {0, up, 0}, 2));
        for (const Scene& scene : {alone, with_two_mirrors_elsewhere(alone)}) {
            const auto dark = [&](double x) { return look(scene, {x, 3, 8}, {0, -3, -8}).g == 0; };
            constexpr double kFloatLengths = 1e-6;
            EXPECT_NEAR(where_it_ends(0, 10, dark), 2, kFloatLengths) << scene.mirror_count << " mirrors, up " << up;
        }
    }
}

}  // namespace
}  // namespace zerkalo::laws
