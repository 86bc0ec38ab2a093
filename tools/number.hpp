// The number systems that a host program can choose.
#pragma once

namespace zerkalo {

/// What the kernels count with: float lanes, or fixed point.
enum class Number { floating, fixed };

}  // namespace zerkalo
