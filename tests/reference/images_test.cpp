// Comparing pictures.
#include "tests/support/images.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace zerkalo::reference {
namespace {

Picture gray(int width, int height, double value) {
    return {width, height, std::vector<Rgb<double>>(static_cast<std::size_t>(width) * height, {value, value, value})};
}

TEST(Images, RmseAndMaximumRunOverAllChannels) {
    const Picture a = gray(2, 2, 0.25);
    Picture b = a;
    b.pixels[3].g += 0.5;
    b.pixels[0].b -= 0.125;
    const PictureDifference difference = compare(a, b, 0);
    EXPECT_DOUBLE_EQ(difference.rmse, std::sqrt((0.25 + 0.015625) / 12));
    EXPECT_EQ(difference.max, 0.5);
    EXPECT_EQ(difference.pixels_off_by_more, 2);
    EXPECT_EQ(difference.pixels, 4);
}

TEST(Images, PixelCountsOnceWhenACodeDiffersByMoreThanTheSteps) {
    const Picture dark = gray(1, 1, 0), brighter = gray(1, 1, 3 / 255.0 / 12.92);
    EXPECT_EQ(compare(dark, brighter, 2).pixels_off_by_more, 1);
    EXPECT_EQ(compare(dark, brighter, 3).pixels_off_by_more, 0);
    EXPECT_EQ(compare(gray(1, 1, 1), gray(1, 1, 7), 0).pixels_off_by_more, 0);
}

TEST(Images, NotANumberIsNeverCloseToAnything) {
    const Picture good = gray(1, 1, 0), bad = gray(1, 1, std::numeric_limits<double>::quiet_NaN());
    const PictureDifference difference = compare(bad, good, 255);
    EXPECT_TRUE(std::isnan(difference.rmse));
    EXPECT_TRUE(std::isinf(difference.max));
    EXPECT_EQ(difference.pixels_off_by_more, 1);
}

TEST(Images, DifferentSizesCannotBeCompared) {
    EXPECT_THROW((void)compare(gray(2, 3, 0), gray(3, 2, 0), 0), std::invalid_argument);
}

TEST(Images, CodesFollowTheStandardCurve) {
    EXPECT_EQ(srgb_code(-1), 0);
    EXPECT_EQ(srgb_code(std::numeric_limits<double>::quiet_NaN()), 0);
    EXPECT_EQ(srgb_code(0.0031308), 10);
    EXPECT_EQ(srgb_code(0.214), 127);
    EXPECT_EQ(srgb_code(0.5), 188);
    EXPECT_EQ(srgb_code(1), 255);
    EXPECT_EQ(srgb_code(9), 255);
    EXPECT_EQ(srgb_code(0.4999 / 255 / 12.92), 0);
    EXPECT_EQ(srgb_code(0.5001 / 255 / 12.92), 1);
}

TEST(Images, LinearImageIsReadRowByRow) {
    float rows[2][8] = {{1, 2, 3, 4, 5, 6, -1, -1}, {7, 8, 9, 10, 11, 12, -1, -1}};
    const Picture picture = picture_of({&rows[0][0], 2, 2, sizeof rows[0]});
    ASSERT_EQ(picture.pixels.size(), 4u);
    EXPECT_EQ(picture.at(1, 0).r, 4);
    EXPECT_EQ(picture.at(1, 0).g, 5);
    EXPECT_EQ(picture.at(0, 1).b, 9);
}

TEST(Images, FailureLeavesThreePicturesAndNamesThem) {
    const std::string stem = ::testing::TempDir() + "zerkalo_images_test";
    const std::string message = save_failure(stem, gray(3, 2, 0), gray(3, 2, 1));
    EXPECT_NE(message.find(stem + "-actual.png"), std::string::npos);
    for (const char* kind : {"-actual.png", "-expected.png", "-difference.png"})
        EXPECT_TRUE(std::filesystem::remove(stem + kind)) << kind;
    EXPECT_THROW((void)save_failure("/nowhere/at/all", gray(1, 1, 0), gray(1, 1, 0)), std::runtime_error);
}

}  // namespace
}  // namespace zerkalo::reference
