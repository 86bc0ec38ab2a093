// What is seen where several surfaces are met at one distance: solids before mirrors, and the lower index first.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

namespace zerkalo::laws {
namespace {

constexpr Rgb<double> kRed{1, 0, 0}, kGreen{0, 1, 0};

/// Two balls in one place, the camera before them; with mirrors elsewhere the general kernel is asked.
Scene balls_in_one_place(const Rgb<double>& first, const Rgb<double>& second, bool general) {
    Scene scene;
    add(scene, ball({0, 0, 0}, 1, glowing(first)));
    add(scene, ball({0, 0, 0}, 1, glowing(second)));
    if (general) {
        for (const double x : {-300.0, 300.0}) add(scene, ideal_mirror({x, 0, 40}, {0, 1, 0}, 1));
    }
    scene.camera = camera_at({0, 0, 10}, {0, 0, -1}, 0.25);
    return scene;
}

TEST(Tie, OfTwoSolidsInOnePlaceTheFirstIsSeen) {
    for (const bool general : {false, true}) {
        const Image both = render(balls_in_one_place(kRed, kGreen, general), of_size(64, 64));
        const Image first = render(balls_in_one_place(kRed, kRed, general), of_size(64, 64));
        EXPECT_EQ(pixels_apart(both, first), 0) << "general kernel: " << general;
        const Image other_way = render(balls_in_one_place(kGreen, kRed, general), of_size(64, 64));
        EXPECT_GT(pixels_apart(both, other_way), 1000) << "general kernel: " << general;
    }
}

// A face of a box in the plane of a mirror: the whole face is seen, and nothing of the mirror before it.
TEST(Tie, OfASolidAndAMirrorInOnePlaneTheSolidIsSeen) {
    for (const int others : {0, 2}) {
        Scene scene;
        add(scene, box({0, -1, -1}, 2, 2, glowing(kRed)));
        add(scene, ideal_mirror({0, 0, 0}, {0, 0, 1}, 1));
        for (int k = 0; k < others; ++k) add(scene, ideal_mirror({300.0 - 600 * k, 0, 40}, {0, 1, 0}, 1));
        scene.camera = camera_at({0, 0, 8}, {0, 0, -1}, 0.125);
        const Image image = render(scene, of_size(64, 64));
        scene.mirrors[0].position = {0, 0, -20};
        EXPECT_EQ(pixels_apart(image, render(scene, of_size(64, 64))), 0) << others << " other mirrors";
    }
}

}  // namespace
}  // namespace zerkalo::laws
