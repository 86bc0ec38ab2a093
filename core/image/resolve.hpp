// Linear radiance -> stored value: clip to [0,1], the exact piecewise sRGB curve (IEC 61966-2-1), round half up.
#pragma once

#include "core/image/image_view.hpp"

namespace zerkalo {

/// `count` linear values -> 8-bit sRGB codes. NaN gives 0.
void resolve8(const float* linear, std::uint8_t* codes, std::size_t count);

/// `count` linear values -> 16-bit sRGB codes (0..65535, host byte order). NaN gives 0.
void resolve16(const float* linear, std::uint16_t* codes, std::size_t count);

}  // namespace zerkalo
