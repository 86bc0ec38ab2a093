// Reflection, refraction and frames obey geometry: coplanar, unit, reversible, orthonormal, at every width.
#include "tests/core/support/random.hpp"
#include "tests/core/support/rays.hpp"
#include "tests/core/support/widths.hpp"

#include <algorithm>

namespace zerkalo::test {
namespace {

class Directions : public Widths {
protected:
    static PointList reflected(const PointList& d, const PointList& n) {
        PointList out(d.size());
        optics().reflect(d, n, out.out(), d.count());
        return out;
    }
    struct Bent {
        PointList d;
        Floats total;
    };
    static Bent refracted(const PointList& d, const PointList& n, const Floats& eta) {
        Bent bent{PointList(d.size()), Floats(d.size())};
        optics().refract(d, n, eta.data(), bent.d.out(), bent.total.data(), d.count());
        return bent;
    }
};
class P01 : public Directions {};
class P07 : public Directions {};
class P08 : public Directions {};
class P09 : public Directions {};

TEST_P(P01, AngleOfIncidenceEqualsAngleOfReflection) {
    // Inputs are unit to 2 u; a dot product, a doubling, a product and a subtraction follow.
    constexpr Real80 kRoundings = 12;
    Random random(81);
    PointList d, n;
    while (d.size() < kLawRays) d.add(random.direction()), n.add(random.direction());
    const PointList r = reflected(d, n);
    for (std::size_t k = 0; k < d.size(); ++k) {
        ASSERT_LE(std::abs(dot(r[k], n[k]) + dot(d[k], n[k])), kRoundings * kU) << text(d[k]) << " at " << text(n[k]);
        ASSERT_LE(std::abs(dot(cross(d[k], n[k]), r[k])), kRoundings * kU) << text(d[k]) << " at " << text(n[k]);
        ASSERT_LE(std::abs(length(r[k]) - 1), kRoundings * kU) << text(d[k]) << " at " << text(n[k]);
    }
}

TEST_P(P01, ReflectionAtACoordinatePlaneFlipsOneSign) {
    Random random(82);
    const Exact3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int axis = 0; axis < 6; ++axis) {
        PointList d, n;
        while (d.size() < 1024) d.add(random.direction()), n.add(axes[axis]);
        PointList wanted = d;
        for (float& c : axis / 2 == 0 ? wanted.x : axis / 2 == 1 ? wanted.y : wanted.z) c = -c;
        const PointList r = reflected(d, n);
        expect_same_bits(r.x, wanted.x, "x");
        expect_same_bits(r.y, wanted.y, "y");
        expect_same_bits(r.z, wanted.z, "z");
    }
}

TEST_P(Directions, MirrorDirectionIsReflectionSeenFromTheSurface) {
    // 2 n (n.l) - l is the reflection of -l, the same roundings with the opposite sign.
    Random random(83);
    PointList l, n, out(kLawRays);
    while (l.size() < kLawRays) l.add(random.direction()), n.add(random.direction());
    optics().mirror_direction(l, n, out.out(), l.count());
    PointList away = l;
    for (std::vector<float>* part : {&away.x, &away.y, &away.z}) {
        for (float& c : *part) c = -c;
    }
    const PointList r = reflected(away, n);
    for (std::size_t k = 0; k < l.size(); ++k)
        ASSERT_EQ(text(out[k]), text(r[k])) << text(l[k]) << " at " << text(n[k]);
}

/// A direction that meets the normal n at the given angle.
Exact3 meeting(const Exact3& n, Real80 angle, Random& random) {
    const Exact3 across = unit(cross(n, random.direction()));
    return across * std::sin(angle) - n * std::cos(angle);
}

constexpr float kRatios[] = {0.4f, 1 / 1.5f, 0.75f, 1, 4.0f / 3, 1.5f, 2.4f};

TEST_P(P07, RefractionObeysSnell) {
    constexpr Real80 kRoundings = 24;
    Random random(84);
    for (const float ratio : kRatios) {
        PointList d, n;
        while (d.size() < kLawRays / 10) {
            const Exact3 normal = random.direction();
            n.add(normal), d.add(meeting(normal, kRightAngle * random.uniform(0, 1), random));
        }
        const Floats eta(d.size(), ratio);
        const Bent bent = refracted(d, n, eta);
        std::size_t through = 0;
        for (std::size_t k = 0; k < d.size(); ++k) {
            const Real80 sine_in = length(cross(d[k], n[k])), sine_out = ratio * sine_in;
            if (std::abs(sine_out - 1) < 1e-5L) continue;
            ASSERT_EQ(bent.total[k], sine_out > 1 ? 1 : 0) << text(d[k]) << " at " << text(n[k]) << " eta " << ratio;
            if (sine_out > 1) continue;
            ++through;
            // Roundings under the root are divided by the cosine behind the surface.
            const Real80 room = kRoundings * kU * std::max(1.0f, ratio) / std::sqrt(1 - sine_out * sine_out);
            const Exact3 r = bent.d[k];
            ASSERT_LE(std::abs(length(cross(r, n[k])) - sine_out), room) << text(d[k]) << " at " << text(n[k]);
            ASSERT_LE(std::abs(dot(cross(d[k], n[k]), r)), room) << text(d[k]) << " leaves its plane";
            ASSERT_LE(std::abs(length(r) - 1), room) << text(d[k]) << " at " << text(n[k]) << " eta " << ratio;
            ASSERT_LT(dot(r, n[k]), 0) << text(d[k]) << " turns back";
        }
        EXPECT_GT(through, d.size() / 5) << ratio;
    }
}

TEST_P(P07, LightThatMeetsTheSurfaceHeadOnGoesStraightOn) {
    // eta - 1 is exact between 1/2 and 2: not a bit of the direction changes.
    const Exact3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const Exact3& axis : axes) {
        PointList d, n;
        Floats eta;
        for (int k = 0; k < 512; ++k) d.add(-axis), n.add(axis), eta.push_back(0.5f + 1.5f * float(k) / 511);
        const Bent bent = refracted(d, n, eta);
        for (std::size_t k = 0; k < d.size(); ++k) {
            // As numbers: a component that is zero may change its sign.
            ASSERT_TRUE(bent.d.x[k] == d.x[k] && bent.d.y[k] == d.y[k] && bent.d.z[k] == d.z[k])
                << text(bent.d[k]) << " instead of " << text(d[k]) << ", eta " << eta[k];
        }
    }
}

TEST_P(P08, ReflectionIsTotalFromTheCriticalAngleOn) {
    // The sine of the angle is known to a few roundings, and no better.
    constexpr Real80 kRoundings = 3;
    for (const float ratio : {1.0625f, 4.0f / 3, 1.5f, 2.4f}) {
        PointList d, n;
        std::vector<bool> total;
        for (int step = -512; step < 512; ++step) {
            const Real80 sine = (1 + step * 0x1p-26L) / ratio;
            d.add({sine, 0, -std::sqrt(1 - sine * sine)}), n.add({0, 0, 1});
        }
        const Bent bent = refracted(d, n, Floats(d.size(), ratio));
        int seen[2] = {0, 0};
        for (std::size_t k = 0; k < d.size(); ++k) {
            const Real80 excess = ratio * std::hypot(d[k].x, d[k].y) - 1;
            if (std::abs(excess) <= kRoundings * kU) continue;
            ASSERT_EQ(bent.total[k], excess > 0 ? 1 : 0) << text(d[k]) << " eta " << ratio;
            ++seen[excess > 0];
        }
        EXPECT_GT(seen[0], 300);
        EXPECT_GT(seen[1], 300);
    }
}

TEST_P(P09, LightTakesTheSameWayBack) {
    constexpr Real80 kRoundings = 64;
    Random random(85);
    for (const float ratio : kRatios) {
        PointList d, n, back, other_side;
        while (d.size() < kLawRays / 10) {
            const Exact3 normal = random.direction();
            const Real80 widest = std::asin(std::min(1.0L, 1 / Real80(ratio)));
            n.add(normal), d.add(meeting(normal, 0.95L * widest * random.uniform(0, 1), random));
        }
        const Bent there = refracted(d, n, Floats(d.size(), ratio));
        for (std::size_t k = 0; k < d.size(); ++k) back.add(-there.d[k]), other_side.add(-n[k]);
        const Bent again = refracted(back, other_side, Floats(d.size(), 1 / ratio));
        for (std::size_t k = 0; k < d.size(); ++k) {
            const Real80 cosine = std::min(-dot(d[k], n[k]), -dot(there.d[k], n[k]));
            const Real80 room = kRoundings * kU / cosine;
            ASSERT_EQ(again.total[k], 0) << text(d[k]) << " at " << text(n[k]) << " eta " << ratio;
            ASSERT_LE(length(again.d[k] + d[k]), room) << text(d[k]) << " at " << text(n[k]) << " eta " << ratio;
        }
    }
}

TEST_P(P09, OneBounceInsideAWaterDropDeviatesLeastAtTheRainbow) {
    // Descartes: cos^2 i = (n^2 - 1) / 3; the deviation there is a minimum, so it barely depends on i.
    constexpr double kWater = 4.0 / 3, kRainbow = 137.970 * 3.14159265358979323846 / 180, kTabulated = 1e-5;
    const Real80 best = std::acos(std::sqrt((kWater * kWater - 1) / 3));
    constexpr int kSteps = 256;
    PointList d, n, second, third;
    for (int k = -kSteps; k < kSteps; ++k) {
        const Real80 i = best + k * 1e-3L;
        d.add({0, 0, -1}), n.add({std::sin(i), 0, std::cos(i)});
    }
    // A chord of the unit ball from p along d ends at p - 2 (p.d) d; outward normals are the points themselves.
    const auto chord_end = [](const Exact3& p, const Exact3& d_in) { return p - d_in * (2 * dot(p, d_in)); };
    const Bent in = refracted(d, n, Floats(d.size(), float(1 / kWater)));
    for (std::size_t k = 0; k < d.size(); ++k) second.add(-chord_end(n[k], in.d[k]));
    const PointList back = reflected(in.d, second);
    for (std::size_t k = 0; k < d.size(); ++k) third.add(-chord_end(-second[k], back[k]));
    const Bent out = refracted(back, third, Floats(d.size(), float(kWater)));
    std::vector<double> deviation;
    for (std::size_t k = 0; k < d.size(); ++k) {
        ASSERT_EQ(out.total[k], 0) << text(n[k]);
        deviation.push_back(double(std::atan2(length(cross(d[k], out.d[k])), dot(d[k], out.d[k]))));
    }
    const auto least = std::min_element(deviation.begin(), deviation.end());
    EXPECT_NEAR(*least, kRainbow, kTabulated);
    EXPECT_NEAR(deviation[kSteps], kRainbow, kTabulated);
    // Half a degree to both sides the deviation has grown by the parabola's 3e-5 or more.
    EXPECT_LT(std::abs(least - deviation.begin() - kSteps), 9);
    EXPECT_GT(deviation.front(), kRainbow + 0.01);
    EXPECT_GT(deviation.back(), kRainbow + 0.01);
}

TEST_P(Directions, TangentsAreAnOrthonormalFrame) {
    constexpr Real80 kRoundings = 4;
    Random random(86);
    PointList m, t(kLawRays), b(kLawRays);
    for (const Exact3& axis : {Exact3{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {1, 0, -0.0L}}) m.add(axis);
    while (m.size() < kLawRays) {
        // Half of them near the poles, where a naive frame loses its digits.
        const Exact3 free = random.direction();
        const Exact3 pole{free.x * 0x1p-14L, free.y * 0x1p-14L, free.z < 0 ? -1.0L : 1.0L};
        m.add(random.below(2) == 0 ? free : unit(pole));
    }
    optics().tangents(m, t.out(), b.out(), m.count());
    for (std::size_t k = 0; k < m.size(); ++k) {
        const Exact3 axis = m[k];
        ASSERT_LE(std::abs(length(t[k]) - 1), kRoundings * kU) << text(axis);
        ASSERT_LE(std::abs(length(b[k]) - 1), kRoundings * kU) << text(axis);
        ASSERT_LE(std::abs(dot(t[k], b[k])), kRoundings * kU) << text(axis);
        ASSERT_LE(std::abs(dot(t[k], axis)), kRoundings * kU) << text(axis);
        ASSERT_LE(std::abs(dot(b[k], axis)), kRoundings * kU) << text(axis);
        ASSERT_GT(dot(cross(t[k], b[k]), axis), 0) << text(axis) << " is left-handed";
    }
}

TEST_P(Directions, EveryWidthGivesTheSameBits) {
    Random random(87);
    PointList d, n;
    while (d.size() < kLawRays) d.add(random.direction()), n.add(random.direction());
    Floats eta;
    while (eta.size() < d.size()) eta.push_back(float(random.uniform(0.4, 2.5)));
    const Bent here = refracted(d, n, eta);
    Bent there{PointList(d.size()), Floats(d.size())};
    scalar().optics.refract(d, n, eta.data(), there.d.out(), there.total.data(), d.count());
    expect_same_bits(here.d.x, there.d.x, "x");
    expect_same_bits(here.d.y, there.d.y, "y");
    expect_same_bits(here.d.z, there.d.z, "z");
    expect_same_bits(here.total, there.total, "total");
    PointList t(d.size()), b(d.size()), t_scalar(d.size()), b_scalar(d.size());
    optics().tangents(d, t.out(), b.out(), d.count());
    scalar().optics.tangents(d, t_scalar.out(), b_scalar.out(), d.count());
    expect_same_bits(t.x, t_scalar.x, "tangent");
    expect_same_bits(b.y, b_scalar.y, "bitangent");
}

ZERKALO_OVER_ALL_WIDTHS(P01);
ZERKALO_OVER_ALL_WIDTHS(P07);
ZERKALO_OVER_ALL_WIDTHS(P08);
ZERKALO_OVER_ALL_WIDTHS(P09);
ZERKALO_OVER_ALL_WIDTHS(Directions);

}  // namespace
}  // namespace zerkalo::test
