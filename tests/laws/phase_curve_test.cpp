// P12: a ball of chalk shines like Lambert's moon: its brightness at every phase is a closed form.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace zerkalo::laws {
namespace {

// Camera and lamp so far away that their rays are parallel.
constexpr double kFar = 1e6;
constexpr double kHalfSide = 1.0625;  // of the square that the camera sees, in radii

/// The ball's mean brightness over its disc, seen at `phase`, the angle between camera and lamp, in side x side pixels.
double mean_brightness(double phase, int side) {
    Scene scene;
    scene.ambient = {0, 0, 0};
    add(scene, ball({0, 0, 0}, 1, chalk()));
    add(scene, lamp({kFar * std::sin(phase), 0, kFar * std::cos(phase)}));
    scene.camera = camera_at({0, 0, kFar}, {0, 0, -1}, 2 * std::atan(kHalfSide / kFar));
    const Image image = render(scene, of_size(side, side));
    const double pixel = std::pow(2 * kHalfSide / side, 2);
    return pixel * std::accumulate(image.rgb.begin(), image.rgb.end(), 0.0) / 3 / kPi;
}

double closed_form(double phase) {
    constexpr double kFullPhase = 2.0 / 3;
    return kFullPhase * (std::sin(phase) + (kPi - phase) * std::cos(phase)) / kPi;
}

double rms_error(int side) {
    constexpr int kPhases = 16;
    double sum = 0;
    for (int k = 0; k < kPhases; ++k) {
        const double phase = kPi * (k + 0.5) / kPhases;
        sum += std::pow(mean_brightness(phase, side) - closed_form(phase), 2);
    }
    return std::sqrt(sum / kPhases);
}

TEST(P12, BrightnessOfAChalkBallFollowsItsPhase) {
    // Only pixels count, whole or not at all: at the bright limb there is an error like side^-3/2.
    constexpr double kLimb = 1;
    const double coarse = rms_error(32), fine = rms_error(256);
    EXPECT_LE(fine, kLimb * std::pow(256, -1.5));
    EXPECT_NEAR(std::log2(coarse / fine) / 3, 1.5, 0.5) << coarse << " at 32, " << fine << " at 256 pixels";
}

TEST(P12, FullPhaseHasAMeanOfTwoThirds) {
    // No jump at the limb here: the error is that of a kink.
    EXPECT_NEAR(mean_brightness(0, 256), 2.0 / 3, 1e-4);
}

}  // namespace
}  // namespace zerkalo::laws
