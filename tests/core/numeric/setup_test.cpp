// The double-precision functions of set-up against libm's long double ones, at the bounds that their comments state.
#include "core/numeric/setup.hpp"

#include "tests/core/support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::test {
namespace {

constexpr int kSetupArguments = ZERKALO_LAW_RAYS;

TEST(SetupFunctions, SineAndCosineAreWithinTheirBound) {
    constexpr Real80 kBound = 1e-15L;
    Random random(4);
    for (const double range : {1.0, 4.0, 1e3, 1e6}) {
        for (int k = 0; k < kSetupArguments / 4; ++k) {
            const double x = random.uniform(-range, range);
            const auto [sine, cosine] = sine_cosine(x);
            ASSERT_LE(std::abs(sine - std::sin(Real80(x))), kBound) << std::hexfloat << x;
            ASSERT_LE(std::abs(cosine - std::cos(Real80(x))), kBound) << std::hexfloat << x;
        }
    }
}

TEST(SetupFunctions, SineKeepsItsDigitsForTinyAngles) {
    constexpr Real80 kBound = 1e-15L;
    for (double x = 1; x > 1e-300; x /= 3) {
        const Real80 wanted = std::sin(Real80(x));
        ASSERT_LE(std::abs(sine_cosine(x).sine - wanted), kBound * wanted) << std::hexfloat << x;
    }
}

TEST(SetupFunctions, NaturalLogIsWithinItsBound) {
    constexpr Real80 kBound = 1e-15L;
    Random random(5);
    for (int k = 0; k < kSetupArguments; ++k) {
        const double x = k % 2 == 0 ? std::exp2(random.uniform(-1022, 1023)) : random.uniform(0.5, 2);
        const Real80 wanted = std::log(Real80(x));
        ASSERT_LE(std::abs(natural_log(x) - wanted), kBound * std::abs(wanted)) << std::hexfloat << x;
    }
    EXPECT_EQ(natural_log(1), 0);
}

TEST(SetupFunctions, ExponentialIsWithinItsBound) {
    constexpr Real80 kBound = 1e-15L;
    Random random(6);
    for (int k = 0; k < kSetupArguments; ++k) {
        const double x = k % 2 == 0 ? random.uniform(-700, 700) : random.uniform(-2, 2);
        const Real80 wanted = std::exp(Real80(x));
        ASSERT_LE(std::abs(exponential(x) - wanted), kBound * std::max<Real80>(1, std::abs(Real80(x))) * wanted)
            << std::hexfloat << x;
    }
    EXPECT_EQ(exponential(0), 1);
}

TEST(SetupFunctions, SquareRootIsCorrectlyRounded) {
    Random random(7);
    for (int k = 0; k < kSetupArguments; ++k) {
        const double x = std::exp2(random.uniform(-1000, 1000));
        const double root = square_root(x);
        // Correct rounding: x lies between the squares of the root's two half-way neighbours.
        const Real80 up = (Real80(root) + std::nextafter(root, 1e308)) / 2;
        const Real80 down = (Real80(root) + std::nextafter(root, 0.0)) / 2;
        ASSERT_LE(down * down, Real80(x) * (1 + 0x1p-62L)) << std::hexfloat << x;
        ASSERT_GE(up * up, Real80(x) * (1 - 0x1p-62L)) << std::hexfloat << x;
    }
}

TEST(SetupFunctions, NearestIntegerIsNearest) {
    Random random(8);
    for (int k = 0; k < kSetupArguments; ++k) {
        const double x = random.uniform(-1e9, 1e9);
        ASSERT_EQ(nearest_integer(x), std::nearbyint(x)) << std::hexfloat << x;
    }
    EXPECT_EQ(nearest_integer(2.5), 2);
    EXPECT_EQ(nearest_integer(3.5), 4);
    EXPECT_EQ(nearest_integer(-0x1p50 - 0.75), -0x1p50 - 1);
}

}  // namespace
}  // namespace zerkalo::test
