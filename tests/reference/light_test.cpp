// Local light: Lambert, falloff, highlight, shadows of every kind of object.
#include "tests/reference/scenes.hpp"

#include <gtest/gtest.h>

namespace zerkalo::reference {
namespace {

/// The cap of a wide cylinder, at y = 0.
Solid floor_with(double diffuse, double specular) {
    Solid solid;
    solid.kind = SolidKind::cylinder;
    solid.position = {0, -1, 0};
    solid.radius = 50;
    solid.material = glowing({1, 1, 1});
    solid.material.ambient = 0;
    solid.material.diffuse = diffuse;
    solid.material.specular = specular;
    return solid;
}

double floor_at(const Scene& scene, double x) { return look(scene, {x, 1e-3, 0.5}, {0, -1e-3, -0.5}).x; }

TEST(ReferenceLight, FloorUnderALampFollowsLambertAndTheInverseSquare) {
    Scene scene;
    add(scene, floor_with(0.5, 0));
    Light light = lamp({0, 2, 0});
    light.intensity = 3;
    add(scene, light);
    for (const double x : {0.0, 1.0, 7.0}) {
        const double distance = std::hypot(x, 2.0);
        scene.lights[0].falloff = Falloff::none;
        EXPECT_NEAR(floor_at(scene, x), 0.5 * 3 * 2 / distance, 1e-12) << x;
        scene.lights[0].falloff = Falloff::inverse_square;
        EXPECT_NEAR(floor_at(scene, x), 0.5 * 3 * 2 / std::pow(distance, 3), 1e-12) << x;
    }
}

TEST(ReferenceLight, SphereCastsAShadowOfTheClosedFormRadius) {
    constexpr double kLamp = 5, kHeight = 2, kRadius = 0.7;
    Scene scene;
    add(scene, floor_with(1, 0));
    add(scene, ball({0, kHeight, 0}, kRadius));
    add(scene, lamp({0, kLamp, 0}));
    double dark = 0, lit = 10;
    while (lit - dark > 1e-9) {
        const double middle = (dark + lit) / 2;
        (floor_at(scene, middle) == 0 ? dark : lit) = middle;
    }
    const double gap = kLamp - kHeight;
    EXPECT_NEAR(lit, kLamp * kRadius / std::sqrt(gap * gap - kRadius * kRadius), 1e-8);
}

TEST(ReferenceLight, HighlightIsThePowerOfTheCosineToTheMirroredLight) {
    Scene scene;
    add(scene, floor_with(0, 0.4));
    scene.solids[0].material.shininess = 20;
    scene.solids[0].material.color = {0, 0, 0};
    add(scene, lamp({-1, 1, 0}));
    for (const double off : {0.0, 0.1, 0.4, 2.0}) {
        const double a = kPi / 4 + off;
        const Vector to_eye{std::cos(a), std::sin(a), 0};
        EXPECT_NEAR(look(scene, 5 * to_eye, -to_eye).y, 0.4 * std::pow(std::max(0.0, std::cos(off)), 20), 1e-9) << off;
    }
}

TEST(ReferenceLight, HighlightOfAMirrorIsTintedAndTakesTheExponentOfItsLobe) {
    Scene scene;
    Mirror mirror = ideal_mirror(1);
    mirror.color = {0.5, 1, 0};
    mirror.specular = 0.8;
    mirror.reflection = 0;
    mirror.lobe_exponent = 7;
    add(scene, mirror);
    add(scene, lamp({0, 0, 3}));
    const Vector eye{0, std::sin(0.3), std::cos(0.3)};
    const auto seen = [&] { return look(scene, 2 * eye, -eye); };
    const double lobe = 0.8 * std::pow(std::cos(0.3), 7);
    EXPECT_NEAR(seen().x, 0.5 * lobe, 1e-14);
    EXPECT_NEAR(seen().y, lobe, 1e-14);
    EXPECT_EQ(seen().z, 0);
    scene.mirrors[0].shininess = 3;
    EXPECT_NEAR(seen().y, 0.8 * std::pow(std::cos(0.3), 3), 1e-14);
    scene.mirrors[0].lobe_exponent = kInfinity;
    EXPECT_NEAR(seen().y, 0.8 * std::pow(std::cos(0.3), 3), 1e-14);
    scene.mirrors[0].shininess = kShininessOfLobe;
    EXPECT_EQ(seen().y, 0);
}

TEST(ReferenceLight, EverythingStrictlyBetweenBlocks) {
    Scene lit;
    add(lit, floor_with(1, 0));
    add(lit, lamp({0, 4, 0}));
    EXPECT_EQ(floor_at(lit, 0), 1);

    Scene glass = lit;
    add(glass, ball({0, 2, 0}, 0.5));
    glass.solids[1].material.transmission = 1;
    EXPECT_EQ(floor_at(glass, 0), 0);

    for (const double side : {1.0, -1.0}) {
        Scene mirrored = lit;
        Mirror mirror = ideal_mirror(1);
        mirror.position = {0, 2, 0};
        mirror.normal = {0, side, 0};
        add(mirrored, mirror);
        EXPECT_EQ(floor_at(mirrored, 0), 0) << "side " << side;
    }

    Scene behind = lit;
    add(behind, ball({0, 6, 0}, 1));
    EXPECT_EQ(floor_at(behind, 0), 1);
    Scene beside = lit;
    add(beside, ball({3, 2, 0}, 1));
    EXPECT_EQ(floor_at(beside, 0), 1);
}

TEST(ReferenceLight, HollowMirrorShadesItself) {
    Scene scene;
    Mirror mirror = ideal_mirror(0.99);
    mirror.curvature_radius = 1;
    mirror.diffuse = 1;
    mirror.reflection = 0;
    add(scene, mirror);
    const Vector eye{-0.2, 0, 0.5}, wall_direction{1, 0, 0};
    // From the wall at +x the upper lamp is seen over the opposite rim, the lower one through the opposite wall.
    add(scene, lamp({-3, 0, 3}));
    EXPECT_GT(look(scene, eye, wall_direction).x, 0.1);
    scene.lights[0].position = {-3, 0, 0.6};
    EXPECT_EQ(look(scene, eye, wall_direction).x, 0);
}

TEST(ReferenceLight, InsideOfASolidIsLitOnlyFromWithin) {
    Scene scene;
    add(scene, ball({0, 0, 0}, 2));
    scene.solids[0].material = floor_with(1, 0).material;
    scene.solids[0].material.ambient = 0.25;
    add(scene, lamp({9, 0, 0}));
    EXPECT_EQ(look(scene, {0, 0, 0}, {-1, 0, 0}).x, 0.25);
    EXPECT_EQ(look(scene, {0, 0, 0}, {1, 0, 0}).x, 0.25);
    scene.lights[0].position = {1, 0, 0};
    EXPECT_NEAR(look(scene, {0, 0, 0}, {-1, 0, 0}).x, 1.25, 1e-15);
}

TEST(ReferenceLight, AmbientAndLampsTintTheColourOfTheSolidChannelByChannel) {
    Scene scene;
    add(scene, floor_with(0.5, 0.25));
    scene.solids[0].material.color = {1, 0.5, 0};
    scene.solids[0].material.ambient = 0.125;
    scene.ambient = {0.5, 2, 1};
    add(scene, lamp({0, 4, 0}));
    scene.lights[0].color = {0.25, 0.5, 4};
    const Color seen = look(scene, {0, 5, 0}, {0, -1, 0});
    EXPECT_EQ(seen.x, 0.125 * 0.5 + 0.25 * (0.5 + 0.25));
    EXPECT_EQ(seen.y, 0.125 * 0.5 * 2 + 0.5 * (0.5 * 0.5 + 0.25));
    EXPECT_EQ(seen.z, 4 * 0.25);
}

TEST(ReferenceLight, LampExactlyOnTheSurfaceLightsNothingThere) {
    Scene scene;
    add(scene, floor_with(1, 1));
    scene.solids[0].material.ambient = 0.5;
    add(scene, lamp({0, 0, 0}));
    EXPECT_EQ(look(scene, {0, 5, 0}, {0, -1, 0}).x, 0.5);
}

TEST(ReferenceLight, TwoLampsAddUpWithAmbientCountedOnce) {
    Scene both;
    add(both, ball({0, 0, 0}, 1));
    add(both, lamp({3, 1, 2}));
    add(both, lamp({-1, 4, 3}));
    both.lights[1].color = {0.2, 0.4, 0.8};
    Scene first = both, second = both, none = both;
    first.light_count = 1;
    second.light_count = 1;
    second.lights[0] = both.lights[1];
    none.light_count = 0;
    const auto seen = [](const Scene& scene) { return look(scene, {0.2, 0.3, 5}, {0, 0, -1}); };
    const Color rest = seen(both) - seen(first) - seen(second) + seen(none);
    EXPECT_GT(length(seen(first) - seen(none)), 0.1);
    EXPECT_GT(length(seen(second) - seen(none)), 0.1);
    EXPECT_NEAR(length(rest), 0, 1e-15);
}

}  // namespace
}  // namespace zerkalo::reference
