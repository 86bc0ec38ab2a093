// Pictures of arbitrary content with a fixed seed.
#pragma once

#include "platform/picture.hpp"
#include "platform/pixel.hpp"

#include <random>
#include <vector>

namespace zerkalo {

/// sRGB codes that own their memory.
struct RandomCodes {
    std::int32_t width, height;
    std::vector<std::uint8_t> rgb;

    RandomCodes(std::int32_t w, std::int32_t h, unsigned seed)
        : width(w), height(h), rgb(static_cast<std::size_t>(3 * w * h)) {
        std::mt19937 random(seed);
        for (std::uint8_t& code : rgb) code = static_cast<std::uint8_t>(random());
    }

    /// The rectangle of it, as a part.
    SrgbPart part(const Rect& rect) const {
        return {rgb.data() + 3 * (rect.top * width + rect.left), rect.width, rect.height, 3 * width};
    }
    SrgbPart all() const { return part({0, 0, width, height}); }
};

/// Linear values from somewhat below 0 to somewhat above 1.
inline LinearPicture random_linear(std::int32_t width, std::int32_t height, unsigned seed) {
    LinearPicture picture{width, height, std::vector<float>(static_cast<std::size_t>(3 * width * height))};
    std::mt19937 random(seed);
    for (float& value : picture.rgb) value = static_cast<float>(random() % 12000) / 10000.0f - 0.1f;
    return picture;
}

}  // namespace zerkalo
