// The lobe's profile for coverage.hpp, of any exponent: a polynomial that stands for the power cos^(n+1), fitted once a
// mirror in double.
#pragma once

#include "core/numeric/setup.hpp"
#include "core/optics/optics_data.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// (1 - (1 - v)^(half)) / v, half = (n + 1) / 2, v = sin^2 of the angle to the lobe's axis, 0 < v < 1.
inline double winding_density(double v, double half) {
    // log(1 - v) keeps its digits for tiny v by two terms of its series.
    constexpr double kSeries = 0x1p-17;
    const double e = half * (v > kSeries ? natural_log(1 - v) : -v * (1 + v / 2));
    const double lost = e > -kSeries ? -e * (1 + e / 2) : 1 - exponential(e);
    return lost / v;
}

/// Chebyshev's interpolation in kProfileTerms nodes, as powers of y = 2 v / edge - 1 in [-1, 1].
inline void fit_profile(double edge, double half, double* powers) {
    constexpr int kTerms = kProfileTerms;
    double series[kTerms] = {};
    for (int k = 0; k < kTerms; ++k) {
        const double angle = kPi * (k + 0.5) / kTerms;
        const double value = winding_density(edge * (1 + sine_cosine(angle).cosine) / 2, half);
        for (int j = 0; j < kTerms; ++j) series[j] += value * sine_cosine(j * angle).cosine * (j == 0 ? 1 : 2) / kTerms;
    }
    // T_0 = 1, T_1 = y, T_(j+1) = 2 y T_j - T_(j-1).
    double older[kTerms] = {1}, newer[kTerms] = {0, 1};
    for (int j = 0; j < kTerms; ++j) powers[j] = 0;
    for (int j = 0; j < kTerms; ++j) {
        for (int i = 0; i <= j; ++i) powers[i] += series[j] * older[i];
        double next[kTerms] = {};
        for (int i = 0; i < kTerms; ++i) next[i] = (i > 0 ? 2 * newer[i - 1] : 0) - older[i];
        for (int i = 0; i < kTerms; ++i) older[i] = newer[i], newer[i] = next[i];
    }
}

/// The profile of cos^n, n >= 0: beyond `edge` lies the share 2^-12 of the lobe, which counts as nothing.
inline LobeProfile profile_of(double exponent) {
    const double half = (exponent + 1) / 2;
    const double e = -12 * natural_log(2) / half;
    constexpr double kSeries = 0x1p-17;
    const double edge = e > -kSeries ? -e * (1 + e / 2) : 1 - exponential(e);
    const double forward = exponential(e / 2);
    double powers[kProfileTerms];
    fit_profile(edge, half, powers);
    LobeProfile profile;
    for (int k = 0; k < kProfileTerms; ++k) profile.powers[k] = float(powers[k]);
    profile.edge = float(edge), profile.to_unit = float(2 / edge);
    profile.tangent2 = float(edge / (1 - edge));
    profile.from_axis = float(edge / (1 + forward));
    return profile;
}

}  // namespace zerkalo::inline ZERKALO_ISA
