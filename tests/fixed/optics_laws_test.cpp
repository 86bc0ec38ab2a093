// P07-P09, P29, P30 in fixed point: refraction and Fresnel's reflectance, through the same templates as in float.
#include "core/optics/directions.hpp"
#include "core/optics/fresnel.hpp"
#include "tests/fixed/fixed_values.hpp"

namespace zerkalo::test {
namespace {

using Rat = Ratio<One>;

constexpr int kRays = 4000;
constexpr Real80 kStep = 0x1p-30L;  // of a direction's component
constexpr Real80 kRatios[] = {0.4L, 2 / 3.0L, 0.75L, 1, 4 / 3.0L, 1.5L, 2.4L};

/// A ray of fixed-point numbers that meets a surface, and what geometry says of it, their rounding taken away.
struct Meeting {
    Vec3<Dir> d, n;
    Rat eta;

    Real80 ratio() const { return real(eta); }
    Real80 sine() const { return length(cross(unit(real(d)), unit(real(n)))); }
    Real80 before() const { return -dot(unit(real(d)), unit(real(n))); }
    Real80 behind2() const { return (1 - ratio() * sine()) * (1 + ratio() * sine()); }
};

Meeting random_meeting(Random& random, Real80 ratio) {
    const Exact3 n = random.direction(), across = unit(cross(n, random.direction()));
    const Real80 angle = kRightAngle * random.uniform(0, 0.999);
    return {nearest<Dir>(across * std::sin(angle) - n * std::cos(angle)), nearest<Dir>(n), nearest<Rat>(ratio)};
}

Meeting at_angle(Real80 angle, Real80 ratio) {
    return {nearest<Dir>(Exact3{std::sin(angle), 0, -std::cos(angle)}), nearest<Dir>(Exact3{0, 0, 1}),
            nearest<Rat>(ratio)};
}

/// By how much a rounding of the operands may show in what stands behind the surface.
Real80 room(const Meeting& m, Real80 steps) {
    return steps * kStep * std::max(1.0L, m.ratio()) / std::sqrt(m.behind2());
}

TEST(P07, InFixedPointTheSinesGoAsTheIndices) {
    constexpr Real80 kSteps = 16;
    Random random(71);
    for (const Real80 ratio : kRatios) {
        for (int i = 0; i < kRays; ++i) {
            const Meeting m = random_meeting(random, ratio);
            if (m.behind2() < 1e-4L) continue;
            const auto bent = refract(m.d, m.n, m.eta);
            ASSERT_FALSE(bent.total) << i;
            const Exact3 r = real(bent.d);
            ASSERT_NEAR(double(length(cross(r, real(m.n)))), double(m.ratio() * m.sine()), double(room(m, kSteps)));
            ASSERT_NEAR(double(length(r)), 1, double(room(m, kSteps))) << "ray " << i << ", ratio " << double(ratio);
            ASSERT_LT(dot(r, real(m.n)), 0) << "ray " << i << ", ratio " << double(ratio);
        }
    }
}

TEST(P08, InFixedPointReflectionIsTotalFromTheCriticalAngleOn) {
    constexpr Real80 kSteps = 4;
    for (const Real80 ratio : {4 / 3.0L, 1.5L, 2.4L}) {
        int seen[2] = {0, 0};
        for (int step = -256; step < 256; ++step) {
            const Meeting m = at_angle(std::asin((1 + step * 0x1p-31L) / ratio), ratio);
            const Real80 excess = m.ratio() * real(m.d.x) - 1;
            if (std::abs(excess) <= kSteps * kStep * m.ratio()) continue;
            ASSERT_EQ(refract(m.d, m.n, m.eta).total, excess > 0) << "step " << step << ", ratio " << double(ratio);
            ++seen[excess > 0];
        }
        EXPECT_GT(seen[0], 100);
        EXPECT_GT(seen[1], 100);
    }
}

TEST(P09, InFixedPointLightTakesTheSameWayBack) {
    constexpr Real80 kSteps = 64;
    Random random(91);
    for (const Real80 ratio : kRatios) {
        for (int i = 0; i < kRays; ++i) {
            const Meeting m = random_meeting(random, ratio);
            if (m.behind2() < 1e-2L || m.before() < 0.1L) continue;
            const auto there = refract(m.d, m.n, m.eta);
            const auto back = refract(-there.d, -m.n, nearest<Rat>(1 / m.ratio()));
            ASSERT_FALSE(back.total) << i;
            ASSERT_LE(double(length(real(back.d) + real(m.d))), double(room(m, kSteps) / m.before()))
                << "ray " << i << ", ratio " << double(ratio);
        }
    }
}

/// The textbook's reflected share of one polarisation, and of light without one.
struct Shares {
    Real80 across, within, both;
};
Shares by_the_book(const Meeting& m) {
    const Real80 a = m.before(), b = std::sqrt(m.behind2()), eta = m.ratio();
    const Real80 across = std::pow((eta * a - b) / (eta * a + b), 2),
                 within = std::pow((a - eta * b) / (a + eta * b), 2);
    return {across, within, (across + within) / 2};
}

TEST(P29, InFixedPointReflectanceIsFresnels) {
    // Steps of the operands, over the cosine behind and the sum of both that they are divided by.
    constexpr Real80 kSteps = 64;
    Random random(292);
    for (const Real80 ratio : kRatios) {
        for (int i = 0; i < kRays; ++i) {
            const Meeting m = random_meeting(random, ratio);
            if (m.behind2() < 1e-4L) continue;
            const auto got = fresnel_reflectance(m.d, m.n, m.eta);
            const Shares wanted = by_the_book(m);
            const double most = double(room(m, kSteps) / (m.before() + std::sqrt(m.behind2())));
            ASSERT_NEAR(double(real(got.across)), double(wanted.across), most) << i << ", ratio " << double(ratio);
            ASSERT_NEAR(double(real(got.within)), double(wanted.within), most) << i << ", ratio " << double(ratio);
            ASSERT_NEAR(double(real(unpolarised(got))), double(wanted.both), most) << i << ", ratio " << double(ratio);
        }
    }
}

TEST(P29, InFixedPointHeadOnAndTotalReflectionAreExact) {
    for (const auto& [index, share] : {std::pair{1, 0.0L}, {3, 0.25L}, {7, 0.5625L}}) {
        EXPECT_EQ(real(unpolarised(fresnel_reflectance(at_angle(0, index).d, at_angle(0, index).n, Rat(index)))),
                  share);
    }
    for (int step = 1; step < 64; ++step) {
        const Meeting m = at_angle(std::asin(1 / 1.5L) + step * 0.01L, 1.5L);
        EXPECT_EQ(real(unpolarised(fresnel_reflectance(m.d, m.n, m.eta))), 1) << step;
    }
}

TEST(P29, InFixedPointEveryWidthGivesTheSameBits) {
    Random random(293);
    for (const Real80 ratio : kRatios) {
        for (int g = 0; g < 200; ++g) {
            std::array<Vec3<Dir>, kGroup> d, n;
            for (std::size_t k = 0; k < kGroup; ++k) {
                const Meeting m = random_meeting(random, ratio);
                d[k] = m.d, n[k] = m.n;
            }
            const Rat eta = nearest<Rat>(ratio);
            const auto eight =
                unpolarised(fresnel_reflectance(packed<8>(d, 0), packed<8>(n, 0), Ratio<FixedNumbers<8>>(eta)));
            for (int k = 0; k < kGroup; ++k) {
                const auto i = static_cast<std::size_t>(k);
                ASSERT_EQ(unpolarised(fresnel_reflectance(d[i], n[i], eta)).raw, lane(eight, k).raw) << g << ", " << k;
            }
        }
    }
}

TEST(P30, InFixedPointNothingThatSwingsInThePlaneIsReflectedAtBrewstersAngle) {
    constexpr Real80 kSteps = 8;
    for (const Real80 ratio : kRatios) {
        const Meeting m = at_angle(std::atan2(1.0L, real(nearest<Rat>(ratio))), ratio);
        const auto got = fresnel_reflectance(m.d, m.n, m.eta);
        const Real80 eta = m.ratio(), share = std::pow((eta * eta - 1) / (eta * eta + 1), 2);
        // The square of a few steps is less than one.
        EXPECT_EQ(got.within.raw, 0) << double(ratio);
        EXPECT_NEAR(double(real(got.across)), double(share), double(kSteps * kStep * std::max(eta, 1 / eta)));
        EXPECT_NEAR(double(real(unpolarised(got))), double(real(got.across) / 2), double(kStep)) << double(ratio);
    }
}

}  // namespace
}  // namespace zerkalo::test
