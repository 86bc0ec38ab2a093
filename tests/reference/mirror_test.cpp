// The mirror's surface: curvature, outline, frame, front and back.
#include "tests/reference/scenes.hpp"

#include <gtest/gtest.h>

namespace zerkalo::reference {
namespace {

Scene alone(const Mirror& mirror) {
    Scene scene;
    add(scene, mirror);
    return scene;
}

Mirror curved(double radius) {
    Mirror mirror = ideal_mirror(0.95 * std::abs(radius));
    mirror.curvature_radius = radius;
    return mirror;
}

TEST(ReferenceMirror, ParallelRayCrossesTheAxisByTheExactSphericalAberration) {
    const World world(alone(curved(2)));
    for (const double height : {0.01, 0.5, 1.0, 1.6}) {
        const Hit hit = world.first_hit({{height, 0, 9}, {0, 0, -1}});
        const Vector out = reflected({0, 0, -1}, hit.normal);
        const double crossing = hit.point.z - hit.point.x / out.x * out.z;
        EXPECT_NEAR(crossing, 2 * (1 - 0.5 / std::cos(std::asin(height / 2))), 1e-11) << "height " << height;
        EXPECT_TRUE(hit.front);
    }
}

TEST(ReferenceMirror, PositiveRadiusIsHollowAndNegativeBulgesFromTheFront) {
    const double sagitta = 2 - std::sqrt(4 - 1.0);
    EXPECT_NEAR(World(alone(curved(2))).first_hit({{0, 1, 9}, {0, 0, -1}}).point.z, sagitta, 1e-12);
    EXPECT_NEAR(World(alone(curved(-2))).first_hit({{0, 1, 9}, {0, 0, -1}}).point.z, -sagitta, 1e-12);
    EXPECT_GT(World(alone(curved(-2))).first_hit({{0, 1, 9}, {0, 0, -1}}).normal.y, 0.4);
}

TEST(ReferenceMirror, OnlyTheHemisphereAtTheVertexExists) {
    const World world(alone(curved(2)));
    EXPECT_EQ(world.first_hit({{0, 1, 9}, {0, 1, 0}}).kind, HitKind::none);
    EXPECT_NEAR(world.first_hit({{0, 0, 9}, {0, 0, -1}}).point.z, 0, 1e-12);
    EXPECT_EQ(world.first_hit({{0, 0, 0.5}, {0, 0, 1}}).kind, HitKind::none);
}

TEST(ReferenceMirror, FartherRootCountsWhereTheNearerLiesOutsideTheOutline) {
    Mirror mirror = curved(1);
    mirror.boundary.shape = BoundaryShape::polygon;
    mirror.boundary.corner_count = 3;
    mirror.boundary.corners[0] = {0.1, -0.4};
    mirror.boundary.corners[1] = {0.98, 0};
    mirror.boundary.corners[2] = {0.1, 0.4};
    const Hit hit = World(alone(mirror)).first_hit({{-5, 0, 0.5}, {1, 0, 0}});
    ASSERT_EQ(hit.kind, HitKind::mirror);
    EXPECT_NEAR(hit.point.x, std::sqrt(0.75), 1e-12);
    EXPECT_TRUE(hit.front);
}

TEST(ReferenceMirror, HugeRadiusIsThePlane) {
    for (const double radius : {1e9, -1e9, 1e15}) {
        Mirror mirror = curved(radius);
        mirror.boundary.radius = 2;
        const Vector from{1, 2, 9}, d = normalized({0.05, -0.2, -1});
        const Hit hit = World(alone(mirror)).first_hit({from, d});
        ASSERT_EQ(hit.kind, HitKind::mirror);
        const double sagitta = dot(hit.point, hit.point) / (2 * radius);
        EXPECT_NEAR(hit.t, (9 - sagitta) / -d.z, 1e-13) << "radius " << radius;
    }
}

double area(const Mirror& mirror) {
    constexpr int kSide = 600;
    const World world(alone(mirror));
    const double step = 6.0 / kSide;
    int hits = 0;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j)
            hits += world.first_hit({{-3 + (i + 0.47) * step, -3 + (j + 0.53) * step, 9}, {0, 0, -1}}).kind ==
                    HitKind::mirror;
    return hits * step * step;
}

TEST(ReferenceMirror, OutlineHasItsArea) {
    Mirror mirror = ideal_mirror(1.5);
    EXPECT_NEAR(area(mirror), kPi * 2.25, 0.02);
    mirror.boundary.width = 4;
    mirror.boundary.height = 2;
    mirror.boundary.shape = BoundaryShape::rectangle;
    EXPECT_NEAR(area(mirror), 8, 0.05);
    mirror.boundary.shape = BoundaryShape::ellipse;
    EXPECT_NEAR(area(mirror), 2 * kPi, 0.02);
    mirror.boundary.shape = BoundaryShape::polygon;
    mirror.boundary.corner_count = 4;
    const Vec2<double> corners[4] = {{-1, -1}, {2, -1}, {1, 1}, {-1, 1}};
    for (const bool reversed : {false, true}) {
        for (int i = 0; i < 4; ++i) mirror.boundary.corners[i] = corners[reversed ? 3 - i : i];
        EXPECT_NEAR(area(mirror), 5, 0.05) << "reversed " << reversed;
    }
}

TEST(ReferenceMirror, OutlineLiesAlongRightAndV) {
    Mirror mirror = ideal_mirror(1);
    mirror.boundary.shape = BoundaryShape::polygon;
    mirror.boundary.corner_count = 3;
    mirror.boundary.corners[0] = {1, 1};
    mirror.boundary.corners[1] = {2, 1};
    mirror.boundary.corners[2] = {1, 3};
    const auto seen_at = [&](double x, double y, double side) {
        return World(alone(mirror)).first_hit({{x, y, 9 * side}, {0, 0, -side}}).kind == HitKind::mirror;
    };
    EXPECT_TRUE(seen_at(1.2, 1.5, 1));
    mirror.normal = {0, 0, -7};
    EXPECT_TRUE(seen_at(-1.2, 1.5, -1));
    mirror.normal = {0, 0, 2};
    mirror.up = {1, 0, 0};
    EXPECT_TRUE(seen_at(1.5, -1.2, 1));
    // Parallel up: the world's x axis serves for a normal along z, as in the line above.
    mirror.up = {0, 0, 1};
    EXPECT_TRUE(seen_at(1.5, -1.2, 1));
}

TEST(ReferenceMirror, BackIsMatteInItsColour) {
    Scene scene;
    Mirror mirror = ideal_mirror(2);
    mirror.color = {0.5, 1, 0.25};
    mirror.ambient = 0.25;
    mirror.diffuse = 0.5;
    mirror.specular = 1;
    mirror.lobe_exponent = 1;
    add(scene, mirror);
    scene.background = {1, 1, 1};
    add(scene, lamp({0, 3, -3}));
    const Color back = look(scene, {0, 0, -4}, {0, 0, 1});
    const double share = 0.25 + 0.5 * std::sqrt(0.5);
    EXPECT_NEAR(back.x, 0.5 * share, 1e-15);
    EXPECT_NEAR(back.y, share, 1e-15);
    EXPECT_NEAR(back.z, 0.25 * share, 1e-15);
}

}  // namespace
}  // namespace zerkalo::reference
