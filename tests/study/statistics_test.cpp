// The statistics of a study against closed forms and exact data.
#include "tools/study/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace zerkalo::study {
namespace {

// The number of subsets of at most k of n things, by counting every one of the 2^n.
std::int64_t small_subsets(int n, int k) {
    std::int64_t count = 0;
    for (std::uint32_t subset = 0; subset < (1u << n); ++subset) count += __builtin_popcount(subset) <= k;
    return count;
}

TEST(StudyStatistics, TheTailOfTheBinomialIsACountOfSubsets) {
    for (int n = 1; n <= 16; ++n) {
        for (int k = 0; k <= n; ++k) {
            EXPECT_DOUBLE_EQ(binomial_half_tail(n, k), std::ldexp(static_cast<double>(small_subsets(n, k)), -n))
                << n << " " << k;
        }
    }
}

TEST(StudyStatistics, TheMediansIntervalHoldsItWith95PercentAndNoNarrowerOneDoes) {
    for (int n = 6; n <= 200; ++n) {
        const int rank = median_interval_rank(n);
        EXPECT_LE(2 * binomial_half_tail(n, rank - 1), 0.05) << n;
        EXPECT_TRUE(2 * (rank + 1) > n + 1 || 2 * binomial_half_tail(n, rank) > 0.05) << n;
    }
    // Tables of the sign test (Dixon and Mood 1946).
    EXPECT_EQ(median_interval_rank(30), 10);
    EXPECT_EQ(median_interval_rank(31), 10);
    EXPECT_EQ(median_interval_rank(6), 1);
    EXPECT_EQ(median_interval_rank(9), 2);
}

TEST(StudyStatistics, TheIntervalIsMadeOfTheOrderedValues) {
    std::vector<double> values;
    for (int i = 0; i < 31; ++i) values.push_back((i * 12) % 31);  // 0..30, out of order
    const Estimate median = median_with_interval(values);
    EXPECT_EQ(median.value, 15);
    EXPECT_EQ(median.low, 9);
    EXPECT_EQ(median.high, 21);
    EXPECT_EQ(median_with_interval({4, 1, 3, 2}).value, 2.5);
}

TEST(StudyStatistics, APercentileIsTheNearestRank) {
    std::vector<double> values;
    for (int i = 1000; i >= 1; --i) values.push_back(i);
    EXPECT_EQ(percentile(values, 0.999), 999);
    EXPECT_EQ(percentile(values, 1.0), 1000);
    EXPECT_EQ(percentile(values, 0.5), 500);
    EXPECT_EQ(percentile({7}, 0.999), 7);
    EXPECT_EQ(percentile({3, 1, 2}, 0.0001), 1);
}

TEST(StudyStatistics, MeanAndDeviationOfKnownValues) {
    const MeanAndSpread spread = mean_and_spread({2, 4, 4, 4, 5, 5, 7, 9});
    EXPECT_DOUBLE_EQ(spread.mean, 5);
    EXPECT_DOUBLE_EQ(spread.deviation, std::sqrt(32.0 / 7));
    EXPECT_EQ(mean_and_spread({3}).deviation, 0);
}

TEST(StudyStatistics, AnExactPowerHasItsSlopeAndNoInterval) {
    std::vector<double> x, y;
    for (double n = 1; n <= 256; n *= 2) {
        x.push_back(n);
        y.push_back(0.3 * std::pow(n, -0.75));
    }
    const Estimate slope = log_log_slope(x, y);
    EXPECT_NEAR(slope.value, -0.75, 1e-12);
    EXPECT_NEAR(slope.low, -0.75, 1e-6);
    EXPECT_NEAR(slope.high, -0.75, 1e-6);
    EXPECT_TRUE(std::isnan(log_log_slope({1, 2}, {1, 2}).value));
}

// By hand: log2 x = 0, 1, 2, 3 and log2 y = 0, -1, -1, -2: slope -0.6, residual 0.2, so the standard error is
// sqrt(0.2 / 2 / 5) and the interval 4.3027 of them either way.
TEST(StudyStatistics, TheSlopesIntervalIsStudents) {
    const Estimate slope = log_log_slope({1, 2, 4, 8}, {1, 0.5, 0.5, 0.25});
    EXPECT_NEAR(slope.value, -0.6, 1e-12);
    EXPECT_NEAR(slope.high - slope.value, 4.3027 * std::sqrt(0.2 / 2 / 5), 1e-9);
    EXPECT_NEAR(slope.value - slope.low, slope.high - slope.value, 1e-12);
}

TEST(StudyStatistics, StudentsQuantilesAreThoseOfTheTables) {
    EXPECT_NEAR(student_quantile(1), 12.706, 1e-3);
    EXPECT_NEAR(student_quantile(10), 2.2281, 1e-4);
    EXPECT_NEAR(student_quantile(11), 2.2010, 2e-4);
    EXPECT_NEAR(student_quantile(30), 2.0423, 2e-4);
    EXPECT_NEAR(student_quantile(1000), 1.9623, 1e-4);
}

}  // namespace
}  // namespace zerkalo::study
