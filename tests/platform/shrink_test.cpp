// Fitting and box filtering.
#include "platform/shrink.hpp"

#include "tests/platform/random_picture.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace zerkalo {
namespace {

LinearPicture shrunk(LinearPicture& source, std::int32_t width, std::int32_t height) {
    LinearPicture target{width, height, std::vector<float>(static_cast<std::size_t>(3 * width * height), -1)};
    shrink(source.view(), target.view());
    return target;
}

TEST(Shrink, EqualSizeCopiesExactly) {
    LinearPicture source = random_linear(37, 23, 21);
    EXPECT_EQ(shrunk(source, 37, 23).rgb, source.rgb);
}

TEST(Shrink, TargetPixelIsTheMeanOfWhatItCovers) {
    LinearPicture source{4, 2, {}};
    for (int i = 0; i < 8; ++i)
        for (int c = 0; c < 3; ++c) source.rgb.push_back(static_cast<float>(i + 10 * c));
    // Whole pixels: means of {0 1 4 5} and {2 3 6 7}.
    EXPECT_EQ(shrunk(source, 2, 1).rgb, (std::vector<float>{2.5f, 12.5f, 22.5f, 4.5f, 14.5f, 24.5f}));
    // Four columns into three: borders at 4/3 and 8/3 cut columns 1 and 2.
    const LinearPicture three = shrunk(source, 3, 2);
    EXPECT_FLOAT_EQ(three.rgb[0], (0 * 3 + 1 * 1) / 4.0f);
    EXPECT_FLOAT_EQ(three.rgb[3], (1 * 2 + 2 * 2) / 4.0f);
    EXPECT_FLOAT_EQ(three.rgb[6], (2 * 1 + 3 * 3) / 4.0f);
}

TEST(Shrink, MeanOfThePictureStays) {
    for (unsigned seed = 1; seed <= 100; ++seed) {
        std::mt19937 random(seed);
        LinearPicture source = random_linear(static_cast<std::int32_t>(random() % 60 + 1),
                                             static_cast<std::int32_t>(random() % 60 + 1), seed);
        const std::int32_t width = static_cast<std::int32_t>(random() % unsigned(source.width)) + 1;
        const std::int32_t height = static_cast<std::int32_t>(random() % unsigned(source.height)) + 1;
        const LinearPicture target = shrunk(source, width, height);
        const auto mean = [](const LinearPicture& picture) {
            return std::accumulate(picture.rgb.begin(), picture.rgb.end(), 0.0) / double(picture.rgb.size());
        };
        EXPECT_NEAR(mean(target), mean(source), 1e-6)
            << "seed " << seed << ": " << source.width << "x" << source.height << " to " << width << "x" << height;
    }
}

TEST(Fit, KeepsProportionsAndNeverEnlarges) {
    EXPECT_EQ(fit({640, 480}, {80, 46}), (Extent{61, 46}));
    EXPECT_EQ(fit({640, 480}, {40, 46}), (Extent{40, 30}));
    EXPECT_EQ(fit({30, 20}, {80, 46}), (Extent{30, 20}));
    EXPECT_EQ(fit({65536, 1}, {80, 46}), (Extent{80, 1}));
    EXPECT_EQ(fit({1, 65536}, {80, 46}), (Extent{1, 46}));
    for (unsigned seed = 1; seed <= 1000; ++seed) {
        std::mt19937 random(seed);
        const auto side = [&random] { return static_cast<std::int32_t>(random() % 3000) + 1; };
        const Extent picture{side(), side()}, bounds{side(), side()};
        const Extent fitted = fit(picture, bounds);
        EXPECT_GE(fitted.width, 1) << seed;
        EXPECT_GE(fitted.height, 1) << seed;
        EXPECT_LE(fitted.width, std::min(picture.width, bounds.width)) << seed;
        EXPECT_LE(fitted.height, std::min(picture.height, bounds.height)) << seed;
    }
}

}  // namespace
}  // namespace zerkalo
