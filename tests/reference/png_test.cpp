// libpng reads back what the tests' own PNG writer wrote.
#include "tests/support/images.hpp"

#include <gtest/gtest.h>

#include <png.h>

#include <cstdio>
#include <string>

namespace zerkalo::reference {
namespace {

struct Decoded {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> codes;
};

Decoded decoded(const std::string& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    Decoded result;
    if (png_image_begin_read_from_file(&image, path.c_str())) {
        image.format = PNG_FORMAT_RGB;
        result = {image.width, image.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
        png_image_finish_read(&image, nullptr, result.codes.data(), 0, nullptr);
    }
    EXPECT_EQ(image.warning_or_error, 0u) << path << ": " << image.message;
    std::remove(path.c_str());
    return result;
}

TEST(Png, LibpngReadsEveryCodeBack) {
    // 200 x 120 x 3 bytes: more than one stored block.
    Picture picture{200, 120, {}};
    for (int i = 0; i < 200 * 120; ++i) {
        const double v = i / 24000.0;
        picture.pixels.push_back({v, 1 - v, v * v});
    }
    const std::string path = ::testing::TempDir() + "zerkalo_png_test.png";
    write_png(path, picture);
    const Decoded read = decoded(path);
    EXPECT_EQ(read.width, 200u);
    EXPECT_EQ(read.height, 120u);
    ASSERT_EQ(read.codes.size(), 200u * 120 * 3);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        ASSERT_EQ(read.codes[3 * i], srgb_code(picture.pixels[i].r)) << i;
        ASSERT_EQ(read.codes[3 * i + 1], srgb_code(picture.pixels[i].g)) << i;
        ASSERT_EQ(read.codes[3 * i + 2], srgb_code(picture.pixels[i].b)) << i;
    }
}

TEST(Png, DifferencePictureShowsCodesApartTimesEight) {
    const auto code = [](int steps) { return steps / 255.0 / 12.92; };
    const Picture actual{2, 1, {{code(3), code(0), code(5)}, {1, 0.5, 0}}};
    const Picture expected{2, 1, {{code(1), code(4), code(5)}, {0, 0.5, 0}}};
    const std::string stem = ::testing::TempDir() + "zerkalo_png_test";
    save_failure(stem, actual, expected);
    EXPECT_EQ(decoded(stem + "-actual.png").codes, (std::vector<std::uint8_t>{3, 0, 5, 255, 188, 0}));
    EXPECT_EQ(decoded(stem + "-expected.png").codes, (std::vector<std::uint8_t>{1, 4, 5, 0, 188, 0}));
    EXPECT_EQ(decoded(stem + "-difference.png").codes, (std::vector<std::uint8_t>{16, 32, 0, 255, 0, 0}));
}

}  // namespace
}  // namespace zerkalo::reference
