// The statistics of a study, each by its closed form.
#pragma once

#include <vector>

namespace zerkalo::study {

/// A value with an interval of 95 %.
struct Estimate {
    double value = 0, low = 0, high = 0;
};

struct MeanAndSpread {
    double mean = 0, deviation = 0;
};

/// Mean and sample standard deviation (n - 1; 0 for one value). Precondition: at least one value.
MeanAndSpread mean_and_spread(const std::vector<double>& values);

/// The smallest value that at least the share `share` of all values does not exceed (nearest rank).
/// Precondition: at least one value, 0 < share <= 1.
double percentile(std::vector<double> values, double share);

/// The chance that at most k of n fair coins show heads, 0 <= k <= n.
double binomial_half_tail(int n, int k);

/// The rank (from 1) of the value that bounds a 95 % interval of the median from below; n + 1 - rank bounds it from
/// above. 1 where n < 6 values cannot give 95 %. Source: order statistics, as in Hoefler and Belli, "Scientific
/// Benchmarking of Parallel Computing Systems", SC 2015, rule 5.
int median_interval_rank(int n);

/// The median with that interval. Precondition: at least one value.
Estimate median_with_interval(std::vector<double> values);

/// The 0.975 quantile of Student's t distribution with `degrees` >= 1 degrees of freedom, to 2e-4.
double student_quantile(int degrees);

/// Least squares slope of log y over log x with its 95 % interval (normal residuals). All NaN with fewer than three
/// points. Precondition: every x and y is above 0, not all x equal.
Estimate log_log_slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace zerkalo::study
