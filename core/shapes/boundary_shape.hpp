// The kinds of outline that a mirror can have.
#pragma once

#include <cstdint>

namespace zerkalo {

constexpr int kMaxCorners = 16;

enum class BoundaryShape : std::uint8_t { rectangle, disc, ellipse, polygon };

}  // namespace zerkalo
