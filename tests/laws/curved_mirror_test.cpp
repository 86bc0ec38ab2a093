// Rays at a spherical mirror go where geometry says, at any aperture: no paraxial formula is used.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::laws {
namespace {

constexpr double kBallRadius = 1e-4;  // of the target that a reflected ray must meet

Mirror dish(double curvature_radius, double rim) {
    Mirror mirror = ideal_mirror({0, 0, 0}, {0, 0, 1}, 1);
    mirror.boundary.shape = BoundaryShape::disc;
    mirror.boundary.radius = rim;
    mirror.curvature_radius = curvature_radius;
    return mirror;
}

/// Does the ray meet a small target at (0, 0, z)?
bool meets_axis_at(const Mirror& mirror, double z, const Vec3<double>& origin, const Vec3<double>& view) {
    Scene scene;
    add(scene, mirror);
    add(scene, ball({0, 0, z}, kBallRadius, glowing({1, 1, 1})));
    return look(scene, origin, view).r == 1;
}

TEST(P03, ParallelRayCrossesTheAxisWhereSphericalAberrationSays) {
    constexpr double kR = 2;
    for (const double height : {0.05, 0.2, 0.6, 1.2, 1.7}) {
        const double angle = std::asin(height / kR);
        const double crossing = kR * (1 - 1 / (2 * std::cos(angle)));
        const Vec3<double> origin{height, 0, 5};
        EXPECT_TRUE(meets_axis_at(dish(kR, 1.9), crossing, origin, {0, 0, -1})) << "height " << height;
        // Twice the angle is the ray's slope: moved this far along the axis, the target is missed by its own width.
        const double miss = 2 * kBallRadius / std::sin(2 * angle);
        EXPECT_FALSE(meets_axis_at(dish(kR, 1.9), crossing + miss, origin, {0, 0, -1})) << "height " << height;
        EXPECT_FALSE(meets_axis_at(dish(kR, 1.9), crossing - miss, origin, {0, 0, -1})) << "height " << height;
    }
}

TEST(P04, RaysFromItsCentreReturnThere) {
    constexpr double kR = 3;
    Scene scene;
    add(scene, dish(kR, 2.5));
    add(scene, ball({0, 0, kR}, kBallRadius, glowing({1, 1, 1})));
    for (const double slope : {-1.0, -0.4, 0.1, 0.7, 1.2}) {
        // From half way out, so that the ray does not start in the target.
        EXPECT_EQ(look(scene, {slope / 2, 0, kR - 0.5}, {slope, 0, -1}).r, 1) << "slope " << slope;
        EXPECT_EQ(look(scene, {slope / 2, 4 * kBallRadius, kR - 0.5}, {slope, 0, -1}).r, 0) << "slope " << slope;
    }
}

TEST(P26, DistantObjectIsImagedUpsideDownBeyondTheFocus) {
    // 1/u + 1/v = 2/R; every ray through the image of a small ball comes from the ball, wherever it met
    // the mirror.
    constexpr double kR = 2, kF = kR / 2, kField = 0.02, kBall = 2e-4;  // heights and radii of objects, as shares of u
    for (const double u : {10.0, 50.0, 1000.0}) {
        const double v = u * kF / (u - kF);
        for (const double field : {-kField, 0.0, kField}) {
            Scene scene;
            add(scene, dish(kR, 1));
            add(scene, ball({field * u, 0, u}, kBall * u, glowing({1, 1, 1})));
            const double image = -field * u * kF / (u - kF);
            for (const double aperture : {-0.05, -0.02, 0.01, 0.05}) {
                const auto through = [&](double x, double z) {
                    return look(scene, {x, 0, z}, {aperture - x, 0, -z}).g;
                };
                EXPECT_EQ(through(image, v), 1) << "u " << u << ", field " << field << ", aperture " << aperture;
                // Upright, or a twentieth too large, it is not there.
                if (field == 0) continue;
                EXPECT_EQ(through(-image, v), 0) << "u " << u << ", field " << field << ", aperture " << aperture;
                EXPECT_EQ(through(1.05 * image, v), 0) << "u " << u << ", field " << field << ", aperture " << aperture;
            }
        }
    }
}

TEST(P03, BulgingMirrorSendsParallelRaysAwayFromTheirVirtualCrossing) {
    constexpr double kR = 2;
    for (const double height : {0.1, 0.5, 1.2}) {
        const double angle = std::asin(height / kR);
        const double crossing = -kR * (1 - 1 / (2 * std::cos(angle)));
        const double sagitta = -kR * (1 - std::cos(angle));
        // On the line from the virtual crossing through the mirror point, beyond it.
        const double reach = 1;
        Scene scene;
        add(scene, dish(-kR, 1.9));
        add(scene, ball({height + reach * std::sin(2 * angle), 0, sagitta + reach * std::cos(2 * angle)}, kBallRadius,
                        glowing({1, 1, 1})));
        EXPECT_NEAR((sagitta - crossing) * std::tan(2 * angle), height, 1e-12) << "height " << height;
        EXPECT_EQ(look(scene, {height, 0, 5}, {0, 0, -1}).r, 1) << "height " << height;
        scene.solids[0].position.y += 2 * kBallRadius;
        EXPECT_EQ(look(scene, {height, 0, 5}, {0, 0, -1}).r, 0) << "height " << height;
    }
}

TEST(P05, MirrorOfAHugeRadiusIsThePlaneMirror) {
    Scene plane;
    plane.background = {0.1, 0.2, 0.3};
    add_five_solids(plane, 1);
    add(plane, lamp({-3, 5, 4}));
    add(plane, ideal_mirror({0, 1, -1}, {0, 0, 1}, 4));
    plane.camera = camera_at({0.7, 2.1, 6}, {-0.1, -0.15, -1}, 0.8);
    Scene curved = plane;
    // Sagitta 4e-9 over the mirror's half diagonal: below half an ulp of the coordinates.
    curved.mirrors[0].curvature_radius = 1e9;
    constexpr double kSilhouetteShare = 1e-3;
    const auto difference =
        reference::compare(picture_of(render(curved, of_size(96, 72))), picture_of(render(plane, of_size(96, 72))), 0);
    EXPECT_LE(static_cast<double>(difference.pixels_off_by_more), kSilhouetteShare * difference.pixels);
}

}  // namespace
}  // namespace zerkalo::laws
