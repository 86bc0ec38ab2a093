// Packing: values by hand, the general path against the instantiated ones, dither, clipping, guard bytes.
#include "platform/pixel.hpp"

#include "tests/platform/random_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace zerkalo {
namespace {

constexpr PixelFormat kNamed[] = {kXrgb8888, kXbgr8888, kRgb565, kBgr565, kRgb888, kBgr888};

std::vector<unsigned char> packed_pixel(const PixelFormat& format, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    const std::uint8_t rgb[3] = {r, g, b};
    std::vector<unsigned char> bytes(format.bytes);
    pack_part(format, bytes.data(), bytes.size(), {1, 1}, {rgb, 1, 1, 3}, {0, 0});
    return bytes;
}

// One pixel by the masks as the kernel's documentation describes them, bit by bit.
std::vector<unsigned char> pixel_bit_by_bit(const PixelFormat& format, const std::uint8_t* rgb, std::int32_t x,
                                            std::int32_t y) {
    std::vector<unsigned char> bytes(format.bytes, 0);
    const Channel channels[] = {format.red, format.green, format.blue};
    for (int c = 0; c < 3; ++c)
        for (int bit = 0; bit < channels[c].length; ++bit)
            if ((quantise(rgb[c], channels[c].length, x, y) >> bit & 1) != 0) {
                const int position = channels[c].offset + bit;
                bytes[static_cast<std::size_t>(position / 8)] |= static_cast<unsigned char>(1 << position % 8);
            }
    for (int position = 0; position < 8 * format.bytes; ++position)
        if ((format.fill >> position & 1) != 0)
            bytes[static_cast<std::size_t>(position / 8)] |= static_cast<unsigned char>(1 << position % 8);
    return bytes;
}

TEST(Pixel, NamedFormatsLieInMemoryAsTheKernelSays) {
    using Bytes = std::vector<unsigned char>;
    EXPECT_EQ(packed_pixel(kXrgb8888, 1, 2, 3), (Bytes{3, 2, 1, 0}));
    EXPECT_EQ(packed_pixel(kXbgr8888, 1, 2, 3), (Bytes{1, 2, 3, 0}));
    EXPECT_EQ(packed_pixel(kRgb888, 1, 2, 3), (Bytes{3, 2, 1}));
    EXPECT_EQ(packed_pixel(kBgr888, 1, 2, 3), (Bytes{1, 2, 3}));
    EXPECT_EQ(packed_pixel(kRgb565, 255, 0, 0), (Bytes{0x00, 0xf8}));
    EXPECT_EQ(packed_pixel(kRgb565, 0, 255, 0), (Bytes{0xe0, 0x07}));
    EXPECT_EQ(packed_pixel(kBgr565, 255, 0, 0), (Bytes{0x1f, 0x00}));
    EXPECT_EQ(packed_pixel(kBgr565, 0, 0, 255), (Bytes{0x00, 0xf8}));
}

TEST(Pixel, FillIsAddedToEveryPathAlike) {
    PixelFormat argb = kXrgb8888;
    argb.fill = 0xff000000u;
    EXPECT_EQ(packed_pixel(argb, 1, 2, 3), (std::vector<unsigned char>{3, 2, 1, 255}));
    EXPECT_STREQ(name_of(argb), "XRGB8888");
}

// Every order of the three channels, at every place where they fit side by side, in every pixel size: the named
// formats are among them.
TEST(Pixel, EveryMaskPermutationIsPackedBitByBit) {
    const RandomCodes picture(9, 9, 1401);
    int checked = 0, named = 0;
    for (int bytes = 1; bytes <= 4; ++bytes)
        for (const std::array<int, 3>& lengths : {std::array{8, 8, 8}, {5, 6, 5}, {5, 5, 5}, {3, 3, 2}, {10, 10, 10}}) {
            std::array<int, 3> order{0, 1, 2};
            do {
                const int room = 8 * bytes - lengths[0] - lengths[1] - lengths[2];
                for (int gap = 0; gap <= room; ++gap) {
                    Channel channels[3];
                    int offset = gap;
                    for (const int c : order) {
                        const std::size_t index = static_cast<std::size_t>(c);
                        channels[c] = {static_cast<std::uint8_t>(offset), static_cast<std::uint8_t>(lengths[index])};
                        offset += lengths[index];
                    }
                    const PixelFormat format{static_cast<std::uint8_t>(bytes), channels[0], channels[1], channels[2],
                                             0};
                    std::vector<unsigned char> memory(static_cast<std::size_t>(81 * bytes));
                    pack_part(format, memory.data(), static_cast<std::size_t>(9 * bytes), {9, 9}, picture.all(),
                              {0, 0});
                    for (int i = 0; i < 81; ++i) {
                        const auto expected = pixel_bit_by_bit(format, picture.rgb.data() + 3 * i, i % 9, i / 9);
                        ASSERT_TRUE(std::equal(expected.begin(), expected.end(), memory.begin() + i * bytes))
                            << bytes << " bytes, red " << +format.red.offset << ", green " << +format.green.offset
                            << ", blue " << +format.blue.offset << ", pixel " << i;
                    }
                    ++checked;
                    named += std::count(std::begin(kNamed), std::end(kNamed), format) != 0;
                }
            } while (std::next_permutation(order.begin(), order.end()));
        }
    EXPECT_EQ(named, 6);
    EXPECT_GT(checked, 150);
}

TEST(Pixel, QuantisingKeepsBlackWhiteAndEightBits) {
    for (int length = 1; length <= 16; ++length)
        for (std::int32_t i = 0; i < 64; ++i) {
            EXPECT_EQ(quantise(0, length, i % 8, i / 8), 0u) << length;
            EXPECT_EQ(quantise(255, length, i % 8, i / 8), (1u << length) - 1) << length;
        }
    for (int code = 0; code < 256; ++code)
        EXPECT_EQ(quantise(static_cast<std::uint8_t>(code), 8, 3, 5), unsigned(code));
}

TEST(Pixel, MoreThanEightBitsAreRoundedToTheNearestLevel) {
    for (int length = 9; length <= 16; ++length)
        for (int code = 0; code < 256; ++code) {
            const double exact = code * ((1 << length) - 1) / 255.0;
            EXPECT_EQ(quantise(static_cast<std::uint8_t>(code), length, 1, 2), unsigned(std::lround(exact))) << code;
        }
}

TEST(Pixel, DitherMeansWhatTheCodeMeans) {
    for (int length = 1; length < 8; ++length)
        for (int code = 0; code < 256; ++code) {
            double sum = 0;
            const double exact = code * ((1 << length) - 1) / 255.0;
            for (std::int32_t i = 0; i < 64; ++i) {
                const double level = quantise(static_cast<std::uint8_t>(code), length, i % 8 + 800, i / 8 + 1600);
                EXPECT_LT(std::abs(level - exact), 1.0);
                sum += level;
            }
            EXPECT_NEAR(sum / 64, exact, 1.0 / 64) << "code " << code << ", " << length << " bits";
        }
}

TEST(Pixel, DitherOfHalfAStepIsACheckerboard) {
    // With 7 bits code 1 lies half a step up: half of the matrix rounds up.
    int up = 0;
    for (std::int32_t y = 0; y < 8; ++y)
        for (std::int32_t x = 0; x < 8; ++x) {
            const bool is_up = quantise(1, 7, x, y) == 1;
            up += is_up;
            EXPECT_EQ(is_up, quantise(1, 7, x + 2, y) == 1) << x << "," << y;
            EXPECT_NE(is_up, quantise(1, 7, x + 1, y) == 1) << x << "," << y;
            EXPECT_NE(is_up, quantise(1, 7, x, y + 1) == 1) << x << "," << y;
        }
    EXPECT_EQ(up, 32);
}

// Cut a random picture into random tiles in random order: same bytes, and the guard bytes between rows are intact.
TEST(Pixel, AnyTilingGivesTheSameBytes) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        std::mt19937 random(seed);
        const auto upto = [&random](int limit) { return static_cast<std::int32_t>(random() % unsigned(limit)) + 1; };
        const PixelFormat format = kNamed[random() % 6];
        const RandomCodes picture(upto(600), upto(12), seed);
        const std::size_t row = static_cast<std::size_t>(picture.width) * format.bytes;
        const std::size_t stride = row + random() % 9, size = stride * static_cast<std::size_t>(picture.height);
        std::vector<unsigned char> whole(size, 0xa5), tiled(size, 0xa5);
        const Extent extent{picture.width, picture.height};
        pack_part(format, whole.data(), stride, extent, picture.all(), {0, 0});

        const std::int32_t tile_width = upto(picture.width), tile_height = upto(picture.height);
        std::vector<Rect> tiles;
        for (std::int32_t y = 0; y < picture.height; y += tile_height)
            for (std::int32_t x = 0; x < picture.width; x += tile_width)
                tiles.push_back(
                    {x, y, std::min(tile_width, picture.width - x), std::min(tile_height, picture.height - y)});
        std::shuffle(tiles.begin(), tiles.end(), random);
        for (const Rect& tile : tiles)
            pack_part(format, tiled.data(), stride, extent, picture.part(tile), {tile.left, tile.top});

        ASSERT_EQ(whole, tiled) << "seed " << seed;
        for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y)
            for (std::size_t i = row; i < stride; ++i) ASSERT_EQ(whole[y * stride + i], 0xa5) << "seed " << seed;
    }
}

// Parts that stick out on any side: what is seen is right, what is around the memory is untouched.
TEST(Pixel, WhatLiesOutsideIsLeftOut) {
    constexpr std::size_t kGuard = 4096;
    for (unsigned seed = 1; seed <= 500; ++seed) {
        std::mt19937 random(seed);
        const PixelFormat format = kNamed[random() % 6];
        const Extent extent{static_cast<std::int32_t>(random() % 20 + 1), static_cast<std::int32_t>(random() % 20 + 1)};
        const RandomCodes picture(static_cast<std::int32_t>(random() % 30 + 1),
                                  static_cast<std::int32_t>(random() % 30 + 1), seed);
        const Point at{static_cast<std::int32_t>(random() % 61) - 30, static_cast<std::int32_t>(random() % 61) - 30};
        const std::size_t stride = static_cast<std::size_t>(extent.width) * format.bytes;
        std::vector<unsigned char> memory(2 * kGuard + stride * static_cast<std::size_t>(extent.height), 0x5a);
        std::vector<unsigned char> expected = memory;
        pack_part(format, memory.data() + kGuard, stride, extent, picture.all(), at);

        for (std::int32_t y = 0; y < picture.height; ++y)
            for (std::int32_t x = 0; x < picture.width; ++x) {
                const std::int32_t to_x = at.x + x, to_y = at.y + y;
                if (to_x < 0 || to_y < 0 || to_x >= extent.width || to_y >= extent.height) continue;
                const auto pixel =
                    pixel_bit_by_bit(format, picture.rgb.data() + 3 * (y * picture.width + x), to_x, to_y);
                std::copy(pixel.begin(), pixel.end(),
                          expected.begin() +
                              static_cast<std::ptrdiff_t>(kGuard + static_cast<std::size_t>(to_y) * stride) +
                              to_x * format.bytes);
            }
        ASSERT_EQ(memory, expected) << "seed " << seed << ", at " << at.x << "," << at.y;
    }
}

TEST(Pixel, HugePositionsAreOutside) {
    const RandomCodes picture(4, 4, 7);
    std::vector<unsigned char> memory(64, 0x5a);
    for (const std::int32_t far : {INT32_MAX, INT32_MIN})
        pack_part(kXrgb8888, memory.data(), 16, {4, 4}, picture.all(), {far, far});
    EXPECT_EQ(memory, std::vector<unsigned char>(64, 0x5a));
}

}  // namespace
}  // namespace zerkalo
