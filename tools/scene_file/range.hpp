// The ranges of the numbers in a scene file, and how they are said.
#pragma once

#include "core/scene/scene.hpp"

namespace zerkalo::scene_file {

/// An interval of numbers; never contains NaN.
struct Range {
    double low, high;
    bool low_belongs, high_belongs;
    const char* words;  // "must be ..."

    constexpr bool contains(double x) const {
        return (low_belongs ? x >= low : x > low) && (high_belongs ? x <= high : x < high);
    }
};

constexpr Range kFinite{-kInfinity, kInfinity, false, false, "a finite number"};
constexpr Range kCoordinate{-kMaxCoordinate, kMaxCoordinate, true, true, "a number from -1e15 to 1e15"};
constexpr Range kPositive{0, kInfinity, false, false, "a finite number above 0"};
constexpr Range kSize{0, kMaxCoordinate, false, true, "a number above 0, at most 1e15"};
constexpr Range kTaper{0, kMaxCoordinate, true, true, "a number, 0 or above, at most 1e15"};
constexpr Range kNotNegative{0, kInfinity, true, false, "a finite number, 0 or above"};
constexpr Range kUnit{0, 1, true, true, "a number from 0 to 1"};
constexpr Range kAngle{-kMaxAngleDegrees, kMaxAngleDegrees, true, true, "a number of degrees from -1e7 to 1e7"};
constexpr Range kOpening{0, 180, false, false, "an angle above 0 and below 180 degrees"};
constexpr Range kLobeExponent{0, kInfinity, true, true, "a number, 0 or above, or inf for a sharp mirror"};
constexpr Range kCurvature{-kInfinity, kInfinity, true, true, "a number other than 0, or inf for a flat mirror"};

}  // namespace zerkalo::scene_file
