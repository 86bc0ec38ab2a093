// Refraction, seen through solids: Snell's law by the shift of a slab, and total internal reflection.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::laws {
namespace {

// Coordinates of a few units in float: some 1e-6 after a slab's two refractions.
constexpr double kFloatLengths = 5e-6;

/// A wall that glows for x < 0 behind a slab of glass between y = 1 and y = 1 + thickness (or behind nothing).
Scene wall_behind_a_slab(double thickness, double index) {
    Scene scene;
    add(scene, box({-2, -1, 0}, 4, 1, glowing({1, 1, 1})));
    if (thickness > 0) add(scene, box({0, 1, 0}, 30, thickness, clear_glass(index)));
    return scene;
}

/// Where along x a camera ray from height 5, slanting down at `angle`, ceases to meet the wall.
double last_sight(const Scene& scene, double angle) {
    const Vec3<double> view{std::sin(angle), -std::cos(angle), 0};
    const double nominal = -5 * std::tan(angle);
    return where_it_ends(nominal - 1.5, nominal + 1.5, [&](double x) { return look(scene, {x, 5, 0}, view).r > 0.5; });
}

TEST(P07, SlabShiftsARayBySnellsLaw) {
    constexpr double kThickness = 0.75;
    for (const double index : {1.0, 1.33, 1.5, 2.4}) {
        for (const double angle : {0.0, 0.2, 0.6, 1.0}) {
            const double sine = std::sin(angle), cosine = std::cos(angle);
            const double shift = kThickness * sine * (1 - cosine / std::sqrt(index * index - sine * sine));
            const double with = last_sight(wall_behind_a_slab(kThickness, index), angle);
            const double without = last_sight(wall_behind_a_slab(0, 1), angle);
            // The ray is shifted back towards the normal: along x by the perpendicular shift over the cosine.
            EXPECT_NEAR((with - without) * cosine, shift, kFloatLengths) << "index " << index << ", angle " << angle;
        }
    }
}

TEST(P08, GlassReflectsTotallyBeyondTheCriticalAngle) {
    // From inside a large block, through its lid, at angles on both sides of asin(1/n).
    constexpr double kIndex = 1.5, kRoom = 1e-5;
    Scene scene;
    scene.background = {1, 1, 1};
    add(scene, box({0, -8, 0}, 16, 8, clear_glass(kIndex)));
    add(scene, ball({8, -4, 0}, 3.5, glowing({0, 0, 0})));
    Settings one_refraction;
    one_refraction.depth_limit = 1;
    const double critical = std::asin(1 / kIndex);
    for (const double turn : {-0.5, -0.1, -kRoom, kRoom, 0.1, 0.5}) {
        // The only step goes out into the white room, or back into the block, whose walls show nothing.
        const Vec3<double> view{std::sin(critical + turn), std::cos(critical + turn), 0};
        EXPECT_EQ(look(scene, {-1, -1, 0}, view, one_refraction).r, turn < 0 ? 1 : 0) << "turned by " << turn;
    }
}

TEST(Glass, BallOfIndexOneIsNotThere) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    add_five_solids(scene, 0);
    scene.camera = camera_at({0.7, 2.1, 6}, {-0.1, -0.15, -1}, 0.8);
    Scene with = scene;
    add(with, ball({0, 1, 3}, 1, clear_glass(1)));
    constexpr double kSilhouetteShare = 1e-3;
    const Image image = render(with, of_size(160, 120));
    const auto difference = reference::compare(picture_of(image), picture_of(render(scene, of_size(160, 120))), 1);
    EXPECT_LE(static_cast<double>(difference.pixels_off_by_more), kSilhouetteShare * difference.pixels);
    EXPECT_GT(image.rays.refracted, 1000u);
}

}  // namespace
}  // namespace zerkalo::laws
