// The lobe's lattice has the lobe's density, keeps its width for any exponent, and spreads its rotations evenly.
#include "core/optics/lattice.hpp"

#include "tests/core/optics/share_of_ray.hpp"
#include "tests/core/support/random.hpp"
#include "tests/core/support/rays.hpp"
#include "tests/core/support/widths.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace zerkalo::test {
namespace {

constexpr float kLatticeExponents[] = {0, 1, 1e3f, 1e9f};

class Lattice : public Widths {
protected:
    /// Points of a lattice of `count`, padded; only the first `count` mean something.
    static PointList points(int count, float inverse_exponent) {
        PointList out(static_cast<std::size_t>((count + 15) / 16 * 16));
        optics().lattice(count, inverse_exponent, out.out(), out.count());
        return out;
    }
};
class P15 : public Lattice {};
class P16 : public Lattice {};

float inverse_of(float exponent) { return 1 / (exponent + 1); }

// The mean over all rotations is the integral of each camera ray's own lobe, not only of the pixel's.
TEST(LatticeParts, RotationsGiveEveryCameraSampleEveryPartOfTheShares) {
    constexpr int kRotationsAPart = 400;
    for (const std::int32_t parts : {1, 2, 3, 16, 25}) {
        for (std::int32_t a = 0; a < parts; a += 1 + parts / 3) {
            std::vector<int> seen(static_cast<std::size_t>(parts));
            for (std::int32_t k = 0; k < kRotationsAPart * parts; ++k) {
                const Sampling sampling = sampling_of(Estimator::fibonacci, static_cast<std::uint32_t>(k));
                const LatticePart part = lattice_part(sampling, static_cast<std::uint32_t>(a), parts);
                ++seen[static_cast<std::size_t>(part.place[0] * std::int64_t{parts} >> kPlaceBits)];
            }
            // Five standard deviations of a binomial count, hardly below those of Poisson's.
            for (const int count : seen) {
                EXPECT_NEAR(count, kRotationsAPart, 5 * std::sqrt(kRotationsAPart)) << "sample " << a << " of " << parts;
            }
        }
    }
}

// All of them together are one lattice, whatever the rotation.
TEST(LatticeParts, ARotationGivesEachPartToOneCameraSample) {
    for (const std::int32_t parts : {1, 2, 3, 16, 25}) {
        for (std::uint32_t rotation = 0; rotation < 200; ++rotation) {
            std::vector<int> seen(static_cast<std::size_t>(parts));
            for (std::int32_t a = 0; a < parts; ++a) {
                const LatticePart part = lattice_part(sampling_of(Estimator::fibonacci, rotation),
                                                      static_cast<std::uint32_t>(a), parts);
                ++seen[static_cast<std::size_t>(part.place[0] * std::int64_t{parts} >> kPlaceBits)];
            }
            for (const int count : seen) ASSERT_EQ(count, 1) << "rotation " << rotation << ", " << parts << " parts";
        }
    }
}

TEST_P(Lattice, LobePointIsTheClosedFormForEveryExponent) {
    Random random(91);
    // Logarithm, power and sine each within 2.5e-7; the root halves the first two.
    constexpr Real80 kAcross = 5e-7L, kForward = 3e-7L;
    for (const float n : kLatticeExponents) {
        Floats u, turn;
        PointList p(kLawRays);
        while (u.size() < kLawRays) {
            u.push_back(float(random.below(2) == 0 ? random.uniform(1e-6, 1) : 1 - std::exp2(random.uniform(-20, -1))));
            turn.push_back(float(random.uniform(-0.5, 0.5)));
        }
        optics().lobe(u.data(), turn.data(), inverse_of(n), p.out(), p.count());
        for (std::size_t k = 0; k < u.size(); ++k) {
            const Real80 from_axis = -std::expm1(std::log(Real80(u[k])) * inverse_of(n));
            const Real80 across = std::sqrt(from_axis * (2 - from_axis)), angle = 2 * kPi80 * turn[k];
            SCOPED_TRACE(testing::Message() << std::hexfloat << "u " << u[k] << " turn " << turn[k] << " n " << n);
            ASSERT_LE(std::abs(p[k].x - across * std::cos(angle)), kAcross * across);
            ASSERT_LE(std::abs(p[k].y - across * std::sin(angle)), kAcross * across);
            ASSERT_LE(std::abs(p[k].z - (1 - from_axis)), kForward);
        }
    }
}

TEST_P(P16, ShareOfRaysInsideAnAngleIsThatOfTheLobe) {
    for (const float n : kLatticeExponents) {
        for (const int count : {1, 7, 64, 1000, 4097}) {
            const PointList p = points(count, inverse_of(n));
            for (const Real80 share : {0.05L, 0.31L, 0.5L, 0.77L, 0.99L}) {
                // Inside g lies the share 1 - cos^(n+1) g; 1 - cos g of this g, without cancellation:
                const Real80 from_axis = -std::expm1(std::log1p(-share) * inverse_of(n));
                const Real80 across = std::sqrt(from_axis * (2 - from_axis));
                Real80 inside = 0;
                for (int k = 0; k < count; ++k) {
                    const Exact3 ray = p[static_cast<std::size_t>(k)];
                    if (std::hypot(ray.x, ray.y) < across) inside += share_of_ray(k, count);
                }
                // The midpoint rule is never off by more than half a ray; a ray on the cone itself may fall either way.
                const Real80 room = (0.5L + 1e-3L) / rays_in_all(Estimator::fibonacci, count);
                ASSERT_LE(std::abs(inside - share), room) << "n " << n << ", " << count << " rays";
            }
        }
    }
}

TEST_P(P16, MeanCosineIsThatOfTheLobe) {
    // The midpoint rule's own error is below 1/N^(3/2) for every n, and each ray brings its rounding.
    constexpr int kRays = 4096;
    constexpr Real80 kRoom = 1 / (64.0L * 64 * 64) + 4 * kU;
    for (const float n : {0.0f, 1.0f, 5.0f, 1e3f, 1e6f}) {
        const PointList p = points(kRays, inverse_of(n));
        Real80 sum = 0;
        for (int k = 0; k < kRays; ++k) sum += share_of_ray(k, kRays) * p[static_cast<std::size_t>(k)].z;
        EXPECT_LE(std::abs(sum - (n + 1.0L) / (n + 2.0L)), kRoom) << "n " << n;
    }
}

// At normal incidence the lobe's axis is the mirror's normal, so cos_o = 1 and cos_i is the ray's own forward part.
TEST_P(P15, MaxPhongAlbedoAtNormalIncidenceIsTheClosedForm) {
    constexpr int kRays = 4096;
    constexpr Real80 kRoom = 1 / (64.0L * 64 * 64) + 4 * kU;
    for (const float n : {0.0f, 1.0f, 100.0f, 1e4f}) {
        const PointList p = points(kRays, inverse_of(n));
        Floats weight(kRays);
        optics().weight(p.z.data(), 1, weight.data(), kRays);
        Real80 sum = 0;
        for (int k = 0; k < kRays; ++k) sum += share_of_ray(k, kRays) * weight[static_cast<std::size_t>(k)];
        EXPECT_LE(std::abs(sum - (n + 1.0L) / (n + 2.0L)), kRoom) << "n " << n;
    }
}

TEST_P(Lattice, WeightIsTheRatioOfCosinesBetweenZeroAndOne) {
    const Floats cosine{-1, -0.5f, -0.0f, 0, 0.125f, 0.25f, 0.5f, 1, 0.375f, -1e-30f, 1e-30f, 0.0625f, 0, 0, 0, 0};
    const Floats wanted{0, 0, 0, 0, 0.25f, 0.5f, 1, 1, 0.75f, 0, 2e-30f, 0.125f, 0, 0, 0, 0};
    Floats weight(cosine.size());
    optics().weight(cosine.data(), 2, weight.data(), static_cast<int>(cosine.size()));
    for (std::size_t k = 0; k < weight.size(); ++k) EXPECT_EQ(weight[k], wanted[k]) << "cosine " << cosine[k];
}

TEST_P(Lattice, RaysAreUnit) {
    constexpr Real80 kRoom = 6e-7L;  // twice the error of a point across
    for (const float n : kLatticeExponents) {
        const PointList p = points(1000, inverse_of(n));
        for (std::size_t k = 0; k < 1000; ++k) {
            ASSERT_LE(std::abs(length(p[k]) - 1), kRoom) << "ray " << k << " n " << n;
            ASSERT_GE(p[k].z, 0) << "ray " << k << " n " << n;
        }
    }
}

// Golden-angle steps leave no gap of more than 2.7 times the mean between neighbours (three-distance theorem).
TEST_P(Lattice, AzimuthsAreEvenlySpread) {
    for (const int count : {8, 55, 200, 1024}) {
        const PointList p = points(count, inverse_of(1));
        std::vector<double> turns;
        for (int k = 0; k < count; ++k) {
            const Exact3 ray = p[static_cast<std::size_t>(k)];
            turns.push_back(double(std::atan2(ray.y, ray.x) / (2 * kPi80)));
        }
        std::sort(turns.begin(), turns.end());
        double widest = turns.front() + 1 - turns.back();
        for (std::size_t k = 1; k < turns.size(); ++k) widest = std::max(widest, turns[k] - turns[k - 1]);
        EXPECT_LT(widest, 2.7 / count) << count << " rays";
    }
}

TEST_P(Lattice, EveryWidthGivesTheSameBits) {
    for (const float n : kLatticeExponents) {
        for (const int count : {1, 16, 1000}) {
            const PointList here = points(count, inverse_of(n));
            PointList there(here.size());
            scalar().optics.lattice(count, inverse_of(n), there.out(), there.count());
            expect_same_bits(here.x, there.x, "side");
            expect_same_bits(here.y, there.y, "up");
            expect_same_bits(here.z, there.z, "forward");
        }
    }
}

ZERKALO_OVER_ALL_WIDTHS(P15);
ZERKALO_OVER_ALL_WIDTHS(P16);
ZERKALO_OVER_ALL_WIDTHS(Lattice);

TEST(LatticeClasses, EveryBlockOfFourPixelsHasOneOfEach) {
    Random random(92);
    for (int round = 0; round < 1000; ++round) {
        const auto hash = static_cast<std::uint32_t>(random.bits());
        const LatticeClasses classes = lattice_classes(hash);
        for (int block = 0; block < 16; ++block) {
            const int corner = (block / 4) * 16 + (block % 4) * 2;
            unsigned seen = 0;
            for (const int pixel : {corner, corner + 1, corner + 8, corner + 9})
                seen |= 1u << class_of_pixel(classes, pixel);
            ASSERT_EQ(seen, 15u) << std::hex << "hash " << hash << " block " << block;
        }
    }
}

TEST(LatticeClasses, PixelsOfAClassAreThoseThatHaveIt) {
    Random random(93);
    for (int round = 0; round < 1000; ++round) {
        const LatticeClasses classes = lattice_classes(static_cast<std::uint32_t>(random.bits()));
        for (int c = 0; c < kLatticeClasses; ++c) {
            const std::uint64_t pixels = pixels_of_class(classes, c);
            for (int pixel = 0; pixel < 64; ++pixel) {
                ASSERT_EQ(pixels >> pixel & 1, class_of_pixel(classes, pixel) == c) << "class " << c << " " << pixel;
            }
        }
    }
}

TEST(LatticeClasses, ClassesAreAQuarterTurnApart) {
    for (const std::uint32_t rotation : {0u, 3u}) {
        const Sampling frame = sampling_of(Estimator::fibonacci, rotation);
        for (int k = 0; k < kLatticeClasses; ++k) {
            const float step = turn_of_class(frame, (k + 1) % 4) - turn_of_class(frame, k);
            EXPECT_EQ(step < 0 ? step + 1 : step, 0.25f) << "class " << k << " rotation " << rotation;
        }
    }
    const Sampling first = sampling_of(Estimator::fibonacci, 0), second = sampling_of(Estimator::fibonacci, 1);
    EXPECT_NE(turn_of_class(first, 0), turn_of_class(second, 0));
}

TEST(LatticeClasses, HashHasItsPublishedValues) {
    // By hand from the definition of lowbias32: 0 is a fixed point; a bijection never meets a value twice.
    EXPECT_EQ(hash_bits(0u), 0u);
    std::vector<std::uint32_t> values;
    for (std::uint32_t key = 0; key < 1u << 16; ++key) values.push_back(hash_bits(key * 65537u));
    std::sort(values.begin(), values.end());
    EXPECT_EQ(std::adjacent_find(values.begin(), values.end()), values.end());
}

}  // namespace
}  // namespace zerkalo::test
