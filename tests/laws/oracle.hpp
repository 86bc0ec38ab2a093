// A sharp picture against the reference tracer: how many pixels may differ, and what to look at when more do.
#pragma once

#include "tests/laws/rendering.hpp"
#include "tests/support/reference.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zerkalo::laws {

/// Pixels on silhouettes and shadow edges: there a rounding decides which of two surfaces the pixel's centre sees.
constexpr double kSilhouetteShare = 1e-3;
/// 8-bit steps that rounding alone may cause: a value next to the border of two codes.
constexpr int kRoundingSteps = 1;

/// Expects a picture without lobes to be that of the reference tracer but for its silhouettes.
inline void expect_agreement(const std::string& name, const Scene& scene, const Settings& settings) {
    constexpr std::uint64_t kUnusedSeed = 1;
    const reference::Picture actual = picture_of(render(scene, settings));
    const reference::Picture expected = reference_picture(scene, settings, 1, kUnusedSeed);
    const auto difference = reference::compare(actual, expected, kRoundingSteps);
    EXPECT_LE(static_cast<double>(difference.pixels_off_by_more), kSilhouetteShare * difference.pixels)
        << name << ": " << reference::save_failure(testing::TempDir() + "zerkalo-" + name, actual, expected);
}

}  // namespace zerkalo::laws
