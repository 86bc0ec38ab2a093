// Sums, products, quotients and changes of format against exact integers of 128 bits.
#include "tests/fixed/fixed_values.hpp"

namespace zerkalo::test {
namespace {

__extension__ using Wide = __int128;

constexpr int kDraws = 200000;
constexpr std::int32_t kEnd32 = kLargest<std::int32_t>;
constexpr std::int64_t kEnd64 = kLargest<std::int64_t>;

/// Any size of number is as likely as any other, and the ends come often.
std::int64_t draw64(Random& random) {
    const std::uint64_t bits = random.bits();
    if (bits % 16 == 0) return bits % 32 == 0 ? kEnd64 : -kEnd64;
    if (bits % 16 == 1) return 0;
    const auto size = static_cast<std::int64_t>(random.bits() >> 1 >> (bits % 63));
    return (bits >> 32) % 2 ? size : -size;
}
std::int32_t draw32(Random& random) {
    const std::uint64_t bits = random.bits();
    if (bits % 16 == 0) return bits % 32 == 0 ? kEnd32 : -kEnd32;
    if (bits % 16 == 1) return 0;
    const auto size = static_cast<std::int32_t>((random.bits() >> 33) >> (bits % 31));
    return (bits >> 32) % 2 ? size : -size;
}

Wide clamped(Wide x, Wide end) { return x > end ? end : (x < -end ? -end : x); }

/// a / b for b > 0 by its definition: the nearest integer, the one farther from zero where two are.
Wide nearest_ratio(Wide a, Wide b) {
    const Wide size = a < 0 ? -a : a;
    const Wide floor = size / b;
    const Wide rounded = 2 * (size - floor * b) >= b ? floor + 1 : floor;
    return a < 0 ? -rounded : rounded;
}

TEST(FixedSum, IsExactOrAtTheEndOfTheFormat) {
    Random random(1);
    for (int i = 0; i < kDraws; ++i) {
        const std::int64_t a = draw64(random), b = draw64(random);
        const auto wide = Area<One>::from_raw(a) + Area<One>::from_raw(b);
        ASSERT_TRUE(wide.raw == clamped(Wide{a} + b, kEnd64)) << a << " + " << b;
        const std::int32_t c = draw32(random), d = draw32(random);
        const auto narrow = Len::from_raw(c) - Len::from_raw(d);
        ASSERT_TRUE(narrow.raw == clamped(Wide{c} - d, kEnd32)) << c << " - " << d;
    }
    EXPECT_EQ(Len::from_raw(std::numeric_limits<std::int32_t>::min()).raw, -kEnd32);
}

TEST(FixedProduct, IsExact) {
    Random random(2);
    for (int i = 0; i < kDraws; ++i) {
        const std::int32_t a = draw32(random), b = draw32(random);
        ASSERT_TRUE((Len::from_raw(a) * Dir::from_raw(b)).raw == Wide{a} * b) << a << " * " << b;
    }
}

TEST(FixedProduct, OfThreeWordsIsRoundedOnce) {
    Random random(3);
    for (int i = 0; i < kDraws; ++i) {
        const std::int32_t a = draw32(random);
        const std::int64_t b = draw64(random);
        const auto p = product<Len>(Ratio<One>::from_raw(a), Area<One>::from_raw(b));
        ASSERT_TRUE(p.raw == clamped(nearest_ratio(Wide{a} * b, Wide{1} << 54), kEnd32)) << a << " * " << b;
    }
}

TEST(FixedProduct, OfFourWordsIsRoundedOnce) {
    Random random(8);
    for (int i = 0; i < kDraws; ++i) {
        const std::int64_t a = draw64(random), b = draw64(random);
        const auto p = product<Len>(Curvature<One>::from_raw(a), Area<One>::from_raw(b));
        ASSERT_TRUE(p.raw == clamped(nearest_ratio(Wide{a} * b, Wide{1} << 86), kEnd32)) << a << " * " << b;
    }
}

TEST(FixedConversion, RoundsToNearestTiesAwayFromZero) {
    EXPECT_EQ(as<Len>(Dir::from_raw(3)).raw, 0);
    EXPECT_EQ(as<Len>(Dir::from_raw(4)).raw, 1);
    EXPECT_EQ(as<Len>(Dir::from_raw(-4)).raw, -1);
    EXPECT_EQ(as<Len>(Dir::from_raw(-3)).raw, 0);
    EXPECT_EQ(as<Len>(Dir::from_raw(-12)).raw, -2);
    Random random(4);
    for (int i = 0; i < kDraws; ++i) {
        const std::int64_t x = draw64(random);
        const auto area = Area<One>::from_raw(x);
        ASSERT_TRUE(as<Len>(area).raw == clamped(nearest_ratio(x, Wide{1} << 27), kEnd32)) << x;
        ASSERT_TRUE(as<Square<One>>(area).raw == clamped(Wide{x} << 6, kEnd64)) << x;
        const std::int32_t y = draw32(random);
        ASSERT_TRUE(as<Dir>(Len::from_raw(y)).raw == clamped(Wide{y} << 3, kEnd32)) << y;
        ASSERT_TRUE(as<Area<One>>(Len::from_raw(y)).raw == Wide{y} << 27) << y;
    }
}

TEST(FixedQuotient, IsRoundedToNearestAndHeldAtTheEnds) {
    Random random(5);
    for (int i = 0; i < kDraws; ++i) {
        const std::int32_t a = draw32(random), b = draw32(random);
        const std::int64_t c = draw64(random);
        if (b == 0) continue;
        const Wide sign = b < 0 ? -1 : 1;
        const auto t = quotient<Len>(Len::from_raw(a), Dir::from_raw(b));
        ASSERT_TRUE(t.raw == clamped(nearest_ratio(sign * a * (Wide{1} << 30), sign * b), kEnd32)) << a << " / " << b;
        const auto u = quotient<Len>(Area<One>::from_raw(c), Len::from_raw(b));
        ASSERT_TRUE(u.raw == clamped(nearest_ratio(sign * c, sign * b), kEnd32)) << c << " / " << b;
    }
}

TEST(FixedQuotient, ByZeroIsTheEndOnTheDividendsSide) {
    EXPECT_EQ(quotient<Len>(Len(1), Dir(0)).raw, kEnd32);
    EXPECT_EQ(quotient<Len>(Len(-1), Dir(0)).raw, -kEnd32);
    EXPECT_EQ(quotient<Len>(Len(0), Dir(0)).raw, kEnd32);
}

TEST(FixedArithmetic, IsSymmetricInSign) {
    Random random(6);
    for (int i = 0; i < kDraws; ++i) {
        const auto a = Len::from_raw(draw32(random));
        const auto b = Dir::from_raw(draw32(random) | 1);
        const auto d = Dir::from_raw(draw32(random) | 1);
        const auto c = Area<One>::from_raw(draw64(random));
        ASSERT_EQ(as<Len>(-c).raw, (-as<Len>(c)).raw) << c.raw;
        ASSERT_EQ(as<Len>(-(a * b)).raw, as<Len>(-a * b).raw) << a.raw << ' ' << b.raw;
        ASSERT_EQ((-a + -Len(3)).raw, (-(a + Len(3))).raw) << a.raw;
        ASSERT_EQ((-c - c).raw, (-(c + c)).raw) << c.raw;
        ASSERT_EQ(quotient<Len>(a, -b).raw, (-quotient<Len>(a, b)).raw) << a.raw << ' ' << b.raw;
        ASSERT_EQ(product<Len>(-a, c).raw, (-product<Len>(a, c)).raw) << a.raw << ' ' << c.raw;
        ASSERT_EQ(flip_sign(b, -d).raw, (-flip_sign(b, d)).raw) << b.raw << ' ' << d.raw;
        ASSERT_EQ(flip_sign(b, Dir(0)).raw, b.raw) << b.raw;
    }
}

TEST(FixedOrder, IsThatOfTheNumbers) {
    Random random(7);
    for (int i = 0; i < kDraws; ++i) {
        const auto a = Len::from_raw(draw32(random)), b = Len::from_raw(draw32(random));
        ASSERT_EQ(a < b, real(a) < real(b));
        ASSERT_EQ(a <= b, real(a) <= real(b));
        ASSERT_EQ(a > b, real(a) > real(b));
        ASSERT_EQ(a >= b, real(a) >= real(b));
        ASSERT_EQ(a == b, real(a) == real(b));
        ASSERT_EQ(a != b, real(a) != real(b));
        ASSERT_EQ(real(min(a, b)), std::min(real(a), real(b)));
        ASSERT_EQ(real(max(a, b)), std::max(real(a), real(b)));
    }
}

TEST(FixedMask, AnyAllAndNoneSpeakOfAllLanes) {
    using L4 = Length<FixedNumbers<4>>;
    std::array<Len, kGroup> from{};
    const L4 zero = packed<4>(from, 0);
    EXPECT_TRUE(none(zero < L4(0)) && !any(zero < L4(0)) && all(zero == L4(0)));
    for (std::size_t k = 0; k < 4; ++k) {
        from[k] = Len(-1);
        const auto negative = packed<4>(from, 0) < L4(0);
        EXPECT_TRUE(any(negative) && !none(negative)) << k;
        EXPECT_EQ(all(negative), k == 3);
        EXPECT_EQ(lane(select(negative, L4(5), L4(7)), static_cast<int>(k)).raw, Len(5).raw);
        EXPECT_EQ(any(negative & !negative), false);
        EXPECT_EQ(all(negative | !negative), true);
    }
}

}  // namespace
}  // namespace zerkalo::test
