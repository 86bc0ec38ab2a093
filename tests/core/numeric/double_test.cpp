// One lane of double: elementary functions within their bounds, and the sample points that float rounds.
#include "core/optics/point_sets.hpp"

#include "tests/core/support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::test {
namespace {

constexpr int kPoints = ZERKALO_LAW_RAYS;
constexpr Real80 kBound = 1e-15L, kTwoPi = 6.28318530717958647692528676655900577L;

/// f at kPoints random points of low..high, each within `bound` of `wanted`, relative or absolute.
template <class F, class W>
void expect_close(double low, double high, bool relative, F f, W wanted) {
    Random random(7);
    for (int k = 0; k < kPoints; ++k) {
        const double x = random.uniform(low, high);
        const Real80 right = wanted(Real80(x));
        ASSERT_LE(std::abs(f(x) - right), kBound * (relative ? std::abs(right) : 1)) << std::hexfloat << "at x = " << x;
    }
}

TEST(DoubleElementary, Exp2MinusOneKeepsItsDigitsNearZero) {
    const auto wanted = [](Real80 x) { return std::expm1(x * std::log(2.0L)); };
    for (const double scale : {0.5, 1e-3, 1e-9, 1e-30}) {
        expect_close(-scale, scale, true, [](double x) { return exp2_minus_one(x); }, wanted);
    }
}

TEST(DoubleElementary, Exp2IsWithinItsBoundAndSaturates) {
    expect_close(-125, 125, true, [](double x) { return exp2(x); }, [](Real80 x) { return std::exp2(x); });
    EXPECT_EQ(exp2(-1e300), 0x1p-125);
    EXPECT_EQ(exp2(1e300), 0x1p125);
    EXPECT_EQ(exp2(10.0), 1024);
    EXPECT_EQ(exp2(0.0), 1);
}

TEST(DoubleElementary, Log2IsWithinItsBound) {
    const auto log2 = [](double x) { return log2_of(x, 0.0); };
    const auto wanted = [](Real80 x) { return std::log2(x); };
    for (const double most : {2.0, 1e-3, 1e30}) expect_close(most / 100, most, true, log2, wanted);
    expect_close(1 - 1e-6, 1 + 1e-6, true, log2, wanted);
    for (int e = -100; e <= 100; ++e) EXPECT_EQ(log2_of(std::ldexp(1.0, e), 0.0), e);
}

TEST(DoubleElementary, LogOfOneMinusKeepsTheDigitsOfTinyArguments) {
    const auto wanted = [](Real80 x) { return std::log1p(-x) / std::log(2.0L); };
    for (const double scale : {0.9, 1e-3, 1e-9, 1e-15}) {
        expect_close(0, scale, true, [](double x) { return log2_one_minus(x); }, wanted);
    }
}

TEST(DoubleElementary, SineAndCosineOfATurnAreWithinTheirBound) {
    expect_close(-1, 1, false, [](double x) { return sincos_turn(x).sine; },
                 [](Real80 x) { return std::sin(kTwoPi * x); });
    expect_close(-1, 1, false, [](double x) { return sincos_turn(x).cosine; },
                 [](Real80 x) { return std::cos(kTwoPi * x); });
}

TEST(DoubleElementary, ACosinePowerOfABillionKeepsItsDigits) {
    // Its relative error is that of the logarithm times n x.
    constexpr double kExponent = 0x1p30;
    Random random(8);
    for (int k = 0; k < kPoints; ++k) {
        const double x = random.uniform(0, 40 / kExponent);
        const Real80 right = std::exp(kExponent * std::log1p(-Real80(x)));
        ASSERT_LE(std::abs(power_of_one_minus(x, kExponent) - right), 50 * kBound * right) << std::hexfloat << x;
    }
    EXPECT_EQ(power_of_one_minus(1.0, 3.0), 0);
    EXPECT_EQ(power_of_one_minus(0.25, 0.0), 1);
}

TEST(DoubleSamples, ArePhasesAndFractionsThatFloatRounds) {
    Random random(9);
    for (int k = 0; k < kPoints; ++k) {
        const auto bits = static_cast<std::uint32_t>(random.bits());
        // All 32 bits, of which float keeps the first 23.
        const double turn = turn_of_phase<double>(bits);
        ASSERT_EQ(turn, std::ldexp(double(bits), -32) - 0.5) << bits;
        ASSERT_EQ(turn_of_phase<float>(bits), std::floor(std::ldexp(turn, 23)) * 0x1p-23) << bits;
        ASSERT_EQ(fraction_of_bits<double>(bits), double(fraction_of_bits<float>(bits))) << bits;
    }
}

TEST(DoubleSamples, OfEveryRuleAreThoseOfFloat) {
    // Float keeps 23 bits, and rounds once or twice more.
    constexpr double kRoom = 0x1p-21;
    const SetChoice<std::uint32_t> sets[] = {{0x9abcdef0u, 0}, {77, 0x80000000u}};
    for (const Estimator rule : {Estimator::random, Estimator::jittered, Estimator::sobol, Estimator::r2}) {
        for (const std::int32_t n : {1, 2, 7, 16, 1000, 4096}) {
            for (std::int32_t s = 0; s < n; ++s) {
                for (const auto& set : sets) {
                    const auto index = static_cast<std::uint32_t>(s);
                    const SetPoint<float> rounded = set_point<float>(rule, index, n, set);
                    const SetPoint<double> exact = set_point<double>(rule, index, n, set);
                    SCOPED_TRACE(testing::Message() << name_of(rule) << ", " << s << " of " << n);
                    ASSERT_LE(std::abs(rounded.u - exact.u), kRoom);
                    ASSERT_LE(std::abs(rounded.turn - exact.turn), kRoom);
                }
            }
        }
    }
}

}  // namespace
}  // namespace zerkalo::test
