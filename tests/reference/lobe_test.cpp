// The unpolished mirror: furnace, albedo, distribution of the lobe, sample counts, the limit of perfect polish.
#include "tests/reference/scenes.hpp"

#include <gtest/gtest.h>

namespace zerkalo::reference {
namespace {

Scene glossy(Lobe lobe, double exponent) {
    Scene scene;
    Mirror mirror = ideal_mirror(1);
    mirror.lobe = lobe;
    mirror.lobe_exponent = exponent;
    add(scene, mirror);
    return scene;
}

double seen_at(const Scene& scene, double angle, unsigned samples) {
    const Vector eye{0.5 * std::sin(angle), 0, 0.5 * std::cos(angle)};
    return look(scene, eye, -eye, 1, samples).x;
}

/// Integral over the hemisphere about the normal of (n+1)/(2 pi) cos^n a min(1, cos_w / cos_view), midpoint rule.
double max_phong_albedo(double n, double angle) {
    constexpr int kSteps = 1000;
    const Vector ideal{std::sin(angle), 0, std::cos(angle)};
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = (i + 0.5) / kSteps, sine = std::sqrt(1 - cosine * cosine);
        for (int j = 0; j < kSteps; ++j) {
            const double azimuth = 2 * kPi * (j + 0.5) / kSteps;
            const double cos_a = dot(ideal, {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine});
            if (cos_a > 0) sum += std::pow(cos_a, n) * std::min(1.0, cosine / std::cos(angle));
        }
    }
    return (n + 1) * sum / (kSteps * static_cast<double>(kSteps));
}

TEST(ReferenceLobe, WhiteFurnaceReturnsAllLightFromThePhongLobe) {
    Scene scene = glossy(Lobe::phong, 3);
    scene.background = {1, 1, 1};
    for (const double angle : {0.0, 0.8, 1.5}) EXPECT_NEAR(seen_at(scene, angle, 100), 1, 1e-12) << angle;
}

TEST(ReferenceLobe, DirectionsBelowTheHorizonOfThePhongLobeSeeTheBackground) {
    // Inside a white ball before a black background the clipped lobe of exponent 1 returns (1 + cos) / 2.
    Scene scene = glossy(Lobe::phong, 1);
    add(scene, ball({0, 0, 0}, 9));
    scene.solids[0].material = glowing({1, 1, 1});
    for (const double angle : {0.0, 0.5, 1.0, 1.4})
        EXPECT_NEAR(seen_at(scene, angle, 90000), (1 + std::cos(angle)) / 2, 2e-3) << angle;
}

TEST(ReferenceLobe, MaxPhongReturnsItsAlbedo) {
    for (const double n : {1.0, 10.0, 100.0}) {
        Scene scene = glossy(Lobe::max_phong, n);
        scene.background = {1, 1, 1};
        EXPECT_NEAR(seen_at(scene, 0, 40000), (n + 1) / (n + 2), 1e-3) << n;
        for (const double angle : {0.5, 1.0, 1.4})
            EXPECT_NEAR(seen_at(scene, angle, 40000), max_phong_albedo(n, angle), 3e-3) << n << " at " << angle;
    }
}

/// Integral over the hemisphere of D(h) G2 / (4 cos_view), h half-way between viewer and light: midpoint rule.
double ggx_albedo(double alpha, double angle) {
    constexpr int kSteps = 1000;
    const Vector viewer{std::sin(angle), 0, std::cos(angle)};
    const auto lambda = [&](double cosine) {
        return (std::sqrt(1 + alpha * alpha * (1 / (cosine * cosine) - 1)) - 1) / 2;
    };
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = (i + 0.5) / kSteps, sine = std::sqrt(1 - cosine * cosine);
        for (int j = 0; j < kSteps; ++j) {
            const double azimuth = 2 * kPi * (j + 0.5) / kSteps;
            const Vector light{sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
            const double facet = normalized(viewer + light).z;
            const double base = 1 + (alpha * alpha - 1) * facet * facet;
            const double density = alpha * alpha / (kPi * base * base);
            sum += density / (4 * viewer.z * (1 + lambda(viewer.z) + lambda(cosine)));
        }
    }
    return 2 * kPi * sum / (kSteps * static_cast<double>(kSteps));
}

TEST(ReferenceLobe, GgxReturnsItsAlbedo) {
    for (const double alpha : {0.2, 0.5, 1.0}) {
        Scene scene = glossy(Lobe::ggx, (1 / (alpha * alpha) - 1) / 2);
        scene.background = {1, 1, 1};
        for (const double angle : {0.0, 0.5, 1.0, 1.3})
            EXPECT_NEAR(seen_at(scene, angle, 160000), ggx_albedo(alpha, angle), 3e-3) << alpha << " at " << angle;
    }
}

TEST(ReferenceLobe, DirectionsAreUnitVectorsWithTheMomentsOfTheDensity) {
    const Vector ideal = normalized({0.2, -0.7, 0.4});
    for (const double n : {0.0, 1.0, 40.0, 1e6})
        for (const unsigned count : {40000u, 39800u}) {
            Random random(kSeed);
            double deviation = 0;
            Vector mean;
            for (const Vector& w : lobe_directions(ideal, n, count, random)) {
                ASSERT_NEAR(length(w), 1, 1e-12);
                deviation += (1 - dot(w, ideal)) / count;
                mean = mean + 1.0 / count * w;
            }
            EXPECT_NEAR(deviation * (n + 2), 1, 1e-2) << n;
            EXPECT_LT(length(mean - dot(mean, ideal) * ideal), 2e-3) << n;
        }
}

TEST(ReferenceLobe, StratifiedSamplesStayUnbiasedForEveryCount) {
    Scene scene = glossy(Lobe::max_phong, 2);
    scene.background = {1, 1, 1};
    const Tracer tracer_of_three(scene, depth(1), 3), tracer_of_seven(scene, depth(1), 7);
    Random random(kSeed);
    const Ray down{{0, 0, 1}, {0, 0, -1}};
    for (const Tracer* tracer : {&tracer_of_three, &tracer_of_seven}) {
        double mean = 0;
        for (int i = 0; i < 40000; ++i) mean += tracer->radiance(down, random).x / 40000;
        EXPECT_NEAR(mean, 0.75, 2e-3);
    }
}

TEST(ReferenceLobe, FirstGlossyMirrorTakesAllSamplesAndLaterOnesOne) {
    constexpr unsigned kSamples = 9;
    Scene scene = glossy(Lobe::max_phong, 1e8);
    Mirror opposite = scene.mirrors[0];
    opposite.position = {0, 0, 1};
    opposite.normal = {0, 0, -1};
    add(scene, opposite);
    Random used(kSeed), expected(kSeed);
    Tracer(scene, depth(2), kSamples).radiance({{0, 0, 0.5}, {0, 0, -1}}, used);
    // Two numbers a direction: kSamples of them at the first mirror, one a ray at the second.
    expected.discard(2 * kSamples + 2 * kSamples);
    EXPECT_EQ(used, expected);
}

TEST(ReferenceLobe, SharpMirrorBeforeAGlossyOneLeavesItAllSamples) {
    constexpr unsigned kSamples = 9;
    Scene scene = glossy(Lobe::max_phong, kInfinity);
    Mirror opposite = scene.mirrors[0];
    opposite.lobe_exponent = 1e8;
    opposite.position = {0, 0, 1};
    opposite.normal = {0, 0, -1};
    add(scene, opposite);
    Random used(kSeed), expected(kSeed);
    Tracer(scene, depth(3), kSamples).radiance({{0, 0, 0.5}, {0, 0, -1}}, used);
    expected.discard(2 * kSamples);
    EXPECT_EQ(used, expected);
}

TEST(ReferenceLobe, GrowingExponentApproachesTheSharpMirror) {
    Scene sharp = glossy(Lobe::max_phong, kInfinity);
    add(sharp, ball({0.3, 0.1, 2}, 1));
    add(sharp, lamp({3, 1, 0.5}));
    double before = 1;
    for (const double n : {1e2, 1e4, 1e6}) {
        Scene rough = sharp;
        rough.mirrors[0].lobe_exponent = n;
        const double error = std::abs(seen_at(rough, 0.2, 10000) - seen_at(sharp, 0.2, 1));
        EXPECT_LT(error, before / 10) << n;
        before = error;
    }
    EXPECT_LT(before, 1e-5);
}

}  // namespace
}  // namespace zerkalo::reference
