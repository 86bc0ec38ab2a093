// How far two pictures are apart: in linear light and in steps of 8-bit sRGB.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace zerkalo {

/// A picture that was read from a file, in both forms; three values a pixel, row-major, row 0 on top.
struct Picture {
    std::int32_t width = 0, height = 0;
    std::vector<float> linear;
    std::vector<std::uint8_t> codes;  // 8-bit sRGB
    bool clipped = false;             // the file could hold 0..1 only
};

/// Errors over all three channels of the pixels that counted.
struct PictureDifference {
    double rmse_linear = 0;
    double max_linear = 0;
    double rmse_srgb8 = 0;  // steps of 8-bit sRGB
    int max_srgb8 = 0;
    double psnr = 0;  // dB, of the 8-bit codes; infinity for equal codes
    std::int64_t pixels = 0, differing_pixels = 0, pixels_off_by_more_than_1 = 0;
};

/// How far the worst channel of a pixel (row-major index) is off, in steps of 8-bit sRGB. A NaN equals a NaN; against a
/// number it is off by 255.
int steps_apart(const Picture& a, const Picture& b, std::size_t pixel);

/// Compares two pictures of one size. Where one of them is clipped, the other's linear values are clipped to 0..1 too.
/// NaN against a number makes the linear errors NaN.
/// `mask` holds one flag a pixel, or nothing: then every pixel counts.
PictureDifference difference_of(const Picture& a, const Picture& b, const std::vector<bool>& mask);

}  // namespace zerkalo
