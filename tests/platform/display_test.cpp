// A linear picture on its way to a display, and the display in memory.
#include "platform/memory_display.hpp"

#include "tests/platform/random_picture.hpp"

#include <gtest/gtest.h>

namespace zerkalo {
namespace {

std::vector<std::uint8_t> resolved(LinearPicture& picture) {
    std::vector<std::uint8_t> codes(picture.rgb.size());
    resolve8(picture.rgb.data(), codes.data(), codes.size());
    return codes;
}

// Widths on both sides of one row a band.
TEST(Display, BandsGiveTheResolvedPicture) {
    for (const Extent& extent : {Extent{1, 1}, {7, 3}, {640, 70}, {21845, 3}, {21846, 3}, {30000, 2}}) {
        LinearPicture picture = random_linear(extent.width, extent.height, 11);
        MemoryDisplay display(extent);
        ASSERT_TRUE(present_linear(display, picture.view()).ok());
        EXPECT_EQ(display.bytes(), resolved(picture)) << extent.width << "x" << extent.height;
    }
}

// A display that is larger than any part, to see what is sent.
struct RowCounter {
    std::int32_t rows = 0;
    Extent extent() const { return {65536, 65536}; }
    PixelFormat format() const { return kXrgb8888; }
    IoStatus present(const SrgbPart& part, const Point& at) {
        EXPECT_EQ(at.y, rows);
        rows += part.height;
        return {};
    }
};

TEST(Display, BandsEndWithThePicture) {
    for (const std::int32_t height : {1, 33, 34, 35, 68, 70}) {
        LinearPicture picture = random_linear(640, height, 16);
        RowCounter display;
        ASSERT_TRUE(present_linear(display, picture.view()).ok());
        EXPECT_EQ(display.rows, height);
    }
}

TEST(Display, PictureIsPlacedWhereItIsAsked) {
    LinearPicture picture = random_linear(2, 2, 12);
    const std::vector<std::uint8_t> codes = resolved(picture);
    MemoryDisplay display({4, 5});
    ASSERT_TRUE(present_linear(display, picture.view(), {1, 2}).ok());
    std::vector<unsigned char> expected(60, 0);
    std::copy(codes.begin(), codes.begin() + 6, expected.begin() + 2 * 12 + 3);
    std::copy(codes.begin() + 6, codes.end(), expected.begin() + 3 * 12 + 3);
    EXPECT_EQ(display.bytes(), expected);
}

TEST(Display, ClearMakesEveryPixelBlack) {
    PixelFormat opaque = kXrgb8888;
    opaque.fill = 0xff000000u;
    MemoryDisplay display({5, 3}, opaque);
    const RandomCodes picture(5, 3, 13);
    ASSERT_TRUE(display.present(picture.all(), {0, 0}).ok());
    ASSERT_TRUE(clear(display).ok());
    for (std::size_t i = 0; i < 15; ++i) {
        EXPECT_EQ(display.bytes()[4 * i], 0);
        EXPECT_EQ(display.bytes()[4 * i + 1], 0);
        EXPECT_EQ(display.bytes()[4 * i + 2], 0);
        EXPECT_EQ(display.bytes()[4 * i + 3], 255);
    }
}

TEST(MemoryDisplay, CodesAreWhatWasPresented) {
    const RandomCodes picture(6, 4, 14);
    MemoryDisplay display({6, 4});
    ASSERT_TRUE(display.present(picture.all(), {0, 0}).ok());
    const SrgbPart codes = display.codes();
    for (std::int32_t y = 0; y < 4; ++y)
        EXPECT_TRUE(std::equal(codes.row(y), codes.row(y) + 18, picture.all().row(y))) << y;
}

// A display that fails: the reason comes through, and nothing more is sent.
struct BrokenDisplay {
    int calls = 0;
    Extent extent() const { return {640, 480}; }
    PixelFormat format() const { return kXrgb8888; }
    IoStatus present(const SrgbPart&, const Point&) {
        ++calls;
        return io_failure("display", "unplugged");
    }
};

TEST(Display, FirstFailureEndsThePicture) {
    LinearPicture picture = random_linear(640, 480, 15);
    BrokenDisplay display;
    EXPECT_STREQ(present_linear(display, picture.view()).text, "display: unplugged");
    EXPECT_EQ(display.calls, 1);
}

TEST(IoStatus, LongPlaceLosesItsBeginningNeverTheReason) {
    const std::string place = std::string(5000, 'a') + "/end.png";
    const std::string text = io_failure(place.c_str(), "cannot write", 28).text;
    EXPECT_LT(text.size(), IoStatus::kCapacity);
    EXPECT_EQ(text.substr(0, 4), "...a");
    EXPECT_NE(text.find("/end.png: cannot write: No space left on device"), std::string::npos) << text;
}

}  // namespace
}  // namespace zerkalo
