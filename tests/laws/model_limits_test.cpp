// What Whitted's model leaves out of nature, one test a sentence of core/README.md: should one fail, the model has
// grown and the sentence must go.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::laws {
namespace {

/// A floor of chalk at y = 0 under a lamp at (0, 4, 0); nothing glows by itself.
Scene lit_floor() {
    Scene scene;
    scene.ambient = {0, 0, 0};
    add(scene, box({0, -1, 0}, 64, 1, chalk()));
    add(scene, lamp({0, 4, 0}));
    return scene;
}

float floor_at(const Scene& scene, double x, double z) { return look(scene, {x, 3, 8}, {0, -3, z - 8}).g; }

TEST(WhittedsModel, AMirrorLightsNothing) {
    Scene scene = lit_floor();
    const float without = floor_at(scene, 1, 0);
    // The lamp's image is at (6, 4, 0); its way to (1, 0, 0) crosses the mirror's plane at height 1.6.
    add(scene, ideal_mirror({3, 2, 0}, {-1, 0, 0}, 3));
    EXPECT_EQ(look(scene, {1, 1e-3, 0}, {2, 1.6, 0}).g, 0) << "the mirror itself shows what it reflects: black";
    add(scene, ball({0, 4, 0}, 0.1, glowing({1, 1, 1})));
    scene.light_count = 0;
    scene.ambient = {1, 1, 1};
    EXPECT_EQ(look(scene, {1, 1e-3, 0}, {2, 1.6, 0}).g, 1) << "from the floor the lamp's place is seen in the mirror";
    scene.light_count = 1;
    scene.ambient = {0, 0, 0};
    scene.solid_count = 1;
    // In nature the point would get light from both, 4/sqrt(17) and 4/sqrt(41) of it.
    EXPECT_EQ(floor_at(scene, 1, 0), without);
    EXPECT_NEAR(without, 4 / std::sqrt(17.0), 1e-6);
}

TEST(WhittedsModel, GlassThrowsTheShadowOfStone) {
    Scene scene = lit_floor();
    add(scene, ball({0, 2, 0}, 0.5, clear_glass(1.5)));
    // Nature has a bright spot here, the lamp's light gathered by the ball.
    EXPECT_EQ(floor_at(scene, 0, 0), 0);
    scene.solids[1].material.fresnel = true;
    EXPECT_EQ(floor_at(scene, 0, 0), 0);
    scene.solid_count = 1;
    EXPECT_EQ(floor_at(scene, 0, 0), 1);
}

TEST(WhittedsModel, AmbientLightComesThroughARoof) {
    Scene scene = lit_floor();
    scene.light_count = 0;
    scene.ambient = {1, 1, 1};
    scene.solids[0].material.ambient = 0.5;
    const float open = floor_at(scene, 0, 0);
    // A roof a hair above the floor's point, far beyond the camera's sight line on every other side.
    add(scene, box({0, 0.01, -15.5}, 31, 1, chalk()));
    EXPECT_EQ(floor_at(scene, 0, 0.01), open);
    EXPECT_EQ(open, 0.5f);
}

TEST(WhittedsModel, AWallLendsItsColourToNothing) {
    Scene scene = lit_floor();
    const Rgb<float> alone = look(scene, {2, 3, 8}, {0, -3, -8});
    Material red = chalk();
    red.color = {1, 0, 0};
    // Lit by the lamp, a yard from the point, and not in the way of its light.
    add(scene, box({4, 0, 0}, 2, 3, red));
    const Rgb<float> beside = look(scene, {2, 3, 8}, {0, -3, -8});
    EXPECT_GT(look(scene, {0, 1, 0}, {1, 0, 0}).r, 0.1f) << "the wall is lit";
    EXPECT_EQ(beside.r, alone.r);
    EXPECT_EQ(beside.g, alone.g);
}

/// How much of the white surroundings a black solid shows where the ray meets it at `angle`.
float reflected_at(double angle, const Material& material) {
    Scene scene;
    scene.background = {1, 1, 1};
    add(scene, box({0, -8, 0}, 16, 8, material));
    Settings one_reflection;
    one_reflection.depth_limit = 1;
    return look(scene, {-3 * std::sin(angle), 3 * std::cos(angle), 0}, {std::sin(angle), -std::cos(angle), 0},
                one_reflection)
        .g;
}

TEST(WhittedsModel, ReflectsAConstantShareUnlessFresnelIsAskedFor) {
    Material plain = clear_glass(1.5);
    plain.reflection = 0.25;
    plain.transmission = 0.75;
    Material physical = clear_glass(1.5);
    physical.fresnel = true;
    for (const double angle : {0.0, 0.5, 1.0, 1.5}) {
        // Of the transmitted ray nothing arrives: inside everything is black within one step.
        EXPECT_EQ(reflected_at(angle, plain), 0.25f) << angle;
    }
    EXPECT_NEAR(reflected_at(0, physical), 0.04, 1e-7);
    EXPECT_LT(reflected_at(1, physical), 0.1);
    EXPECT_GT(reflected_at(1.5, physical), 0.6);
}

}  // namespace
}  // namespace zerkalo::laws
