// What a light adds, and where it adds nothing, not even a highlight: behind a surface (which formulas 1.3 and 1.4 of
// the course work leave out), on the back of a mirror, behind one. In the special kernels and in the general one.
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

/// A mirror with a very broad highlight, its lamp and the camera before it.
Scene shining_mirror() {
    Scene scene;
    Mirror mirror = ideal_mirror({0, 0, 0}, {0, 0, 1}, 2);
    mirror.specular = 1;
    mirror.shininess = 1;
    add(scene, mirror);
    add(scene, lamp({1, 0, 10}));
    scene.camera = camera_at({0, 0, 10}, {0, 0, -1}, 0.25);
    return scene;
}

TEST(Highlight, OnAMirrorHasTheColourOfTheMirror) {
    const Scene alone = shining_mirror();
    for (const Scene& white : {alone, with_two_mirrors_elsewhere(alone)}) {
        Scene tinted = white;
        tinted.mirrors[0].color = {1, 0.5, 0.25};
        const Image plain = render(white, of_size(32, 32)), golden = render(tinted, of_size(32, 32));
        EXPECT_GT(plain.at(16, 16).g, 0.5);
        for (std::size_t k = 0; k < plain.rgb.size(); ++k) {
            const float tint = k % 3 == 0 ? 1.0f : k % 3 == 1 ? 0.5f : 0.25f;
            ASSERT_EQ(golden.rgb[k], plain.rgb[k] * tint) << "value " << k << ", " << white.mirror_count << " mirrors";
        }
    }
}

TEST(Highlight, IsNotSeenOnTheBackOfAMirror) {
    const Scene alone = shining_mirror();
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

TEST(Mirror, BackReflectsNothing) {
    Scene alone;
    add(alone, ideal_mirror({0, 0, 0}, {0, 0, -1}, 2));
    add(alone, ball({0, 0, 20}, 4, glowing({1, 1, 1})));
    alone.camera = camera_at({0, 0, 10}, {0, 0, -1}, 0.25);
    for (const Scene& back : {alone, with_two_mirrors_elsewhere(alone)}) {
        Scene front = back;
        front.mirrors[0].normal = {0, 0, 1};
        Scene empty = back;
        empty.solid_count = 0;
        const Image unlit = render(empty, of_size(64, 64));
        EXPECT_EQ(pixels_apart(render(back, of_size(64, 64)), unlit), 0) << back.mirror_count << " mirrors";
        EXPECT_GT(pixels_apart(render(front, of_size(64, 64)), unlit), 100) << "the front reflects the ball";
    }
}

/// What a slanting glance at the middle of a chalk floor under these lamps shows.
Rgb<float> floor_below(const Scene& lamps) {
    Scene scene = lamps;
    scene.ambient = {0, 0, 0};
    add(scene, box({0, -1, 0}, 64, 1, chalk()));
    return look(scene, {0, 3, 8}, {0, -3, -8});
}

TEST(Lamp, LightsWithItsColourTimesItsIntensity) {
    Scene alone;
    add(alone, lamp({0, 4, 0}));
    alone.lights[0].color = {1, 0.5, 0.25};
    alone.lights[0].intensity = 3;
    for (const Scene& scene : {alone, with_two_mirrors_elsewhere(alone)}) {
        const Rgb<float> seen = floor_below(scene);
        EXPECT_FLOAT_EQ(seen.r, 3) << scene.mirror_count << " mirrors";
        EXPECT_FLOAT_EQ(seen.g, 1.5) << scene.mirror_count << " mirrors";
        EXPECT_FLOAT_EQ(seen.b, 0.75) << scene.mirror_count << " mirrors";
    }
}

TEST(Lamp, AddsToTheOthers) {
    Scene alone;
    for (const double side : {-3.0, 3.0, 3.0}) add(alone, lamp({side, 4, 0}));
    for (const Scene& scene : {alone, with_two_mirrors_elsewhere(alone)}) {
        // Three times the cosine of the triangle with sides 3, 4, 5.
        EXPECT_FLOAT_EQ(floor_below(scene).g, 2.4f) << scene.mirror_count << " mirrors";
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
