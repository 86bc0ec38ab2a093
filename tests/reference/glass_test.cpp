// Refraction: Snell, the plane slab, total internal reflection, and which index counts.
#include "tests/reference/scenes.hpp"

#include <gtest/gtest.h>

namespace zerkalo::reference {
namespace {

TEST(ReferenceGlass, SinesGoAsTheIndices) {
    const Vector n{0, 0, 1};
    for (const double angle : {0.0, 0.2, 0.9, 1.5}) {
        Vector out;
        ASSERT_TRUE(refracted({std::sin(angle), 0, -std::cos(angle)}, n, 1 / 1.5, out));
        EXPECT_NEAR(1.5 * out.x, std::sin(angle), 1e-15);
        EXPECT_LT(out.z, 0);
        EXPECT_NEAR(length(out), 1, 1e-15);
    }
    const double critical = std::asin(1 / 1.5);
    Vector out;
    EXPECT_TRUE(refracted({std::sin(critical - 1e-9), 0, -std::cos(critical - 1e-9)}, n, 1.5, out));
    EXPECT_FALSE(refracted({std::sin(critical + 1e-9), 0, -std::cos(critical + 1e-9)}, n, 1.5, out));
}

/// A box of glass, faces at x, z = +-side/2 and y = 0, height; K_a, K_d and K_s are 0.
Solid glass_box(double side, double height) {
    Solid solid;
    solid.kind = SolidKind::prism;
    solid.radius = side / std::sqrt(2.0);
    solid.rotation = {0, kPi / 4, 0};
    solid.height = height;
    solid.material = glowing({1, 1, 1});
    solid.material.ambient = 0;
    solid.material.transmission = 1;
    return solid;
}

TEST(ReferenceGlass, SlabShiftsARayByTheClosedForm) {
    constexpr double kThickness = 0.8, kAngle = 0.7, kIndex = 1.5;
    Scene scene;
    add(scene, glass_box(20, kThickness));
    const Vector d{std::sin(kAngle), -std::cos(kAngle), 0}, aside{std::cos(kAngle), std::sin(kAngle), 0};
    const double shift = kThickness * std::sin(kAngle) *
                         (1 - std::cos(kAngle) / std::sqrt(kIndex * kIndex - std::sin(kAngle) * std::sin(kAngle)));
    const Vector eye = -5 * d;
    // A bead of radius 1e-3 on the shifted ray; the ray meets it, and one shifted the other way does not.
    for (const double sign : {-1.0, 1.0}) {
        const Vector bead = eye + 12 * d + sign * shift * aside;
        Scene with_bead = scene;
        add(with_bead, ball({bead.x, bead.y, bead.z}, 1e-3));
        with_bead.solids[1].material = glowing({0.3, 0.6, 0.9});
        EXPECT_NEAR(look(with_bead, eye, d).y, sign < 0 ? 0.6 : 0, 1e-12) << sign;
    }
}

TEST(ReferenceGlass, IndexOneIsInvisible) {
    Scene scene, empty;
    scene.background = empty.background = {0.3, 0.5, 0.7};
    add(scene, ball({0, 0, 0}, 1));
    scene.solids[0].material = glass_box(1, 1).material;
    scene.solids[0].material.refractive_index = 1;
    const Solid bead = ball({0.4, 0.3, -4}, 0.05);
    add(scene, bead);
    add(empty, bead);
    for (const double x : {0.35, 0.39, 0.41, 0.5})
        EXPECT_NEAR(length(look(scene, {x, 0.3, 5}, {0, 0, -1}) - look(empty, {x, 0.3, 5}, {0, 0, -1})), 0, 1e-12) << x;
}

TEST(ReferenceGlass, TotalReflectionMovesTheRefractedShareToTheReflectedOne) {
    Scene scene;
    scene.background = {1, 1, 1};
    add(scene, glass_box(10, 10));
    Material& m = scene.solids[0].material;
    m.ambient = 0.125;
    m.reflection = 0.25;
    m.transmission = 0.5;
    // From inside towards the top; with one more bounce the next wall adds its ambient share and nothing else.
    const auto seen_at = [&](double angle) {
        return look(scene, {0, 9, 0}, {std::sin(angle), std::cos(angle), 0}, 1).x;
    };
    EXPECT_NEAR(seen_at(0.6), 0.125 + 0.25 * 0.125 + 0.5, 1e-15);
    EXPECT_NEAR(seen_at(0.9), 0.125 + 0.75 * 0.125, 1e-15);
}

TEST(ReferenceGlass, BallLensFocusesAtItsBackFocalLength) {
    // Paraxial: focal length from the centre n r / (2 (n - 1)) = 1.5 for n = 1.5, r = 1.
    Scene scene;
    add(scene, ball({0, 0, 0}, 1));
    scene.solids[0].material = glass_box(1, 1).material;
    add(scene, ball({0, 0, -1.5}, 1e-4));
    scene.solids[1].material = glowing({1, 1, 1});
    for (const double height : {0.0, 0.005, 0.01, 0.02})
        EXPECT_NEAR(look(scene, {height, 0, 5}, {0, 0, -1}).x, 1, 1e-12) << height;
    EXPECT_EQ(look(scene, {0.5, 0, 5}, {0, 0, -1}).x, 0);
}

}  // namespace
}  // namespace zerkalo::reference
