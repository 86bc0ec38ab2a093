// Scaling a linear picture down: every target pixel is the mean of the rectangle of the source that it covers.
#pragma once

#include "platform/pixel.hpp"

namespace zerkalo {

/// The largest extent within `bounds` with the picture's proportions, rounded to the nearest pixel, at least 1x1; never
/// larger than the picture. Precondition: all sides at least 1.
Extent fit(const Extent& picture, const Extent& bounds);

/// Box filter in linear light; pixels that a border cuts count by their covered area. Precondition: 1 <= target side <=
/// source side. An equal size copies exactly.
void shrink(const LinearImage& source, const LinearImage& target);

}  // namespace zerkalo
