// sRGB codes -> linear values: the inverse of core/image/resolve.hpp.
#include "platform/picture.hpp"

#include <cmath>

namespace zerkalo {
namespace {

double linear_from_srgb(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

LinearPicture linear_from_codes(const CodePicture& picture) {
    const std::size_t levels = picture.depth == 16 ? 65536 : 256;
    std::vector<float> table(levels);
    for (std::size_t code = 0; code < levels; ++code)
        table[code] = static_cast<float>(linear_from_srgb(static_cast<double>(code) / static_cast<double>(levels - 1)));

    LinearPicture linear{picture.width, picture.height, {}};
    linear.rgb.reserve(picture.rgb.size());
    for (const std::uint16_t code : picture.rgb) linear.rgb.push_back(table[code]);
    return linear;
}

}  // namespace zerkalo
