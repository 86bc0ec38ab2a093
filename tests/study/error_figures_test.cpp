// The figures of error on pictures whose errors are known.
#include "tools/study/error_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::study {
namespace {

LightPicture grey(double value, std::int32_t width = 40, std::int32_t height = 25) {
    return {width, height,
            std::vector<double>(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value)};
}
Mask whole(const LightPicture& picture) { return Mask(picture.rgb.size() / 3, true); }

TEST(StudyErrors, AConstantOffsetIsEveryFigure) {
    const LightPicture a = grey(0.25), b = grey(0.375);
    const ErrorFigures figures = error_figures(a, b, whole(a));
    EXPECT_DOUBLE_EQ(figures.rmse, 0.125);
    EXPECT_DOUBLE_EQ(figures.max, 0.125);
    EXPECT_DOUBLE_EQ(figures.p999, 0.125);
}

TEST(StudyErrors, OneWrongChannelIsToldFromTheRest) {
    const LightPicture a = grey(0.5);
    LightPicture b = a;
    b.rgb[3 * 123 + 1] = 0.8;
    const ErrorFigures figures = error_figures(a, b, whole(a));
    EXPECT_NEAR(figures.rmse, 0.3 / std::sqrt(3000.0), 1e-12);
    EXPECT_NEAR(figures.max, 0.3, 1e-12);
    EXPECT_EQ(figures.p999, 0);  // 2999 of 3000 values are right
}

TEST(StudyErrors, OnlyTheMaskCounts) {
    const LightPicture a = grey(0.5);
    LightPicture b = a;
    b.rgb[3 * 10] = 0.7;
    Mask mask(a.rgb.size() / 3, false);
    mask[11] = true;
    EXPECT_EQ(error_figures(a, b, mask).rmse, 0);
    EXPECT_TRUE(std::isinf(error_figures(a, b, mask).psnr));
    mask[10] = true;
    EXPECT_NEAR(error_figures(a, b, mask).rmse, 0.2 / std::sqrt(6.0), 1e-12);
    const ErrorFigures none = error_figures(a, b, Mask(mask.size(), false));
    EXPECT_EQ(none.rmse, 0);
    EXPECT_EQ(none.max, 0);
}

// sRGB of 1 is code 65535 and of 0 code 0: the whole range apart is 0 dB.
TEST(StudyErrors, PsnrIsThatOfTheCodes) {
    EXPECT_NEAR(error_figures(grey(0), grey(1), whole(grey(0))).psnr, 0, 1e-9);
    // 0.5 in sRGB is linear ((0.5 + 0.055) / 1.055)^2.4.
    const double half = std::pow((0.5 + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(error_figures(grey(0), grey(half), whole(grey(0))).psnr, 20 * std::log10(2), 1e-3);
}

// On a ramp the errors of rounding are even: a step of the code over sqrt(12), times the slope of the curve.
TEST(StudyErrors, QuantisationFallsWithTheBits) {
    LightPicture ramp = grey(0, 256, 64);
    for (std::size_t i = 0; i < ramp.rgb.size(); ++i) {
        ramp.rgb[i] = (static_cast<double>(i) + 0.5) / static_cast<double>(ramp.rgb.size());
    }
    const Mask mask = whole(ramp);
    double last = 1;
    for (const int bits : {8, 10, 16}) {
        const double error = rmse_of(quantised(ramp, bits), ramp, mask);
        // Mean square of d(linear)/d(code) over linear light: 2.4 l^(1 - 1/2.4) / 1.055 nearly.
        const double expected = std::exp2(-bits) / std::sqrt(12.0) * 2.4 / 1.055 / std::sqrt(1 + 2 * (1 - 1 / 2.4));
        EXPECT_NEAR(error / expected, 1, 0.05) << bits;
        EXPECT_LT(error, last / 3) << bits;
        last = error;
    }
    EXPECT_EQ(rmse_of(quantised(grey(1), 10), grey(1), whole(grey(1))), 0);
}

TEST(StudyErrors, ClippingHoldsLightWithinWhatCodesHold) {
    const LightPicture bright = clipped(grey(3)), dark = clipped(grey(-1));
    EXPECT_EQ(bright.rgb[5], 1);
    EXPECT_EQ(dark.rgb[5], 0);
}

}  // namespace
}  // namespace zerkalo::study
