// The values that are put into numbers of a scene.
#pragma once

#include "tests/bad_input/fields.hpp"

#include <limits>

namespace zerkalo::bad_input {

constexpr double kBadReals[] = {std::numeric_limits<double>::quiet_NaN(),
                                kInfinity,
                                -kInfinity,
                                std::numeric_limits<double>::denorm_min(),
                                std::numeric_limits<double>::max(),
                                1e-40,  // below the normal floats
                                0.0,
                                -0.0,
                                -1.0,
                                1e30,
                                1e-30,
                                kMaxCoordinate};
constexpr std::int32_t kBadWholes[] = {
    std::numeric_limits<std::int32_t>::min(), -1, 0, 1, kMaxSides + 1, kMaxTriangles, 65537,
    std::numeric_limits<std::int32_t>::max()};

/// How many values there are for a field. Choices get two that mean nothing: one past the last, and 255; a truth gets both.
int value_count(const Field& field);

/// Puts the value of this number into the field.
void spoil(Scene& scene, const Field& field, int value);

/// "solid 0 radius (byte 392) = 1e+30"
std::string text_of(const Field& field, int value);

}  // namespace zerkalo::bad_input
