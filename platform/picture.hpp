// Pictures read from files, in memory of their own. (Pictures on their way to a file or a display are views.)
#pragma once

#include "core/image/image_view.hpp"

#include <cstdint>
#include <vector>

namespace zerkalo {

/// A side of a file's picture is at most kMaxFileSide, the whole at most kMaxFilePixels: larger files are refused.
constexpr std::int64_t kMaxFileSide = 65536;
constexpr std::int64_t kMaxFilePixels = std::int64_t{1} << 28;

/// RGB codes as a file stores them, row 0 on top, without padding: 0..255 or 0..65535 by `depth` (8 or 16).
struct CodePicture {
    std::int32_t width = 0, height = 0;
    int depth = 8;
    std::vector<std::uint16_t> rgb;
};

/// Linear RGB, row 0 on top, without padding.
struct LinearPicture {
    std::int32_t width = 0, height = 0;
    std::vector<float> rgb;

    LinearImage view() {
        return {rgb.data(), width, height, std::ptrdiff_t{3} * width * static_cast<std::ptrdiff_t>(sizeof(float))};
    }
};

/// Undoes the sRGB curve (IEC 61966-2-1). Resolved again at the same depth, every code comes back. May throw
/// std::bad_alloc.
LinearPicture linear_from_codes(const CodePicture& picture);

}  // namespace zerkalo
