// The number systems that a host program can choose.
#pragma once

namespace zerkalo {

/// What the kernels count with: float lanes, fixed point, or double; and the names on the command line.
enum class Number { floating, fixed, double_precision };
constexpr const char* kNumberNames[] = {"float", "fixed", "double"};
constexpr const char* name_of(Number number) { return kNumberNames[static_cast<int>(number)]; }

}  // namespace zerkalo
