// Lamps, shadows and sizes by closed forms: Lambert's floor, the inverse square, a ball's shadow and its solid angle.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::laws {
namespace {

constexpr double kRelative = 1e-6;  // a dozen float operations

/// A floor of chalk at y = 0 under one lamp on the y axis; nothing but that lamp gives light.
Scene floor_under_a_lamp(double height, Falloff falloff) {
    Scene scene;
    scene.ambient = {0, 0, 0};
    add(scene, box({0, -1, 0}, 64, 1, chalk()));
    add(scene, lamp({0, height, 0}));
    scene.lights[0].falloff = falloff;
    return scene;
}

/// What a slanting glance at the floor's point (x, 0, 0) shows.
double floor_at(const Scene& scene, double x) { return look(scene, {x, 3, 8}, {0, -3, -8}).g; }

TEST(P11, LampLightsTheFloorByLambertsCosine) {
    constexpr double kHeight = 4;
    const Scene scene = floor_under_a_lamp(kHeight, Falloff::none);
    for (const double x : {0.0, 0.5, 2.0, 4.0, 12.0}) {
        const double closed = kHeight / std::hypot(kHeight, x);
        EXPECT_NEAR(floor_at(scene, x), closed, kRelative * closed) << "x = " << x;
    }
}

TEST(P11, LampFadesWithTheInverseSquare) {
    constexpr double kHeight = 4;
    const Scene scene = floor_under_a_lamp(kHeight, Falloff::inverse_square);
    for (const double x : {0.0, 0.5, 2.0, 4.0, 12.0}) {
        const double closed = kHeight / std::pow(std::hypot(kHeight, x), 3);
        EXPECT_NEAR(floor_at(scene, x), closed, kRelative * closed) << "x = " << x;
    }
}

TEST(P13, ShadowOfABallBelowTheLampIsADiscOfTheClosedForm) {
    // A grazing ray meets the ball as well as float coordinates allow.
    constexpr double kFloatLengths = 2e-5;
    constexpr double kLamp = 6;
    for (const double height : {0.6, 1.5, 3.0}) {
        for (const double radius : {0.05, 0.25, 0.5}) {
            Scene scene = floor_under_a_lamp(kLamp, Falloff::none);
            add(scene, ball({0, height, 0}, radius, chalk()));
            const double closed = kLamp * radius / std::sqrt(std::pow(kLamp - height, 2) - radius * radius);
            // A camera that looks along y = 0 from the side never has the ball in its way.
            const auto dark = [&](double x) { return look(scene, {x, 0.01, 8}, {0, -0.01, -8}).g == 0; };
            EXPECT_NEAR(where_it_ends(0, 10, dark), closed, kFloatLengths)
                << "height " << height << ", radius " << radius;
        }
    }
}

TEST(Shadow, IsCastByTheBackOfAMirrorToo) {
    Scene scene = floor_under_a_lamp(6, Falloff::none);
    add(scene, ideal_mirror({0, 3, 0}, {0, 1, 0}, 2));
    scene.mirrors[0].up = {0, 0, -1};
    const auto dark = [&](double x) { return look(scene, {x, 0.01, 8}, {0, -0.01, -8}).g == 0; };
    // Half way up to the lamp, so twice as large on the floor.
    constexpr double kFloatLengths = 2e-6;
    EXPECT_NEAR(where_it_ends(0, 10, dark), 2, kFloatLengths);
}

TEST(P22, BallFillsTheSolidAngleOfItsClosedForm) {
    constexpr int kSide = 256;
    constexpr double kFov = 1.4;
    const double half = std::tan(kFov / 2);
    for (const double distance : {2.0, 3.0, 8.0}) {
        Scene scene;
        add(scene, ball({0.1, -0.2, -distance}, 1, glowing({1, 1, 1})));
        scene.camera = camera_at({0.1, -0.2, 0}, {0, 0, -1}, kFov);
        const Image image = render(scene, of_size(kSide, kSide));
        double angle = 0;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const double u = (2 * (x + 0.5) / kSide - 1) * half, v = (2 * (y + 0.5) / kSide - 1) * half;
                const double pixel = 4 * half * half / (double{kSide} * kSide);
                angle += image.at(x, y).g * pixel / std::pow(1 + u * u + v * v, 1.5);
            }
        }
        const double closed = 2 * kPi * (1 - std::sqrt(1 - 1 / (distance * distance)));
        // Pixels on the rim count whole or not at all: an error like (rim pixels)^1/2 of (disc pixels), 3 sigma.
        const double rim_radius = kSide / 2.0 / half / std::sqrt(distance * distance - 1);
        const double tolerance = 3 * 0.5 * std::sqrt(2 * kPi * rim_radius) / (kPi * rim_radius * rim_radius);
        EXPECT_NEAR(angle / closed, 1, tolerance) << "distance " << distance;
    }
}

}  // namespace
}  // namespace zerkalo::laws
