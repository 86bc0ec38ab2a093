// P29, P30: how much a transparent surface reflects, against the textbook form of Fresnel's equations.
#include "tests/core/support/random.hpp"
#include "tests/core/support/rays.hpp"
#include "tests/core/support/widths.hpp"

namespace zerkalo::test {
namespace {

constexpr float kIndexRatios[] = {0.1f, 0.4f, 1 / 1.5f, 0.75f, 1 - 0x1p-20f, 1, 1 + 0x1p-20f, 4.0f / 3, 1.5f, 2.4f, 10};

struct Incidence {
    PointList d, n;
    Floats eta;

    void add(const Exact3& direction, const Exact3& normal, float ratio) {
        d.add(direction), n.add(normal), eta.push_back(ratio);
    }
    void pad() {
        while (d.size() % probes::kWidest != 0) add(d[d.size() - 1], n[n.size() - 1], eta.back());
    }
};

/// In the plane y = 0, on the surface z = 0.
void add_at_angle(Incidence& rays, Real80 angle, float ratio) {
    rays.add({std::sin(angle), 0, -std::cos(angle)}, {0, 0, 1}, ratio);
}

/// All angles of incidence, for one ratio of indices, in any plane.
Incidence everywhere(float ratio, Random& random) {
    Incidence rays;
    while (rays.d.size() < kLawRays / 20) {
        const Exact3 n = random.direction(), across = unit(cross(n, random.direction()));
        const Real80 angle = kRightAngle * random.uniform(0, 1);
        rays.add(across * std::sin(angle) - n * std::cos(angle), n, ratio);
    }
    return rays;
}

/// Cosines and sine of an incidence by geometry alone; what the floats lack of unit length is put right first.
struct Angles {
    Real80 before, behind2, sine;
};
Angles angles_of(const Incidence& rays, std::size_t k) {
    const Exact3 d = unit(rays.d[k]), n = unit(rays.n[k]);
    const Real80 sine = length(cross(d, n)), bent = rays.eta[k] * sine;
    return {-dot(d, n), (1 - bent) * (1 + bent), sine};
}

class Fresnel : public Widths {
protected:
    struct Shares {
        Floats across, within, both;
    };
    static Shares shares_of(const probes::OpticsProbes& optics, const Incidence& rays) {
        const std::size_t count = rays.d.size();
        Shares shares{Floats(count), Floats(count), Floats(count)};
        optics.fresnel(rays.d, rays.n, rays.eta.data(), shares.across.data(), shares.within.data(), shares.both.data(),
                       rays.d.count());
        return shares;
    }
    static Shares shares_of(const Incidence& rays) { return shares_of(optics(), rays); }
    static std::string text_of(const Incidence& rays, std::size_t k) {
        return text(rays.d[k]) + " at " + text(rays.n[k]) + " eta " + std::to_string(rays.eta[k]);
    }
};

class P29 : public Fresnel {};
class P30 : public Fresnel {};

TEST_P(P29, WhatIsReflectedAndWhatGoesThroughAreOne) {
    // A rounding of the sine is divided by the cosine behind the surface, as in Snell's law; of the cosine, by eta.
    constexpr Real80 kRoundings = 24;
    Random random(291);
    for (const float eta : kIndexRatios) {
        const Incidence rays = everywhere(eta, random);
        const Shares shares = shares_of(rays);
        for (std::size_t k = 0; k < rays.d.size(); ++k) {
            const Angles at = angles_of(rays, k);
            if (at.behind2 < 1e-5L) continue;
            // The transmitted shares of the textbook: another formula than the one under test.
            const Real80 a = at.before, b = std::sqrt(at.behind2);
            const Real80 through_across = 4 * eta * a * b / ((eta * a + b) * (eta * a + b));
            const Real80 through_within = 4 * eta * a * b / ((a + eta * b) * (a + eta * b));
            const Real80 room = kRoundings * kU * std::max(1.0f, eta) / b;
            ASSERT_NEAR(double(shares.across[k] + through_across), 1, double(room)) << text_of(rays, k);
            ASSERT_NEAR(double(shares.within[k] + through_within), 1, double(room)) << text_of(rays, k);
            ASSERT_NEAR(double(shares.both[k] + (through_across + through_within) / 2), 1, double(room))
                << text_of(rays, k);
        }
    }
}

TEST_P(P29, HeadOnItIsTheSquareOfTheRatioOfDifferenceAndSum) {
    // Relative to itself.
    constexpr Real80 kRoundings = 8;
    Incidence rays;
    for (const float eta : kIndexRatios) rays.add({0, 0, -1}, {0, 0, 1}, eta);
    // Numbers without a rounding: 1/4 and 9/16.
    const float exact_ratios[] = {1, 3, 7}, exact_shares[] = {0, 0.25f, 0.5625f};
    for (const float eta : exact_ratios) rays.add({0, 0, -1}, {0, 0, 1}, eta);
    const std::size_t first_exact = std::size(kIndexRatios);
    rays.pad();
    const Shares shares = shares_of(rays);
    for (std::size_t k = 0; k < first_exact; ++k) {
        const Real80 amplitude = (rays.eta[k] - 1.0L) / (rays.eta[k] + 1.0L), share = amplitude * amplitude;
        EXPECT_NEAR(shares.both[k], double(share), double(kRoundings * kU * share)) << "eta " << rays.eta[k];
    }
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(shares.both[first_exact + k], exact_shares[k]) << exact_ratios[k];
}

TEST_P(P29, KeepsItsDigitsWhereTheIndicesAreNearlyEqual) {
    // Relative to itself, where the textbook's eta a - b keeps a few digits of seven and squares what is wrong.
    constexpr Real80 kRoundings = 32;
    Incidence rays;
    for (int power = 2; power <= 20; ++power) {
        for (int step = 0; step <= 24; ++step) {
            for (const float eta : {1 - std::ldexp(1.0f, -power), 1 / (1 - std::ldexp(1.0f, -power))}) {
                add_at_angle(rays, 0.05L * step, eta);
            }
        }
    }
    rays.pad();
    const Shares shares = shares_of(rays);
    for (std::size_t k = 0; k < rays.d.size(); ++k) {
        const Angles at = angles_of(rays, k);
        if (at.behind2 < 0.05L) continue;
        const Real80 eta = rays.eta[k], a = at.before, b = std::sqrt(at.behind2);
        const Real80 across = (eta * a - b) / (eta * a + b), within = (a - eta * b) / (a + eta * b);
        const Real80 share = (across * across + within * within) / 2;
        ASSERT_NEAR(shares.both[k], double(share), double(kRoundings * kU * share / b)) << text_of(rays, k);
    }
}

TEST_P(P29, GrazingLightIsReflectedWhole) {
    constexpr double kRoundings = 4;
    Incidence rays;
    for (const float eta : kIndexRatios) rays.add({1, 0, 0}, {0, 0, 1}, eta);
    rays.pad();
    const Shares shares = shares_of(rays);
    for (std::size_t k = 0; k < rays.d.size(); ++k) {
        EXPECT_LE(shares.both[k], 1) << "eta " << rays.eta[k];
        EXPECT_GE(shares.both[k], 1 - kRoundings * double(kU)) << "eta " << rays.eta[k];
    }
}

TEST_P(P29, TotalReflectionIsExactlyOneAndBeginsWithoutAStep) {
    for (const float eta : {1.0625f, 4.0f / 3, 1.5f, 2.4f, 10.0f}) {
        const Real80 critical = std::asin(1 / Real80(eta));
        Incidence beyond, before;
        for (int step = 1; step <= 160; ++step) {
            add_at_angle(beyond, critical + (kRightAngle - critical) * (step / 160.0L), eta);
            add_at_angle(before, critical * (1 - std::ldexp(1.0L, -step / 8)), eta);
        }
        for (const float share : shares_of(beyond).both) ASSERT_EQ(share, 1) << "eta " << eta;
        const Shares shares = shares_of(before);
        // What goes through is at most 4 eta b / a (the textbook's shares at b = 0), b known to the root of a rounding.
        for (std::size_t k = 0; k < before.d.size(); ++k) {
            const Angles at = angles_of(before, k);
            const Real80 behind = std::sqrt(std::max<Real80>(0, at.behind2)) + std::sqrt(kU);
            ASSERT_LE(shares.both[k], 1) << text_of(before, k);
            ASSERT_GE(shares.both[k], double(1 - 4 * eta * behind / at.before)) << text_of(before, k);
        }
    }
}

TEST_P(P29, IsTheSameFromBothSides) {
    constexpr Real80 kRoundings = 48;
    Random random(292);
    for (const float eta : kIndexRatios) {
        const Incidence there = everywhere(eta, random);
        PointList bent(there.d.size());
        Floats total(there.d.size());
        optics().refract(there.d, there.n, there.eta.data(), bent.out(), total.data(), there.d.count());
        Incidence back;
        for (std::size_t k = 0; k < there.d.size(); ++k) back.add(-bent[k], -there.n[k], 1 / eta);
        const Shares one = shares_of(there), other = shares_of(back);
        for (std::size_t k = 0; k < there.d.size(); ++k) {
            const Angles at = angles_of(there, k);
            if (at.behind2 < 1e-4L || at.before < 1e-2L) continue;
            const Real80 least = std::min(at.before, std::sqrt(at.behind2));
            ASSERT_NEAR(one.both[k], other.both[k], double(kRoundings * kU * std::max(eta, 1 / eta) / least))
                << text_of(there, k);
        }
    }
}

TEST_P(P29, IsAShareWhateverTheIndex) {
    Random random(293);
    Incidence rays;
    while (rays.d.size() < kLawRays) {
        const Exact3 n = random.direction();
        const Exact3 d = random.below(4) == 0 ? unit(cross(n, random.direction())) : random.direction();
        rays.add(dot(d, n) > 0 ? -d : d, n, float(std::exp2(random.uniform(-140, 127))));
    }
    const Shares shares = shares_of(rays);
    for (std::size_t k = 0; k < rays.d.size(); ++k) {
        for (const float share : {shares.across[k], shares.within[k], shares.both[k]}) {
            ASSERT_TRUE(share >= 0 && share <= 1) << share << " for " << text_of(rays, k);
        }
        // What swings in the plane is never reflected more.
        ASSERT_LE(shares.within[k], shares.across[k]) << text_of(rays, k);
    }
}

TEST_P(P29, EveryWidthGivesTheSameBits) {
    Random random(294);
    for (const float eta : kIndexRatios) {
        const Incidence rays = everywhere(eta, random);
        const Shares here = shares_of(rays), there = shares_of(scalar().optics, rays);
        expect_same_bits(here.across, there.across, "across");
        expect_same_bits(here.within, there.within, "within");
        expect_same_bits(here.both, there.both, "both");
    }
}

/// tan(angle) = index behind / index before = 1 / eta.
Real80 brewster_angle(float eta) { return std::atan2(1.0L, Real80(eta)); }

TEST_P(P30, AtBrewstersAngleNothingThatSwingsInThePlaneIsReflected) {
    // The cosines' product and the sines' are equal but for their roundings; the share is the square of what remains.
    constexpr Real80 kRoundings = 8;
    Incidence rays;
    for (const float eta : kIndexRatios) add_at_angle(rays, brewster_angle(eta), eta);
    rays.pad();
    const Shares shares = shares_of(rays);
    for (std::size_t k = 0; k < rays.d.size(); ++k) {
        const Real80 eta = rays.eta[k], amplitude = (eta * eta - 1) / (eta * eta + 1), share = amplitude * amplitude;
        const Real80 rest = kRoundings * kU * std::max(eta, 1 / eta);
        EXPECT_LE(shares.within[k], double(rest * rest * share)) << "eta " << rays.eta[k];
        EXPECT_NEAR(shares.across[k], double(share), double(2 * rest * share)) << "eta " << rays.eta[k];
        EXPECT_EQ(shares.both[k], shares.across[k] / 2) << "eta " << rays.eta[k];
    }
}

TEST_P(P30, BesideBrewstersAngleSomeOfItIs) {
    for (const float eta : kIndexRatios) {
        if (eta == 1) continue;
        Incidence rays;
        for (int step = -8; step < 8; ++step) add_at_angle(rays, brewster_angle(eta) * (1 + step / 4096.0L), eta);
        const Floats within = shares_of(rays).within;
        for (std::size_t k = 0; k + 1 < within.size(); ++k) {
            const float nearer = k < 8 ? within[k + 1] : within[k], farther = k < 8 ? within[k] : within[k + 1];
            EXPECT_LT(nearer, farther) << "eta " << eta << ", step " << k;
        }
    }
}

ZERKALO_OVER_ALL_WIDTHS(P29);
ZERKALO_OVER_ALL_WIDTHS(P30);

}  // namespace
}  // namespace zerkalo::test
