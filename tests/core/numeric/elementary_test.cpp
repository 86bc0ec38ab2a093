// log2, exp2, sine, cosine and the cosine power stay within the bounds that their comments state, at every width.
#include "tests/core/support/random.hpp"
#include "tests/core/support/widths.hpp"

#include <cmath>
#include <limits>

namespace zerkalo::test {
namespace {

using probes::Elementary;

constexpr int kArguments = ZERKALO_LAW_RAYS;
constexpr float kEndless = std::numeric_limits<float>::infinity();

/// kArguments values from low to high in equal steps, both ends included.
Floats sweep(double low, double high) {
    Floats x;
    for (int k = 0; k < kArguments; ++k) x.push_back(static_cast<float>(low + (high - low) * k / (kArguments - 1)));
    return x;
}

/// kArguments values whose exponents run evenly from that of `low` to that of `high`.
Floats logarithmic_sweep(double low, double high) {
    Floats x = sweep(std::log2(low), std::log2(high));
    for (float& value : x) value = std::exp2(value);
    return x;
}

class ElementaryFunctions : public Widths {
protected:
    Floats values(Elementary op, const Floats& x) const {
        Floats out(x.size());
        lanes().elementary(op, x.data(), out.data(), static_cast<int>(x.size()));
        Floats scalar_out(x.size());
        scalar().lanes.elementary(op, x.data(), scalar_out.data(), static_cast<int>(x.size()));
        expect_same_bits(out, scalar_out, "this width against the scalar one");
        return out;
    }

    template <class F>
    void expect_relative(Elementary op, const Floats& x, Real80 bound, F f) const {
        const Floats y = values(op, x);
        for (std::size_t k = 0; k < x.size(); ++k) {
            const Real80 wanted = f(Real80(x[k]));
            ASSERT_LE(std::abs(y[k] - wanted), bound * std::abs(wanted)) << std::hexfloat << "at x = " << x[k];
        }
    }

    template <class F>
    void expect_absolute(Elementary op, const Floats& x, Real80 bound, F f) const {
        const Floats y = values(op, x);
        for (std::size_t k = 0; k < x.size(); ++k) {
            ASSERT_LE(std::abs(y[k] - f(Real80(x[k]))), bound) << std::hexfloat << "at x = " << x[k];
        }
    }
};

TEST_P(ElementaryFunctions, Exp2MinusOneKeepsItsDigitsNearZero) {
    constexpr Real80 kBound = 1.4e-7L;
    const auto wanted = [](Real80 x) { return std::expm1(x * std::log(2.0L)); };
    expect_relative(Elementary::exp2_minus_one, sweep(-0.5, 0.5), kBound, wanted);
    expect_relative(Elementary::exp2_minus_one, logarithmic_sweep(1e-30, 0.5), kBound, wanted);
}

TEST_P(ElementaryFunctions, Exp2IsWithinItsBoundAndSaturates) {
    constexpr Real80 kBound = 1e-7L;
    expect_relative(Elementary::exp2, sweep(-125, 125), kBound, [](Real80 x) { return std::exp2(x); });
    expect_relative(Elementary::exp2, sweep(-2, 2), kBound, [](Real80 x) { return std::exp2(x); });
    const Floats ends = values(Elementary::exp2,
                               {-1e30f, -126, 126, 1e30f, -kEndless, kEndless, 0, 1, -1, 2, 3, -125, 125, 10, 20, -20});
    const Floats wanted{0x1p-125f, 0x1p-125f, 0x1p125f, 0x1p125f,  0x1p-125f, 0x1p125f, 1,       2,
                        0.5f,      4,         8,        0x1p-125f, 0x1p125f,  1024,     0x1p20f, 0x1p-20f};
    expect_same_bits(ends, wanted, "whole powers of two");
}

TEST_P(ElementaryFunctions, Log2IsWithinItsBound) {
    constexpr Real80 kBound = 2.5e-7L;
    const auto wanted = [](Real80 x) { return std::log2(x); };
    expect_relative(Elementary::log2, logarithmic_sweep(0x1p-126, 0x1p127), kBound, wanted);
    expect_relative(Elementary::log2, sweep(0.5, 2), kBound, wanted);
}

TEST_P(ElementaryFunctions, Log2PutsALostRoundingBack) {
    // u + lost is a number that a float cannot hold; log2 near 1 is nothing but that rest.
    constexpr Real80 kBound = 2.5e-7L;
    Random random(2);
    Floats u, lost, out(kArguments);
    for (int k = 0; k < kArguments; ++k) {
        u.push_back(static_cast<float>(random.uniform(0.75, 1.25)));
        lost.push_back(static_cast<float>(random.uniform(-0x1p-25, 0x1p-25)));
    }
    lanes().log2_with_lost(u.data(), lost.data(), out.data(), kArguments);
    for (std::size_t k = 0; k < u.size(); ++k) {
        const Real80 wanted = std::log1p((Real80(u[k]) - 1) + lost[k]) / std::log(2.0L);
        ASSERT_LE(std::abs(out[k] - wanted), kBound * std::abs(wanted)) << std::hexfloat << u[k] << " + " << lost[k];
    }
}

TEST_P(ElementaryFunctions, Log2OneMinusKeepsItsDigitsForTinyX) {
    constexpr Real80 kBound = 2.5e-7L;
    const auto wanted = [](Real80 x) { return std::log1p(-x) / std::log(2.0L); };
    expect_relative(Elementary::log2_one_minus, sweep(0, 1 - 0x1p-24), kBound, wanted);
    expect_relative(Elementary::log2_one_minus, logarithmic_sweep(1e-35, 0.9), kBound, wanted);
}

TEST_P(ElementaryFunctions, SineAndCosineOfATurnAreWithinTheirBound) {
    constexpr Real80 kBound = 1e-7L;
    expect_absolute(Elementary::sine, sweep(-1, 1), kBound, [](Real80 x) { return std::sin(2 * kPi80 * x); });
    expect_absolute(Elementary::cosine, sweep(-1, 1), kBound, [](Real80 x) { return std::cos(2 * kPi80 * x); });
}

TEST_P(ElementaryFunctions, SineAndCosineOfQuarterTurnsAreExact) {
    const Floats quarters{-1, -0.75f, -0.5f, -0.25f, 0, 0.25f, 0.5f, 0.75f, 1, 0, 0, 0, 0, 0, 0, 0};
    const Floats sine = values(Elementary::sine, quarters), cosine = values(Elementary::cosine, quarters);
    for (int k = 0; k < 9; ++k) {
        const float sines[] = {0, 1, 0, -1}, cosines[] = {1, 0, -1, 0};
        EXPECT_EQ(sine[static_cast<std::size_t>(k)], sines[k % 4]) << "quarter " << k - 4;
        EXPECT_EQ(cosine[static_cast<std::size_t>(k)], cosines[k % 4]) << "quarter " << k - 4;
    }
}

// The exponent carries the relative error of log2_one_minus, so the power's error grows with how far it has fallen.
TEST_P(ElementaryFunctions, CosinePowerIsWithinItsBoundUpToAMillion) {
    constexpr Real80 kOfExp2 = 1e-7L, kOfLog2 = 2.5e-7L;
    for (const float n : {0.0f, 0.5f, 1.0f, 50.0f, 1e3f, 1e6f}) {
        Floats x, exponents(kArguments, n), out(kArguments), scalar_out(kArguments);
        Random random(3);
        const double widest = n <= 50 ? 0.8 : 80 / double(n);
        for (int k = 0; k < kArguments; ++k) x.push_back(static_cast<float>(random.uniform(0, widest)));
        lanes().power(x.data(), exponents.data(), out.data(), kArguments);
        scalar().lanes.power(x.data(), exponents.data(), scalar_out.data(), kArguments);
        expect_same_bits(out, scalar_out, "this width against the scalar one");
        for (std::size_t k = 0; k < x.size(); ++k) {
            const Real80 log_of_power = n * std::log1p(-Real80(x[k]));
            if (log_of_power < -125 * std::log(2.0L) * (1 - 1e-6L)) continue;
            const Real80 wanted = std::exp(log_of_power);
            const Real80 bound = (kOfExp2 + (kOfLog2 + kU) * std::abs(log_of_power)) * wanted;
            ASSERT_LE(std::abs(out[k] - wanted), bound) << std::hexfloat << "x = " << x[k] << ", n = " << n;
        }
    }
}

TEST_P(ElementaryFunctions, CosinePowerOfARightAngleAndBeyondIsZero) {
    Floats x, n, out(16);
    for (const float at : {1.0f, 1.5f, 2.0f, 1e30f}) {
        for (const float exponent : {0.0f, 1.0f, 50.0f, 1e30f}) x.push_back(at), n.push_back(exponent);
    }
    lanes().power(x.data(), n.data(), out.data(), 16);
    expect_same_bits(out, Floats(16, 0.0f), "(1-x)^n for x >= 1");

    x.assign(16, 0x1.fffffep-1f), n.assign(16, 0.0f);
    lanes().power(x.data(), n.data(), out.data(), 16);
    expect_same_bits(out, Floats(16, 1.0f), "n = 0 below a right angle");
    n.assign(16, 1e30f);
    lanes().power(x.data(), n.data(), out.data(), 16);
    expect_same_bits(out, Floats(16, 0.0f), "a power too small to hold");
}

ZERKALO_OVER_ALL_WIDTHS(ElementaryFunctions);

}  // namespace
}  // namespace zerkalo::test
