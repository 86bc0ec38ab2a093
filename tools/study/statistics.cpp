#include "tools/study/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zerkalo::study {

MeanAndSpread mean_and_spread(const std::vector<double>& values) {
    const double n = static_cast<double>(values.size());
    double sum = 0, squares = 0;
    for (const double value : values) sum += value;
    const double mean = sum / n;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return {mean, values.size() > 1 ? std::sqrt(squares / (n - 1)) : 0};
}

double percentile(std::vector<double> values, double share) {
    // Half a unit of slack: 0.999 times 1000 is a little more than 999 in binary.
    const double rank = std::ceil(share * static_cast<double>(values.size()) - 1e-9);
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

double binomial_half_tail(int n, int k) {
    double term = std::exp2(-n), sum = 0;
    for (int i = 0; i <= k; ++i) {
        sum += term;
        term *= static_cast<double>(n - i) / (i + 1);
    }
    return sum;
}

int median_interval_rank(int n) {
    int rank = 1;
    while (rank < (n + 1) / 2 && binomial_half_tail(n, rank) <= 0.025) ++rank;
    return rank;
}

Estimate median_with_interval(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size(), middle = n / 2;
    const auto rank = static_cast<std::size_t>(median_interval_rank(static_cast<int>(n)));
    const double median = n % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
    return {median, values[rank - 1], values[n - rank]};
}

double student_quantile(int degrees) {
    constexpr double kTable[] = {12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646, 2.3060, 2.2622, 2.2281};
    constexpr int kRows = static_cast<int>(std::size(kTable));
    if (degrees <= kRows) return kTable[degrees - 1];
    // Cornish and Fisher's expansion about the normal quantile (Abramowitz and Stegun 26.7.5).
    constexpr double z = 1.959964;
    const double v = degrees, z3 = z * z * z, z5 = z3 * z * z;
    return z + (z3 + z) / (4 * v) + (5 * z5 + 16 * z3 + 3 * z) / (96 * v * v) +
           (3 * z5 * z * z + 19 * z5 + 17 * z3 - 15 * z) / (384 * v * v * v);
}

Estimate log_log_slope(const std::vector<double>& x, const std::vector<double>& y) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const std::size_t n = x.size();
    if (n < 3) return {kNone, kNone, kNone};
    double mean_x = 0, mean_y = 0;
    for (std::size_t i = 0; i < n; ++i) {
        mean_x += std::log(x[i]) / static_cast<double>(n);
        mean_y += std::log(y[i]) / static_cast<double>(n);
    }
    double xx = 0, xy = 0, residual = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double dx = std::log(x[i]) - mean_x;
        xx += dx * dx;
        xy += dx * (std::log(y[i]) - mean_y);
    }
    const double slope = xy / xx;
    for (std::size_t i = 0; i < n; ++i) {
        const double off = std::log(y[i]) - mean_y - slope * (std::log(x[i]) - mean_x);
        residual += off * off;
    }
    const int degrees = static_cast<int>(n) - 2;
    const double half = student_quantile(degrees) * std::sqrt(residual / degrees / xx);
    return {slope, slope - half, slope + half};
}

}  // namespace zerkalo::study
