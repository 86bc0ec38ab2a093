// The solids against their closed forms: volume, placement, normals, ties.
#include "tests/reference/scenes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace zerkalo::reference {
namespace {

Scene alone(const Solid& solid) {
    Scene scene;
    add(scene, solid);
    return scene;
}

Solid some(SolidKind kind) {
    Solid solid;
    solid.kind = kind;
    solid.position = {0.3, -0.2, 0.1};
    solid.rotation = {0.7, -0.4, 1.9};
    solid.radius = 0.8;
    solid.height = 1.7;
    solid.sides = 5;
    solid.taper = kind == SolidKind::cone ? 0 : 1;
    return solid;
}

/// Cavalieri: the sum of chords of a grid of parallel rays is the volume. For convex solids.
double volume(const Scene& scene) {
    constexpr int kSide = 400;
    constexpr double kReach = 3;
    const World world(scene);
    const double step = 2 * kReach / kSide;
    double sum = 0;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const Ray ray{{-kReach + (i + 0.5) * step, -kReach + (j + 0.5) * step, 9}, {0, 0, -1}};
            const Hit entry = world.first_hit(ray);
            if (entry.kind == HitKind::none) continue;
            const Hit exit = world.first_hit(ray, entry.t + entry.guard);
            EXPECT_TRUE(entry.front && !exit.front) << "ray " << i << ", " << j;
            sum += (exit.t - entry.t) * step * step;
        }
    return sum;
}

TEST(ReferenceShapes, ChordsSumToTheVolume) {
    constexpr double kTolerance = 2e-3;
    const double tube = kPi * 0.8 * 0.8 * 1.7, polygon = 2.5 * 0.8 * 0.8 * std::sin(2 * kPi / 5) * 1.7;
    EXPECT_NEAR(volume(alone(some(SolidKind::sphere))), 4 * kPi / 3 * std::pow(0.8, 3), kTolerance);
    EXPECT_NEAR(volume(alone(some(SolidKind::cylinder))), tube, kTolerance);
    EXPECT_NEAR(volume(alone(some(SolidKind::cone))), tube / 3, kTolerance);
    EXPECT_NEAR(volume(alone(some(SolidKind::prism))), polygon, kTolerance);
    EXPECT_NEAR(volume(alone(some(SolidKind::pyramid))), polygon / 3, kTolerance);
    Solid flaring = some(SolidKind::cone);
    flaring.taper = 1.6;
    EXPECT_NEAR(volume(alone(flaring)), tube / 3 * (1 + 1.6 + 1.6 * 1.6), kTolerance);
}

TEST(ReferenceShapes, MeshFillsItsVolumeTimesTheCubeOfItsScale) {
    Solid solid = some(SolidKind::mesh);
    solid.scale = 1.5;
    solid.triangle_count = 4;
    Scene scene = alone(solid);
    const Vec3<double> o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    scene.triangle_count = 4;
    scene.triangles[0] = {o, y, x};
    scene.triangles[1] = {o, z, y};
    scene.triangles[2] = {o, x, z};
    scene.triangles[3] = {x, y, z};
    EXPECT_NEAR(volume(scene), std::pow(1.5, 3) / 6, 1e-3);
}

TEST(ReferenceShapes, AxisIsLocalYAndTheFirstCornerLiesOnLocalX) {
    Solid solid;
    solid.kind = SolidKind::prism;
    solid.position = {1, 2, 3};
    solid.sides = 3;
    solid.radius = 2;
    solid.height = 5;
    const World world(alone(solid));
    EXPECT_NEAR(world.first_hit({{1, 20, 3}, {0, -1, 0}}).point.y, 7, 1e-12);
    EXPECT_NEAR(world.first_hit({{1, -20, 3}, {0, 1, 0}}).point.y, 2, 1e-12);
    EXPECT_NEAR(world.first_hit({{20, 3, 3.0000001}, {-1, 0, 0}}).point.x, 3, 1e-6);
    EXPECT_NEAR(world.first_hit({{-20, 3, 3}, {1, 0, 0}}).point.x, 0, 1e-12);
}

TEST(ReferenceShapes, RotationTurnsAboutXThenYThenZ) {
    const Vector about_x_then_y = rotated({0, 1, 0}, {kPi / 2, kPi / 2, 0});
    EXPECT_NEAR(about_x_then_y.x, 1, 1e-15);
    const Vector then_z = rotated({0, 1, 0}, {kPi / 2, kPi / 2, kPi / 2});
    EXPECT_NEAR(then_z.y, 1, 1e-15);
    EXPECT_NEAR(rotated({0, 1, 0}, {0.3, 0, 0}).z, std::sin(0.3), 1e-15);
    EXPECT_NEAR(rotated({0, 0, 1}, {0, 0.3, 0}).x, std::sin(0.3), 1e-15);
    EXPECT_NEAR(rotated({1, 0, 0}, {0, 0, 0.3}).y, std::sin(0.3), 1e-15);
}

TEST(ReferenceShapes, NormalOfAConeLeansByItsSlope) {
    Solid solid;
    solid.kind = SolidKind::cone;
    solid.taper = 0;
    solid.radius = 3;
    solid.height = 4;
    const Hit hit = World(alone(solid)).first_hit({{9, 1, 0}, {-1, 0, 0}});
    EXPECT_NEAR(hit.point.x, 3 * 0.75, 1e-12);
    EXPECT_NEAR(hit.normal.x, 0.8, 1e-12);
    EXPECT_NEAR(hit.normal.y, 0.6, 1e-12);
}

TEST(ReferenceShapes, RayThatLeavesAConvexSolidNeverMeetsItAgain) {
    std::mt19937_64 random(kSeed);
    std::normal_distribution<double> normal;
    const auto direction = [&] { return normalized({normal(random), normal(random), normal(random)}); };
    for (const SolidKind kind :
         {SolidKind::sphere, SolidKind::cylinder, SolidKind::cone, SolidKind::prism, SolidKind::pyramid}) {
        const World world(alone(some(kind)));
        int hits = 0;
        for (int i = 0; i < 20000; ++i) {
            const Vector d = direction();
            const Vector aside{0.5 * normal(random), 0.5 * normal(random), 0.5 * normal(random)};
            const Hit hit = world.first_hit({aside - 5 * d, d});
            if (hit.kind == HitKind::none) continue;
            ++hits;
            Vector away = direction();
            if (dot(away, hit.normal) < 0) away = -away;
            if (dot(away, hit.normal) < 1e-4) continue;
            EXPECT_EQ(world.first_hit({hit.point, away}, hit.guard).kind, HitKind::none)
                << "kind " << static_cast<int>(kind) << " ray " << i;
            EXPECT_EQ(world.first_hit({hit.point, -away}, hit.guard).kind, HitKind::solid)
                << "kind " << static_cast<int>(kind) << " ray " << i;
        }
        EXPECT_GT(hits, 1000);
    }
}

TEST(ReferenceShapes, RayFromAMillionSizesAwayHitsWhereANearOneDoes) {
    for (const SolidKind kind : {SolidKind::sphere, SolidKind::cylinder, SolidKind::prism}) {
        const World world(alone(some(kind)));
        const Vector d = normalized({0.3, -0.5, 0.8}), target{0.4, 0.1, 0.2};
        const Hit near = world.first_hit({target - 10 * d, d}), far = world.first_hit({target - 1e6 * d, d});
        ASSERT_EQ(near.kind, HitKind::solid);
        EXPECT_LT(length(near.point - far.point), 2e-9) << "kind " << static_cast<int>(kind);
    }
}

TEST(ReferenceShapes, EqualDistancesGoToTheLowerIndexAndToSolidsBeforeMirrors) {
    Scene scene;
    Mirror mirror = ideal_mirror(1);
    mirror.position = {0, 0, 1};
    mirror.normal = {0, 0, -1};
    add(scene, mirror);
    add(scene, ball({0, 0, 0}, 1));
    add(scene, ball({0, 0, 0}, 1));
    const Hit hit = World(scene).first_hit({{0, 0, 3}, {0, 0, -1}});
    EXPECT_EQ(hit.kind, HitKind::solid);
    EXPECT_EQ(hit.index, 0);
    EXPECT_EQ(hit.t, 2);
    EXPECT_EQ(hit.normal.z, 1);
}

}  // namespace
}  // namespace zerkalo::reference
