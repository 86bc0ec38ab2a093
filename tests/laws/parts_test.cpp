// How much better the interleaved parts of a lobe's rays are together than each alone: by what their spread is made the
// variance of a picture (core/render/progressive.cpp), scene by scene.
#include "tests/laws/passes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace zerkalo::laws {
namespace {

constexpr int kWidth = 80, kHeight = 60, kRotations = 4;

/// The mean square error of frames of so many samples over what they say that it is.
double truth_over_estimate(const ShippedScene& shipped, std::int32_t samples) {
    double squares = 0, estimates = 0;
    for (std::int32_t rotation = 0; rotation < kRotations; ++rotation) {
        Settings settings = of_size(kWidth, kHeight);
        settings.rotation = rotation;
        Passes work(shipped.scene, settings);
        const double off = distance(work.single(samples), limit_of(shipped.name, kWidth, kHeight));
        squares += off * off;
        estimates += work.estimate() * work.estimate();
    }
    return squares / estimates;
}

TEST(Parts, TellTheVarianceOfAPictureByOneTable) {
    for (const ShippedScene& shipped : unpolished_scenes()) {
        std::string line = shipped.name;
        for (const std::int32_t samples : {4, 8, 16, 32, 64, 128}) {
            const double ratio = truth_over_estimate(shipped, samples);
            char text[16];
            std::snprintf(text, sizeof text, " %.2f", ratio);
            line += text;
            // A factor of 1.5 in the error.
            EXPECT_LT(ratio, 2.25) << shipped.name << ", " << samples << " samples";
            EXPECT_GT(ratio, 1 / 2.25) << shipped.name << ", " << samples << " samples";
        }
        std::printf("%s\n", line.c_str());
    }
}

}  // namespace
}  // namespace zerkalo::laws
