// Fixed-point formulas in any number of lanes, for rows that speak of formats.
#pragma once

#include "core/numeric/fixed.hpp"
#include "tools/stability/stage.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace zerkalo::stability {

constexpr int kMostFixedLanes = 8;  // lanes of integers exist in any number; nothing is wider than this

/// The largest of what f gives for every number of lanes, a constant: 1, 4 and 8.
template <class F>
double worst_of_widths(const F& f) {
    return std::max({f(std::integral_constant<int, 1>{}), f(std::integral_constant<int, 4>{}),
                     f(std::integral_constant<int, kMostFixedLanes>{})});
}

/// The nearest number of a format with one lane.
template <class F>
F nearest(double x) {
    return F::from_raw(static_cast<typename F::Element>(std::llround(std::ldexp(x, F::kFraction))));
}

inline double real(float x) { return double{x}; }

/// A lane's value.
template <class Rep, Format F>
double real(const Fixed<Rep, F>& x, int lane = 0) {
    return std::ldexp(static_cast<double>(lane_of(x.raw, lane)), -F.fraction);
}

/// The first W of some raw integers as one number of the format F.
template <class F, class Raw>
F in_lanes(const Raw* from) {
    auto raw = in_all_lanes<decltype(F::raw)>(0);
    if constexpr (kLanesOf<decltype(F::raw)> == 1) {
        raw = from[0];
    } else {
        for (int k = 0; k < kLanesOf<decltype(F::raw)>; ++k) raw.v[k] = from[k];
    }
    return F::from_raw(raw);
}

}  // namespace zerkalo::stability
