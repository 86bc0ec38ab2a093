// The sRGB curve at every boundary between two codes: the float just below it and the first float of the next code.
#include "core/image/resolve.hpp"

#include "tests/core/support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace zerkalo::test {
namespace {

/// IEC 61966-2-1 backwards, with the printed constants: the linear value whose encoded value is `stored`.
Real80 linear_of(Real80 stored) {
    return stored <= 12.92L * 0.0031308L ? stored / 12.92L : std::pow((stored + 0.055L) / 1.055L, 2.4L);
}

/// The smallest float that is stored as `code` of `codes - 1` or higher, rounding half up.
float first_of(int code, int codes) {
    const Real80 boundary = linear_of((code - 0.5L) / (codes - 1));
    float x = static_cast<float>(boundary);
    while (x < boundary) x = std::nextafter(x, 2.0f);
    while (std::nextafter(x, -1.0f) >= boundary) x = std::nextafter(x, -1.0f);
    return x;
}

std::uint8_t resolved8(float x) {
    std::uint8_t code = 77;
    resolve8(&x, &code, 1);
    return code;
}
std::uint16_t resolved16(float x) {
    std::uint16_t code = 777;
    resolve16(&x, &code, 1);
    return code;
}

TEST(Resolve, EveryEightBitBoundaryIsExact) {
    for (int code = 1; code < 256; ++code) {
        const float first = first_of(code, 256);
        ASSERT_EQ(resolved8(first), code) << std::hexfloat << first;
        ASSERT_EQ(resolved8(std::nextafter(first, 0.0f)), code - 1) << std::hexfloat << first;
    }
}

TEST(Resolve, EverySixteenBitBoundaryIsExact) {
    const int step = ZERKALO_LAW_RAYS >= 100000 ? 1 : 7;
    for (int code = 1; code < 65536; code += step) {
        const float first = first_of(code, 65536);
        ASSERT_EQ(resolved16(first), code) << std::hexfloat << first;
        ASSERT_EQ(resolved16(std::nextafter(first, 0.0f)), code - 1) << std::hexfloat << first;
    }
}

TEST(Resolve, ValuesOutsideTheRangeAreClipped) {
    const float endless = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    for (const float dark : {0.0f, -0.0f, -1.0f, -endless, nan, 1e-40f, 0x1p-126f}) {
        EXPECT_EQ(resolved8(dark), 0) << dark;
        EXPECT_EQ(resolved16(dark), 0) << dark;
    }
    for (const float bright : {1.0f, std::nextafter(1.0f, 2.0f), 2.0f, 1e30f, endless}) {
        EXPECT_EQ(resolved8(bright), 255) << bright;
        EXPECT_EQ(resolved16(bright), 65535) << bright;
    }
}

TEST(Resolve, ArraysAreResolvedValueByValueAndNoFurther) {
    Random random(111);
    std::vector<float> linear(1001);
    for (float& x : linear) x = static_cast<float>(random.uniform(-0.1, 1.1));
    std::vector<std::uint8_t> eight(linear.size() + 1, 0xab);
    std::vector<std::uint16_t> sixteen(linear.size() + 1, 0xabcd);
    resolve8(linear.data(), eight.data(), linear.size());
    resolve16(linear.data(), sixteen.data(), linear.size());
    for (std::size_t k = 0; k < linear.size(); ++k) {
        ASSERT_EQ(eight[k], resolved8(linear[k])) << linear[k];
        ASSERT_EQ(sixteen[k], resolved16(linear[k])) << linear[k];
    }
    EXPECT_EQ(eight.back(), 0xab);
    EXPECT_EQ(sixteen.back(), 0xabcd);
}

}  // namespace
}  // namespace zerkalo::test
