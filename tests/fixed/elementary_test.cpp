// Logarithm, exponential, sine, cosine, unit vectors and reciprocals of fixed point against long double: the stated
// bounds, for numbers of every size.
#include "core/geometry/unit.hpp"
#include "core/optics/lattice.hpp"
#include "tests/fixed/fixed_values.hpp"

namespace zerkalo::test {
namespace {

constexpr int kDraws = 300000;
constexpr Real80 kLn2 = 0.693147180559945309417L;
constexpr Real80 kTurn = 6.28318530717958647693L;

/// A number of any size from 1 to 2^bits.
std::int64_t of_any_size(Random& random, int bits) {
    return static_cast<std::int64_t>((random.bits() >> (64 - bits)) >> (random.bits() % static_cast<unsigned>(bits))) + 1;
}

TEST(FixedLogarithm, KeepsItsRelativeErrorAlsoNearOne) {
    Random random(21);
    for (int i = 0; i < kDraws; ++i) {
        std::int64_t y = of_any_size(random, 60);
        if (i % 2 == 0) y = kOne60 - y + 1;
        if (y < 1 || y > kOne60) continue;
        const Real80 x = std::ldexp(static_cast<Real80>(kOne60 - y), -60);
        const Real80 exact = x < 0.5L ? -std::log1p(-x) / kLn2 : -std::log2(std::ldexp(static_cast<Real80>(y), -60));
        const Real80 error = std::abs(std::ldexp(static_cast<Real80>(minus_log2_of(y)), -57) - exact);
        ASSERT_LE(error, std::ldexp(exact, -29) + std::ldexp(1.0L, -55)) << y;
    }
    EXPECT_EQ(minus_log2_of(kOne60), 0);
    EXPECT_EQ(minus_log2_of(1), std::int64_t{60} << 57);
}

TEST(FixedExponential, KeepsItsRelativeErrorAlsoNearZero) {
    Random random(22);
    for (int i = 0; i < kDraws; ++i) {
        const std::int64_t e = of_any_size(random, 63) - 1;
        const Real80 exact = -std::expm1(-std::ldexp(static_cast<Real80>(e), -57) * kLn2);
        const Real80 error = std::abs(std::ldexp(static_cast<Real80>(one_minus_exp2_of(e)), -60) - exact);
        ASSERT_LE(error, std::ldexp(exact, -29) + std::ldexp(1.0L, -57)) << e;
    }
    EXPECT_EQ(one_minus_exp2_of(0), 0);
    EXPECT_EQ(one_minus_exp2_of(kLargest<std::int64_t>), kOne60);
}

TEST(FixedSineCosine, KeepsItsErrorForEveryPhase) {
    Random random(23);
    for (int i = 0; i < kDraws; ++i) {
        const auto phase = static_cast<std::uint32_t>(random.bits() >> 32);
        const IntegerSineCosine one = sine_cosine_of_phase(phase);
        const Real80 angle = std::ldexp(static_cast<Real80>(phase), -32) * kTurn;
        ASSERT_LE(std::abs(std::ldexp(static_cast<Real80>(one.sine), -30) - std::sin(angle)), 0x1p-28L) << phase;
        ASSERT_LE(std::abs(std::ldexp(static_cast<Real80>(one.cosine), -30) - std::cos(angle)), 0x1p-28L) << phase;
    }
    EXPECT_EQ(sine_cosine_of_phase(0).cosine, 1 << 30);
    EXPECT_EQ(sine_cosine_of_phase(0x80000000u).cosine, -(1 << 30));
}

TEST(FixedPower, KeepsItsErrorForEveryExponent) {
    Random random(24);
    using N = Exponent<One>;
    for (int i = 0; i < kDraws; ++i) {
        const auto x = Fixed<std::int64_t, 61>::from_raw(of_any_size(random, 61) - 1);
        const auto n = N::from_raw(of_any_size(random, 60) - 1);
        const Real80 exact = std::exp(real(n) * std::log1p(-real(x)));
        const Real80 bound = 0x1p-27L + real(n) * 0x1p-57L;
        ASSERT_LE(std::abs(real(power_of_one_minus(x, n)) - exact), bound) << x.raw << " ^ " << n.raw;
    }
    EXPECT_EQ(real(power_of_one_minus(Fixed<std::int64_t, 61>(1), N(1))), 0);
    EXPECT_EQ(real(power_of_one_minus(Fixed<std::int64_t, 61>(0), N(1000))), 1);
}

TEST(FixedUnitVector, KeepsItsDigitsForEveryLength) {
    Random random(25);
    for (int i = 0; i < kDraws; ++i) {
        const int shift = static_cast<int>(random.bits() % 30);
        const auto component = [&] { return Len::from_raw(static_cast<std::int32_t>(random.bits() >> 32) >> shift); };
        const Vec3<Len> v{component(), component(), component()};
        const Exact3 exact = real(v);
        const Real80 length = std::sqrt(dot(exact, exact));
        const auto one = unit_of(v);
        if (length == 0) continue;
        ASSERT_LE(std::abs(real(one.unit.x) - exact.x / length), 0x1p-29L) << i;
        ASSERT_LE(std::abs(real(one.unit.y) - exact.y / length), 0x1p-29L) << i;
        ASSERT_LE(std::abs(real(one.unit.z) - exact.z / length), 0x1p-29L) << i;
        ASSERT_LE(std::abs(real(one.length) - std::min(length, real(far_away<Len>()))), 0x1p-27L) << i;
    }
    const auto none = unit_of(Vec3<Len>{Len(0), Len(0), Len(0)});
    EXPECT_EQ(none.unit.x.raw | none.unit.y.raw | none.unit.z.raw | none.length.raw, 0);
}

TEST(FixedReciprocal, KeepsItsRelativeErrorAndEndsAtTheFormat) {
    Random random(26);
    using Inv = Inverse<One>;
    for (int i = 0; i < kDraws; ++i) {
        const auto a = Area<One>::from_raw(of_any_size(random, 62));
        const Real80 exact = std::min(1 / real(a), real(far_away<Inv>()));
        const Real80 error = std::abs(real(reciprocal<Inv>(a)) - exact);
        ASSERT_LE(error, std::ldexp(exact, -30) + std::ldexp(1.0L, -36)) << a.raw;
    }
    EXPECT_EQ(reciprocal<Inv>(Area<One>(0)).raw, far_away<Inv>().raw);
}

TEST(FixedQuotient, OfWideNumbersKeepsItsRelativeError) {
    Random random(27);
    for (int i = 0; i < kDraws; ++i) {
        const auto a = Len::from_raw(static_cast<std::int32_t>(of_any_size(random, 30)) * (i % 2 == 0 ? 1 : -1));
        const auto b = Area<One>::from_raw(of_any_size(random, 60) * (i % 3 == 0 ? 1 : -1));
        const Real80 end = real(far_away<Len>());
        const Real80 exact = std::clamp(real(a) / real(b), -end, end);
        const Real80 error = std::abs(real(quotient<Len>(a, b)) - exact);
        ASSERT_LE(error, std::ldexp(std::abs(exact), -30) + std::ldexp(1.0L, -27)) << a.raw << " / " << b.raw;
    }
}

/// The share u of the energy lies beyond the lattice ray: cos(theta)^(n + 1) = u, at the azimuth that was asked for.
TEST(FixedLobe, PointsLieWhereTheirShareOfTheEnergySays) {
    Random random(28);
    for (int i = 0; i < kDraws / 10; ++i) {
        const Real80 n = std::exp2(Real80(random.uniform(0, 30)));
        const auto share = nearest<Share<One>>(1 / (n + 1));
        const auto u = Fraction<One>::from_raw(of_any_size(random, 60));
        const auto turn = static_cast<std::uint32_t>(random.bits() >> 32);
        const LobePoint<One> point = lobe_point(u, turn, share);
        const Real80 from_axis = -std::expm1(std::log(real(u)) * real(share));
        const Real80 radius = std::sqrt(from_axis * (2 - from_axis)), angle = std::ldexp(Real80(turn), -32) * kTurn;
        ASSERT_LE(std::abs(real(point.forward) - (1 - from_axis)), 0x1p-28L) << u.raw << ", n = " << n;
        ASSERT_LE(std::abs(real(point.side) - radius * std::cos(angle)), 0x1p-27L) << u.raw << ", n = " << n;
        ASSERT_LE(std::abs(real(point.up) - radius * std::sin(angle)), 0x1p-27L) << u.raw << ", n = " << n;
    }
}

}  // namespace
}  // namespace zerkalo::test
