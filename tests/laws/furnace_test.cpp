// The white furnace: in surroundings of radiance 1 a lossless mirror returns its albedo, which no law lets exceed 1.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace zerkalo::laws {
namespace {

constexpr double kExponents[] = {0, 1, 10, 100, 1e4, 1e9};
constexpr int kAngles[] = {0, 30, 60, 80, 89};

Scene furnace(Lobe lobe, double exponent) {
    Scene scene;
    scene.background = {1, 1, 1};
    Mirror mirror = ideal_mirror({0, 0, 0}, {0, 0, 1}, 100);
    mirror.lobe = lobe;
    mirror.lobe_exponent = exponent;
    add(scene, mirror);
    return scene;
}

double albedo(const Scene& scene, int degrees, int samples, bool exact_plan, int rotation = 0) {
    const double angle = degrees * kPi / 180;
    const Vec3<double> back{std::sin(angle), 0, std::cos(angle)};
    Settings settings;
    settings.samples = samples;
    settings.rotation = rotation;
    settings.exact_plan = exact_plan;
    return look(scene, back, {-back.x, 0, -back.z}, settings).g;
}

TEST(P15, PhongLobeReturnsAllThatItReceives) {
    for (const double n : kExponents) {
        for (const int degrees : kAngles) {
            for (const bool exact_plan : {false, true}) {
                EXPECT_NEAR(albedo(furnace(Lobe::phong, n), degrees, 64, exact_plan), 1, 2 * kUlp)
                    << "exponent " << n << ", " << degrees << " degrees";
            }
        }
    }
}

TEST(P15, PhongLobeReturnsAllThatItReceivesFromGlowingSolidsToo) {
    Scene scene = furnace(Lobe::phong, 20);
    for (int k = 0; k < 5; ++k) add(scene, ball({k - 2.0, 0, 2.0 + k % 2}, 0.4, glowing({1, 1, 1})));
    scene.camera = camera_at({0, 3, 5}, {0, -3, -5}, 0.8);
    for (const float value : render(scene, of_size(48, 36)).rgb) ASSERT_NEAR(value, 1, 2 * kUlp);
}

TEST(P15, ClippedLobeHasTheAlbedoOfItsPartAboveTheHorizon) {
    // Inside a glowing ball that only rays above the horizon see: for n = 0 and 1 their share has a closed form.
    constexpr double kQuadrature = 1e-4;  // of lattices of 16384 points, each of which a plane cuts elsewhere
    constexpr int kRotations = 32;
    for (const double exponent : {0.0, 1.0}) {
        Scene scene = furnace(Lobe::phong, exponent);
        scene.background = {0, 0, 0};
        add(scene, ball({0, 0, 0}, 60, glowing({1, 1, 1})));
        for (const int degrees : kAngles) {
            const double angle = degrees * kPi / 180;
            const double closed = exponent == 0 ? 1 - angle / kPi : (1 + std::cos(angle)) / 2;
            double mean = 0;
            for (int k = 1; k <= kRotations; ++k) mean += albedo(scene, degrees, 16384, true, k) / kRotations;
            EXPECT_NEAR(mean, closed, kQuadrature) << "exponent " << exponent << ", " << degrees << " degrees";
        }
    }
}

TEST(P15, MaxPhongNeverReturnsMoreThanItReceives) {
    for (const double n : kExponents) {
        for (const int degrees : kAngles) {
            EXPECT_LE(albedo(furnace(Lobe::max_phong, n), degrees, 64, false), 1 + 2 * kUlp)
                << "exponent " << n << ", " << degrees << " degrees";
        }
    }
}

TEST(P15, MaxPhongAtNormalIncidenceHasItsClosedForm) {
    // The midpoint rule of the lattice: its error at 4096 points, for the steepest of these lobes, and float sums.
    constexpr double kQuadrature = 2e-5;
    for (const double n : kExponents) {
        EXPECT_NEAR(albedo(furnace(Lobe::max_phong, n), 0, 4096, false), (n + 1) / (n + 2), kQuadrature)
            << "exponent " << n;
    }
}

/// Integral over the hemisphere of (n + 1) / (2 pi) cos^n a min(1, cos_i / cos_o), a from the mirror direction: midpoint
/// rule in the cosine and the azimuth of the light.
double max_phong_albedo(double n, double angle) {
    constexpr int kSteps = 1000;  // wrong by (n / kSteps)^2 / 24 of the peak
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double z = (i + 0.5) / kSteps, across = std::sqrt(1 - z * z);
        const double weight = std::min(1.0, z / std::cos(angle));
        for (int j = 0; j < kSteps / 2; ++j) {
            // Half a turn, for both halves are alike.
            const double cosine =
                across * std::cos(2 * kPi * (j + 0.5) / kSteps) * std::sin(angle) + z * std::cos(angle);
            if (cosine > 0) sum += std::pow(cosine, n) * weight;
        }
    }
    return 2 * (n + 1) * sum / (kSteps * static_cast<double>(kSteps));
}

TEST(P15, MaxPhongHasItsAlbedoAtEveryAngle) {
    // Half of a lobe about the horizon is lost: at grazing view the albedo tends to 1/2.
    constexpr double kQuadratures = 1e-4;
    for (const double n : {1.0, 5.0, 20.0}) {
        for (const int degrees : kAngles) {
            EXPECT_NEAR(albedo(furnace(Lobe::max_phong, n), degrees, 16384, false),
                        max_phong_albedo(n, degrees * kPi / 180), kQuadratures)
                << "exponent " << n << ", " << degrees << " degrees";
        }
    }
    constexpr double kTabulated = 5e-4;  // half a unit of the last digit of the published table
    const double albedos[] = {.667, .661, .593, .532, .503};
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(max_phong_albedo(1, kAngles[i] * kPi / 180), albedos[i], kTabulated);
}

}  // namespace
}  // namespace zerkalo::laws
