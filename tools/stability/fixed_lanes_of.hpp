// Fixed-point formulas in as many lanes as a stage's instruction set has pixels, for rows that speak of formats.
#pragma once

#include "core/numeric/fixed.hpp"
#include "tools/stability/stage.hpp"

#include <array>
#include <cmath>
#include <type_traits>

namespace zerkalo::stability {

constexpr int kMostFixedLanes = 8;  // lanes of integers exist in any number; nothing is wider than this

/// Calls f with the number of lanes as a constant: 1, 4 or 8.
template <class F>
auto with_lanes(const Stage& stage, const F& f) {
    switch (lanes_of(stage.isa())) {
        case 1: return f(std::integral_constant<int, 1>{});
        case 4: return f(std::integral_constant<int, 4>{});
        default: return f(std::integral_constant<int, kMostFixedLanes>{});
    }
}

/// The nearest number of a format with one lane.
template <class F>
F nearest(double x) {
    return F::from_raw(static_cast<typename F::Element>(std::llround(std::ldexp(x, F::kFraction))));
}

/// A lane's value.
template <class Rep, int FracBits>
double real(const Fixed<Rep, FracBits>& x, int lane = 0) {
    return std::ldexp(static_cast<double>(lane_of(x.raw, lane)), -FracBits);
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
