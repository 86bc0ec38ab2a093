// The integer square root: the nearest integer, checked by squaring.
#include "tests/fixed/fixed_values.hpp"

namespace zerkalo::test {
namespace {

/// r is nearest to the root of n where (r - 1/2)^2 < n < (r + 1/2)^2, in integers r (r - 1) < n <= r (r + 1).
void expect_nearest_root(std::int64_t n) {
    const std::uint64_t r = nearest_root(n);
    const auto x = static_cast<std::uint64_t>(n);
    if (r > 0) {
        ASSERT_LT(r * (r - 1), x) << n;
    }
    ASSERT_LE(x, r * (r + 1)) << n;
}

TEST(FixedRoot, IsTheNearestIntegerForEverySmallNumber) {
    for (std::int64_t n = 0; n < 1 << 18; ++n) expect_nearest_root(n);
}

TEST(FixedRoot, IsTheNearestIntegerForNumbersOfEverySize) {
    Random random(11);
    for (int i = 0; i < 300000; ++i) expect_nearest_root(static_cast<std::int64_t>(random.bits() >> 1 >> (i % 63)));
    expect_nearest_root(kLargest<std::int64_t>);
}

TEST(FixedRoot, ChangesOnlyHalfWayBetweenTwoSquares) {
    Random random(12);
    for (int i = 0; i < 100000; ++i) {
        const std::uint64_t r = random.bits() % 3037000498u + 1;  // (r + 1)^2 < 2^63
        const auto last = static_cast<std::int64_t>(r * (r + 1));
        ASSERT_EQ(nearest_root(last), r);
        ASSERT_EQ(nearest_root(last + 1), r + 1);
    }
}

TEST(FixedRoot, IsTheSameWithAndWithoutAFloatUnit) {
    Random random(13);
    for (int i = 0; i < 300000; ++i) {
        // Of every size, and at both sides of a square.
        const std::uint64_t r = (random.bits() >> 32) >> (i % 32);
        const std::uint64_t near_square = r * r - static_cast<std::uint64_t>(i % 3 == 0);
        const std::uint64_t x = i % 2 == 0 ? random.bits() >> (i % 64) : near_square;
        if (x == 0) continue;
        const std::uint64_t by_floats = settled_root(x, estimated_root_of_floats(x));
        ASSERT_EQ(settled_root(x, estimated_root_of_integers(x)), by_floats) << x;
        ASSERT_LE(estimated_root_of_integers(x), by_floats + 1) << x;
    }
}

TEST(FixedRoot, HasHalfTheFractionAndTakesNegativesAsZero) {
    EXPECT_EQ(real(root<Len>(Area<One>(256))), real(far_away<Len>()));
    EXPECT_EQ(real(root<Len>(Area<One>(9))), 3);
    EXPECT_EQ(real(root<Dir>(Square<One>(1))), 1);
    EXPECT_EQ(root<Len>(Area<One>(-1)).raw, 0);
    EXPECT_EQ(root<Len>(Area<One>::from_raw(2)).raw, 1);
    EXPECT_EQ(root<Len>(Area<One>::from_raw(3)).raw, 2);
}

}  // namespace
}  // namespace zerkalo::test
