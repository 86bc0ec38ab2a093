// The ray tree: geometric series between facing mirrors, tint, and what the depth limit cuts.
#include "tests/reference/scenes.hpp"

#include <gtest/gtest.h>

namespace zerkalo::reference {
namespace {

Scene facing_mirrors(const Rgb<double>& tint, double reflection) {
    Scene scene;
    Mirror mirror = ideal_mirror(3);
    mirror.color = tint;
    mirror.ambient = 0.5;
    mirror.reflection = reflection;
    add(scene, mirror);
    mirror.position = {0, 0, 2};
    mirror.normal = {0, 0, -1};
    add(scene, mirror);
    return scene;
}

TEST(ReferenceDepth, FacingMirrorsSumAGeometricSeriesInEveryChannel) {
    const Rgb<double> tint{1, 0.8, 0.25};
    const Scene scene = facing_mirrors(tint, 0.75);
    for (const int limit : {0, 1, 2, 6, 40}) {
        const Color seen = look(scene, {0.1, 0.2, 1}, {0, 0, -1}, limit);
        const auto series = [&](double c) {
            const double q = 0.75 * c;
            return 0.5 * c * (1 - std::pow(q, limit + 1)) / (1 - q);
        };
        EXPECT_NEAR(seen.x, series(1), 1e-14) << limit;
        EXPECT_NEAR(seen.y, series(0.8), 1e-14) << limit;
        EXPECT_NEAR(seen.z, series(0.25), 1e-14) << limit;
    }
}

TEST(ReferenceDepth, MissSeesTheBackgroundAtAnyDepthWithinTheLimit) {
    Scene scene;
    scene.background = {0.25, 0.5, 1};
    EXPECT_EQ(look(scene, {0, 0, 5}, {0, 0, -1}, 0).y, 0.5);
    add(scene, ideal_mirror(1));
    scene.mirrors[0].reflection = 0.5;
    EXPECT_EQ(look(scene, {0, 0, 5}, {0, 0, -1}, 1).y, 0.25);
    EXPECT_EQ(look(scene, {0, 0, 5}, {0, 0, -1}, 0).y, 0);
}

TEST(ReferenceDepth, GlossyMirrorAtTheLimitAddsNothingNotEvenBackground) {
    for (const Lobe lobe : {Lobe::phong, Lobe::max_phong}) {
        Scene scene;
        scene.background = {1, 1, 1};
        add(scene, ideal_mirror(1));
        scene.mirrors[0].lobe = lobe;
        scene.mirrors[0].lobe_exponent = 0;
        EXPECT_EQ(look(scene, {0.9, 0, 0.1}, {-0.9, 0, -0.1}, 0, 64).x, 0);
        EXPECT_GT(look(scene, {0.9, 0, 0.1}, {-0.9, 0, -0.1}, 1, 64).x, 0.3);
    }
}

TEST(ReferenceDepth, SolidsReflectSharplyAndUntinted) {
    Scene scene;
    add(scene, ball({0, 0, 0}, 1));
    scene.solids[0].material = glowing({0, 1, 0});
    scene.solids[0].material.ambient = 0.125;
    scene.solids[0].material.reflection = 0.5;
    // Seen at 45 degrees, the ball sends the ray from +z to +x, where a small bead hangs.
    const double at = std::sqrt(0.5);
    add(scene, ball({4, 0, at}, 0.01));
    scene.solids[1].material = glowing({1, 0.5, 0.25});
    const Color seen = look(scene, {at, 0, 5}, {0, 0, -1});
    EXPECT_NEAR(seen.x, 0.5, 1e-12);
    EXPECT_NEAR(seen.y, 0.125 + 0.25, 1e-12);
    EXPECT_NEAR(seen.z, 0.125, 1e-12);
}

TEST(ReferenceDepth, MoreDepthNeverDarkens) {
    Scene scene = facing_mirrors({0.9, 0.8, 0.7}, 0.8);
    scene.background = {0.1, 0.1, 0.1};
    add(scene, ball({0, 0, 1}, 0.4));
    scene.solids[0].material.transmission = 0.6;
    scene.solids[0].material.reflection = 0.3;
    add(scene, lamp({1, 1, 1}));
    for (int i = 0; i < 40; ++i) {
        const Vector direction{0.4 * std::sin(0.5 * i), 1, 0.5 * std::cos(0.3 * i)};
        double before = 0;
        for (int limit = 0; limit < 7; ++limit) {
            const double now = look(scene, {0, -0.9, 1}, direction, limit).y;
            EXPECT_GE(now, before) << "ray " << i << " limit " << limit;
            before = now;
        }
        EXPECT_GT(before, look(scene, {0, -0.9, 1}, direction, 0).y) << "ray " << i;
    }
}

}  // namespace
}  // namespace zerkalo::reference
