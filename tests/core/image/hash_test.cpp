// The picture's hash: published FNV-1a values, little-endian bytes, and no byte of padding.
#include "core/image/hash.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace zerkalo::test {
namespace {

std::uint64_t hash_of_floats(std::vector<float> values, std::int32_t width, std::int32_t height, int padding = 0) {
    const std::ptrdiff_t stride = 12 * width + padding;
    std::vector<unsigned char> memory(static_cast<std::size_t>(stride * height) + 1, 0xee);
    for (std::int32_t y = 0; y < height; ++y) {
        std::memcpy(&memory[static_cast<std::size_t>(y * stride)], &values[static_cast<std::size_t>(3 * width * y)],
                    static_cast<std::size_t>(12 * width));
    }
    return hash_of({reinterpret_cast<float*>(memory.data()), width, height, stride});
}

/// Three floats whose little-endian bytes are these twelve.
std::vector<float> floats_of(const char (&text)[13]) {
    std::vector<float> values;
    for (int k = 0; k < 3; ++k) {
        std::uint32_t bits = 0;
        for (int byte = 3; byte >= 0; --byte) bits = bits << 8 | static_cast<unsigned char>(text[4 * k + byte]);
        values.push_back(std::bit_cast<float>(bits));
    }
    return values;
}

TEST(Hash, OfNothingIsTheOffsetBasis) { EXPECT_EQ(hash_of_floats({}, 0, 0), 0xcbf29ce484222325u); }

TEST(Hash, AgreesWithPlainFnv1aOfTheBytes) {
    const char texts[][13] = {"hello world!", "chongo was h", "\x01\x7f\x80\xff\x05\x06\x07\x08\x09\x0a\x0b\x0c"};
    for (const auto& text : texts) {
        std::uint64_t plain = 14695981039346656037u;
        for (int k = 0; k < 12; ++k) plain = (plain ^ static_cast<unsigned char>(text[k])) * 1099511628211u;
        EXPECT_EQ(hash_of_floats(floats_of(text), 1, 1), plain);
    }
}

TEST(Hash, HasKnownValues) {
    // FNV-1a 64 of the twelve bytes "hello world!", and of twelve zero bytes: basis * prime^12.
    EXPECT_EQ(hash_of_floats(floats_of("hello world!"), 1, 1), 0x782ded88cd5a2672u);
    EXPECT_EQ(hash_of_floats({0, 0, 0}, 1, 1), 0x5467b0da1d106495u);
}

TEST(Hash, IgnoresPaddingAndSeesOrderAndSign) {
    const std::vector<float> values{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    const std::uint64_t plain = hash_of_floats(values, 2, 2);
    EXPECT_EQ(hash_of_floats(values, 2, 2, 4), plain);
    EXPECT_EQ(hash_of_floats(values, 2, 2, 40), plain);
    EXPECT_EQ(hash_of_floats(values, 1, 4), plain) << "rows follow each other without a mark";
    EXPECT_NE(hash_of_floats({2, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}, 2, 2), plain);
    EXPECT_NE(hash_of_floats({0, 0, 0}, 1, 1), hash_of_floats({0, -0.0f, 0}, 1, 1));
}

}  // namespace
}  // namespace zerkalo::test
