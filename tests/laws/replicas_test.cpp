// Pictures in passes where a pass alone tells nothing of its error: whole passes are replicas of one another.
#include "tests/laws/passes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace zerkalo::laws {
namespace {

constexpr int kWidth = 52, kHeight = 36;  // whole tiles, and a part of one at each edge
constexpr int kLargeWidth = 80, kLargeHeight = 60;  // what one picture is off by is luck if it has few tiles
constexpr std::int32_t kApart = 31;                 // from rotation to rotation: more than a picture takes

Settings placed_by(Estimator estimator, int width = kWidth, int height = kHeight) {
    Settings settings = of_size(width, height);
    settings.estimator = estimator;
    return settings;
}

/// Passes of a kind of numbers, their rays placed by a rule.
template <class AnyPasses, Estimator rule>
struct Kind {
    using Work = AnyPasses;
    static constexpr Estimator kRule = rule;
};
template <class T>
class Replicas : public testing::Test {};
using Kinds = testing::Types<Kind<Passes, Estimator::sobol>, Kind<Passes, Estimator::jittered>,
                             Kind<FixedPasses, Estimator::fibonacci>, Kind<FixedPasses, Estimator::sobol>,
                             Kind<FixedPasses, Estimator::random>, Kind<DoublePasses, Estimator::r2>>;
TYPED_TEST_SUITE(Replicas, Kinds);

// What progressive.hpp says of its estimate, from the passes rendered apart.
TYPED_TEST(Replicas, TheEstimateIsTheSpreadOfThePassesThemselves) {
    using Work = typename TypeParam::Work;
    for (const auto& [name, scene] : unpolished_scenes()) {
        Settings settings = placed_by(TypeParam::kRule);
        Work work(scene, settings);
        ASSERT_FALSE(work.tells()) << name;
        work.survey();
        std::vector<Image> passes;
        for (settings.rotation = 0; settings.rotation < kReplicas; ++settings.rotation) {
            passes.push_back(Work(scene, settings).single(kReplicaSamples));
        }
        double variance = 0;
        for (std::size_t i = 0; i < passes.front().rgb.size(); ++i) {
            double mean = 0, squares = 0;
            for (const Image& pass : passes) mean += double(pass.rgb[i]) / kReplicas;
            for (const Image& pass : passes) squares += std::pow(double(pass.rgb[i]) - mean, 2);
            variance += squares / (kReplicas - 1) / kReplicas;
            ASSERT_NEAR(work.picture().rgb[i], mean, 1e-6 * std::max(1.0, mean)) << name << ": value " << i;
        }
        const double expected = std::sqrt(variance / double(passes.front().rgb.size()));
        EXPECT_NEAR(work.estimate(), expected, 1e-5 * expected) << name;
    }
}

TYPED_TEST(Replicas, TheVariancesOfThePixelsAreTogetherThatOfThePicture) {
    for (const auto& [name, scene] : unpolished_scenes()) {
        typename TypeParam::Work work(scene, placed_by(TypeParam::kRule));
        const double error = work.refine(0.002);
        double sum = 0;
        for (const float variance : work.variances()) sum += double(variance);
        const double expected = 3.0 * kWidth * kHeight * error * error;
        EXPECT_NEAR(sum, expected, 1e-5 * expected) << name;
    }
}

// The law of the estimate, by many pictures: every scene, several errors asked for, several placements of the rays.
TYPED_TEST(Replicas, TheEstimateIsWithinAFactorOfThreeHalvesInNineteenOfTwenty) {
    JudgedEstimates all;
    for (const auto& [name, scene] : unpolished_scenes()) {
        Settings settings = placed_by(TypeParam::kRule, kLargeWidth, kLargeHeight);
        const Image& limit = limit_of(name, kLargeWidth, kLargeHeight);
        for (const double error : {0.006, 0.002, 0.0007}) {
            for (settings.rotation = 0; settings.rotation < 4 * kApart; settings.rotation += kApart) {
                typename TypeParam::Work work(scene, settings);
                const double estimate = work.refine(error);
                all.judge(name, error, estimate, distance(work.picture(), limit));
            }
        }
    }
    all.expect_nineteen_of_twenty();
}

// Over all scenes and placements, the mean square of the estimates is that of the errors: also where the lobe rays of
// a pixel's camera rays are one lattice, of which a rotation must leave nothing in its place.
TYPED_TEST(Replicas, TheEstimateIsRightOnAverageWithSeveralCameraRays) {
    constexpr int kPlacements = 6;
    double logarithms = 0;
    for (const auto& [name, scene] : unpolished_scenes()) {
        Settings settings = of_size(kWidth, kHeight);
        settings.antialias = 16;
        const Image limit = converged(scene, settings);
        settings.estimator = TypeParam::kRule;
        double estimated = 0, truth = 0;
        for (settings.rotation = 0; settings.rotation < kPlacements * kApart; settings.rotation += kApart) {
            typename TypeParam::Work work(scene, settings);
            work.survey();
            estimated += std::pow(work.estimate(), 2);
            truth += std::pow(distance(work.picture(), limit), 2);
        }
        logarithms += std::log(truth / estimated) / 2;
    }
    EXPECT_NEAR(logarithms / double(unpolished_scenes().size()), 0, std::log(1.2));
}

TYPED_TEST(Replicas, TheErrorThatIsAskedForIsReached) {
    constexpr double kError = 0.002, kNotQuite = 1.1;
    constexpr std::int32_t kPlacements = 8;
    for (const auto& [name, scene] : unpolished_scenes()) {
        Settings settings = placed_by(TypeParam::kRule, kLargeWidth, kLargeHeight);
        const Image& limit = limit_of(name, kLargeWidth, kLargeHeight);
        double squares = 0;
        for (settings.rotation = 0; settings.rotation < kPlacements * kApart; settings.rotation += kApart) {
            typename TypeParam::Work work(scene, settings);
            work.refine(kError);
            squares += std::pow(distance(work.picture(), limit), 2);
        }
        EXPECT_LE(std::sqrt(squares / kPlacements), kNotQuite * kError) << name;
    }
}

TYPED_TEST(Replicas, EveryInstructionSetAndOrderGivesTheSameBytes) {
    using Work = typename TypeParam::Work;
    for (const auto& [name, scene] : unpolished_scenes()) {
        Work serial(scene, placed_by(TypeParam::kRule), Isa::scalar);
        const double estimate = serial.refine(0.002);
        for (const Isa isa : available_isas()) {
            Work backwards(scene, placed_by(TypeParam::kRule), isa);
            backwards.reverse_tiles();
            EXPECT_EQ(backwards.refine(0.002), estimate) << name << ": " << name_of(isa);
            EXPECT_EQ(backwards.picture().hash(), serial.picture().hash()) << name << ": " << name_of(isa);
            EXPECT_EQ(backwards.variances(), serial.variances()) << name << ": " << name_of(isa);
        }
    }
}

// Also between two passes of the survey.
TYPED_TEST(Replicas, ResumedIsTheSameAsUninterrupted) {
    using Work = typename TypeParam::Work;
    constexpr double kError = 0.0015;
    for (const auto& [name, scene] : unpolished_scenes()) {
        const Settings settings = placed_by(TypeParam::kRule);
        Work once(scene, settings), first(scene, settings), second(scene, settings);
        once.refine(kError);
        Work *now = &first, *then = &second;
        const auto change = [&] {
            then->resume(*now);
            std::swap(now, then);
        };
        for (int k = 0; k < kReplicas; ++k) {
            now->survey_pass(k);
            change();
        }
        while (now->estimate() > kError && now->plan(kError)) {
            change();
            now->round();
        }
        EXPECT_EQ(now->picture().hash(), once.picture().hash()) << name;
        EXPECT_EQ(now->variances(), once.variances()) << name;
    }
}

TYPED_TEST(Replicas, UnknownBeforeTheSurveyIsComplete) {
    for (const auto& [name, scene] : unpolished_scenes()) {
        typename TypeParam::Work work(scene, placed_by(TypeParam::kRule));
        for (int k = 0; k < kReplicas; ++k) {
            EXPECT_TRUE(std::isinf(work.estimate())) << name << ", " << k << " passes";
            work.survey_pass(k);
        }
        EXPECT_TRUE(std::isfinite(work.estimate())) << name;
        EXPECT_GT(work.estimate(), 0) << name;
    }
}

// A tile without lobe rays has nothing to tell: one pass is all it gets, and its pixels are those of any picture.
TYPED_TEST(Replicas, WhatNeedsNoLobeRayIsExactAfterOnePass) {
    for (const auto& [name, scene] : unpolished_scenes()) {
        typename TypeParam::Work work(scene, placed_by(TypeParam::kRule));
        work.refine(0.001);
        for (const TileProgress& tile : work.tiles()) {
            if (tile.hits == 0) {
                EXPECT_EQ(tile.passes, 1) << name;
                EXPECT_EQ(tile.variance, 0) << name;
            } else {
                EXPECT_GE(tile.passes, kReplicas) << name;
            }
        }
        typename TypeParam::Work sharp(sharpened(scene), placed_by(TypeParam::kRule));
        sharp.survey();
        EXPECT_EQ(sharp.estimate(), 0) << name;
        EXPECT_FALSE(sharp.plan(1e-9)) << name;
        for (const TileProgress& tile : sharp.tiles()) EXPECT_EQ(tile.passes, 1) << name;
    }
}

// A tile of which few rays agree by luck still gets its share.
TYPED_TEST(Replicas, NoTileStopsAtTheSurveyForGood) {
    for (const auto& [name, scene] : unpolished_scenes()) {
        typename TypeParam::Work work(scene, placed_by(TypeParam::kRule));
        work.survey();
        work.refine(work.estimate() / 12);
        for (const TileProgress& tile : work.tiles()) {
            if (tile.hits == 0) continue;
            EXPECT_GT(tile.samples, kReplicas * kReplicaSamples) << name;
        }
    }
}

}  // namespace
}  // namespace zerkalo::laws
