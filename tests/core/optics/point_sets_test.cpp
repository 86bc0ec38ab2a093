// The point sets of the keyed estimators are what their names say, at every width to the same bits.
#include "core/optics/point_sets.hpp"

#include "tests/core/support/random.hpp"
#include "tests/core/support/widths.hpp"

#include <array>
#include <cmath>
#include <set>

namespace zerkalo::test {
namespace {

constexpr Estimator kKeyed[] = {Estimator::random, Estimator::jittered, Estimator::sobol, Estimator::r2};
constexpr std::uint32_t kHalf = 0x80000000u;

/// u and azimuth in turns, 0 to 1.
struct Square {
    Floats u, turn;
    double x(int k) const { return u[static_cast<std::size_t>(k)]; }
    double y(int k) const { return double(turn[static_cast<std::size_t>(k)]) + 0.5; }
};

Square square_of(const probes::Probes& probes, Estimator rule, int count, std::uint32_t key, std::uint32_t half = 0) {
    const auto padded = static_cast<std::size_t>((count + 15) / 16 * 16);
    Square set{Floats(padded), Floats(padded)};
    probes.optics.set(rule, count, key, half, set.u.data(), set.turn.data(), static_cast<int>(padded));
    return set;
}

class PointSets : public Widths {
protected:
    static Square set(Estimator rule, int count, std::uint32_t key, std::uint32_t half = 0) {
        return square_of(*GetParam().probes, rule, count, key, half);
    }
};

TEST_P(PointSets, EveryWidthGivesTheSameBits) {
    Random random(201);
    for (const Estimator rule : kKeyed) {
        for (const int count : {1, 3, 16, 100, 1000, 65537}) {
            const auto key = static_cast<std::uint32_t>(random.bits());
            const std::uint32_t half = random.below(2) == 0 ? 0 : kHalf;
            SCOPED_TRACE(testing::Message() << name_of(rule) << ", " << count << " points, key " << key);
            const Square here = set(rule, count, key, half), there = square_of(scalar(), rule, count, key, half);
            expect_same_bits(here.u, there.u, "u");
            expect_same_bits(here.turn, there.turn, "turn");
        }
    }
}

TEST_P(PointSets, EveryShareLiesStrictlyInsideZeroToOne) {
    Random random(202);
    for (const Estimator rule : kKeyed) {
        for (const int count : {1, 2, 37, 4096, 1 << 20}) {
            const auto key = static_cast<std::uint32_t>(random.bits());
            const Square points = set(rule, count, key, count % 2 == 0 ? kHalf : 0);
            for (int k = 0; k < count; ++k) {
                ASSERT_GE(points.x(k), 0x1p-24) << name_of(rule) << ", point " << k << " of " << count;
                ASSERT_LE(points.x(k), 1 - 0x1p-24) << name_of(rule) << ", point " << k << " of " << count;
                ASSERT_LE(std::abs(points.y(k) - 0.5), 0.5) << name_of(rule) << ", point " << k << " of " << count;
            }
        }
    }
}

// Of 2^m points one lies in each of the 2^m intervals 2^-a wide and 2^(a-m) high, for every a: a (0,2)-net.
TEST_P(PointSets, SobolPutsOnePointIntoEveryElementaryInterval) {
    Random random(203);
    for (int m = 0; m <= 12; ++m) {
        for (const std::uint32_t half : {0u, kHalf}) {
            const auto key = static_cast<std::uint32_t>(random.bits());
            const int count = 1 << m;
            const Square points = set(Estimator::sobol, count, key, half);
            for (int a = 0; a <= m; ++a) {
                std::set<int> taken;
                for (int k = 0; k < count; ++k) {
                    const int column = static_cast<int>(std::ldexp(points.x(k), a));
                    const int row = static_cast<int>(std::ldexp(points.y(k), m - a));
                    ASSERT_TRUE(taken.insert((column << (m - a)) + row).second)
                        << "point " << k << " of " << count << ", intervals 2^-" << a << " wide, key " << key;
                }
            }
        }
    }
}

// The cells by another way: ring after ring, as many in each as its share of N says.
TEST_P(PointSets, JitterPutsOnePointIntoEveryCell) {
    constexpr double kRoom = 0x1p-22;  // u and turn have 24 bits
    Random random(204);
    for (const int count : {1, 2, 3, 5, 7, 12, 16, 17, 100, 1021, 4096}) {
        for (const std::uint32_t half : {0u, kHalf}) {
            const auto key = static_cast<std::uint32_t>(random.bits());
            const Square points = set(Estimator::jittered, count, key, half);
            const int rings = static_cast<int>(std::ceil(std::sqrt(double(count))));
            int k = 0;
            for (int ring = 0; ring < rings; ++ring) {
                const int start = k, cells = count / rings + (ring < count % rings ? 1 : 0);
                for (; k < start + cells; ++k) {
                    SCOPED_TRACE(testing::Message() << "point " << k << " of " << count << ", key " << key);
                    ASSERT_GE(points.x(k), double(start) / count - kRoom);
                    ASSERT_LE(points.x(k), double(start + cells) / count + kRoom);
                    ASSERT_GE(points.y(k), double(k - start) / cells - kRoom);
                    ASSERT_LE(points.y(k), double(k - start + 1) / cells + kRoom);
                }
            }
            ASSERT_EQ(k, count);
        }
    }
}

TEST_P(PointSets, R2StepsByThePlasticNumber) {
    constexpr double p = 1.3247179572447460260;
    ASSERT_NEAR(p * p * p, p + 1, 1e-15);
    constexpr double kRoom = 1e-6;  // 23 bits, and 2^-32 a step
    const auto off = [](double a) { return std::abs(a - std::round(a)); };
    const Square points = set(Estimator::r2, 1000, 77);
    for (int k = 0; k < 1000; ++k) {
        ASSERT_LE(off(points.x(k) - points.x(0) - k / p), kRoom) << "point " << k;
        ASSERT_LE(off(points.y(k) - points.y(0) - k / (p * p)), kRoom) << "point " << k;
    }
}

// Over many keys each single point of each rule is uniform in the square, where jitter has it in its cell: the mean of
// any integrand over the keys is its integral.
TEST_P(PointSets, EveryPointIsUniformOverTheKeys) {
    constexpr int kKeys = 4096, kSide = 8, kPoints = 5;
    constexpr double kMean = double(kKeys) / (kSide * kSide);
    for (const Estimator rule : kKeyed) {
        if (rule == Estimator::jittered) continue;  // its points are uniform in their cells: the law below
        for (const std::uint32_t half : {0u, kHalf}) {
            std::array<std::array<int, kSide * kSide>, kPoints> boxes{};
            for (std::uint32_t key = 1; key <= kKeys; ++key) {
                const Square points = set(rule, kPoints, hash_bits(key), half);
                for (int k = 0; k < kPoints; ++k) {
                    const auto column = static_cast<std::size_t>(points.x(k) * kSide);
                    const auto row = static_cast<std::size_t>(points.y(k) * kSide);
                    ++boxes[static_cast<std::size_t>(k)][column * kSide + row];
                }
            }
            for (int k = 0; k < kPoints; ++k) {
                // Pearson's statistic of 63 degrees of freedom: mean 63, deviation 11.2.
                double chi2 = 0;
                for (const int n : boxes[static_cast<std::size_t>(k)]) chi2 += (n - kMean) * (n - kMean) / kMean;
                EXPECT_LE(chi2, 63 + 5 * 11.3) << name_of(rule) << ", point " << k;
            }
        }
    }
}

TEST_P(PointSets, JitterIsUniformInItsCellOverTheKeys) {
    constexpr int kKeys = 4096, kCount = 7;
    // Rings of 3, 2, 2 cells; a mean of uniform numbers is off by its deviation / sqrt(12 keys).
    constexpr double kRoom = 4.5 / 3.46 / 64;
    constexpr double kStart[kCount] = {0, 0, 0, 3, 3, 5, 5}, kCells[kCount] = {3, 3, 3, 2, 2, 2, 2};
    constexpr double kColumn[kCount] = {0, 1, 2, 0, 1, 0, 1};
    double u[kCount] = {}, turn[kCount] = {};
    for (std::uint32_t key = 1; key <= kKeys; ++key) {
        const Square points = set(Estimator::jittered, kCount, hash_bits(key));
        for (int k = 0; k < kCount; ++k) u[k] += points.x(k) / kKeys, turn[k] += points.y(k) / kKeys;
    }
    for (int k = 0; k < kCount; ++k) {
        EXPECT_NEAR((u[k] * kCount - kStart[k]) / kCells[k], 0.5, kRoom) << "point " << k;
        EXPECT_NEAR(turn[k] * kCells[k] - kColumn[k], 0.5, kRoom) << "point " << k;
    }
}

TEST_P(PointSets, OddClassesMoveByHalf) {
    for (const Estimator rule : {Estimator::random, Estimator::sobol, Estimator::r2}) {
        const Square even = set(rule, 64, 5), odd = set(rule, 64, 5, kHalf);
        for (int k = 0; k < 64; ++k) {
            EXPECT_EQ(std::abs(even.x(k) - odd.x(k)), 0.5) << name_of(rule) << ", point " << k;
            EXPECT_EQ(even.y(k), odd.y(k)) << name_of(rule) << ", point " << k;
        }
    }
    // Jittered: half of a ring of 8 of 64.
    const Square even = set(Estimator::jittered, 64, 5), odd = set(Estimator::jittered, 64, 5, kHalf);
    for (int k = 0; k < 64; ++k) EXPECT_NEAR(std::abs(even.x(k) - odd.x(k)), 1.0 / 16, 1e-6) << "point " << k;
}

ZERKALO_OVER_ALL_WIDTHS(PointSets);

// The published first points: 0, 1/2, 3/4, 1/4, ... and direction numbers 1, 3, 5, 15, ... (Sobol 1967).
TEST(SobolSequence, SecondDimensionIsThatOfThePublishedDirectionNumbers) {
    std::array<std::uint32_t, 32> direction{};
    direction[0] = 1u << 31;
    for (std::size_t k = 1; k < direction.size(); ++k) direction[k] = direction[k - 1] ^ (direction[k - 1] >> 1);
    Random random(205);
    for (int round = 0; round < 10000; ++round) {
        const auto index = round < 16 ? static_cast<std::uint32_t>(round) : static_cast<std::uint32_t>(random.bits());
        std::uint32_t x = 0;
        for (std::size_t k = 0; k < direction.size(); ++k) x ^= index >> k & 1 ? direction[k] : 0;
        ASSERT_EQ(reversed_bits(reversed_second_dimension(index)), x) << "index " << index;
    }
    EXPECT_EQ(reversed_bits(reversed_second_dimension(1u)), 0x80000000u);
    EXPECT_EQ(reversed_bits(reversed_second_dimension(2u)), 0xc0000000u);
    EXPECT_EQ(reversed_bits(reversed_second_dimension(3u)), 0x40000000u);
}

// Owen's scrambling: what happens to a digit depends on the digits before it alone, and on a coin for each such prefix.
TEST(OwenScrambling, FlipsADigitByThoseBeforeIt) {
    Random random(206);
    int flips = 0, draws = 0;
    for (int round = 0; round < 20000; ++round) {
        const auto x = static_cast<std::uint32_t>(random.bits()), key = hash_bits(static_cast<std::uint32_t>(round));
        const int digit = random.below(32);
        // Two numbers that agree up to this digit agree up to it when scrambled, and differ in it if they did.
        const std::uint32_t later = digit == 31 ? 0 : static_cast<std::uint32_t>(random.bits()) >> (digit + 1);
        const std::uint32_t y = x ^ (0x80000000u >> digit) ^ later;
        const std::uint32_t a = scrambled(reversed_bits(x), key), b = scrambled(reversed_bits(y), key);
        ASSERT_EQ((a ^ b) >> (31 - digit), 1u) << x << " and " << y << ", digit " << digit << ", key " << key;
        flips += static_cast<int>((a ^ x) >> (31 - digit) & 1);
        ++draws;
    }
    EXPECT_NEAR(double(flips) / draws, 0.5, 4 * 0.5 / std::sqrt(double(draws)));
}

TEST(SetChoice, TilesCameraSamplesAndRotationsHaveOtherKeys) {
    std::set<std::uint32_t> keys;
    for (int rotation = 0; rotation < 32; ++rotation) {
        const Sampling sampling = sampling_of(Estimator::sobol, static_cast<std::uint32_t>(rotation));
        for (std::uint32_t tile = 0; tile < 64; ++tile) {
            for (std::uint32_t sample = 0; sample < 8; ++sample) {
                const auto set = set_of_class(sampling, hash_bits(tile), 0, sample);
                EXPECT_TRUE(keys.insert(set.key).second) << rotation << ", tile " << tile << ", sample " << sample;
                for (int c = 1; c < kLatticeClasses; ++c) {
                    const auto other = set_of_class(sampling, hash_bits(tile), c, sample);
                    EXPECT_EQ(other.key, set.key);
                    EXPECT_EQ(other.half, c % 2 == 1 ? kHalf : 0u);
                }
            }
        }
    }
}

}  // namespace
}  // namespace zerkalo::test
