// Whole linear pictures for tests: how far apart two of them are, and PNG files to look at when they are too far apart.
#pragma once

#include "core/geometry/vec.hpp"
#include "core/image/image_view.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace zerkalo::reference {

/// Linear RGB, row-major, row 0 on top.
struct Picture {
    int width = 0, height = 0;
    std::vector<Rgb<double>> pixels;

    const Rgb<double>& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

Picture picture_of(const LinearImage& image);

/// 0..255: clipped to [0,1], piecewise sRGB curve (IEC 61966-2-1), rounded half up. NaN gives 0.
std::uint8_t srgb_code(double linear);

struct PictureDifference {
    double rmse = 0;                      // linear, over all channels; NaN if a picture holds one
    double max = 0;                       // linear; infinite if a picture holds a NaN
    std::int64_t pixels_off_by_more = 0;  // some 8-bit sRGB code differs by more than `steps`, or is NaN in one
    std::int64_t pixels = 0;
};

/// Throws std::invalid_argument when the sizes differ.
PictureDifference compare(const Picture& actual, const Picture& expected, int steps);

/// 8-bit sRGB PNG without compression. Throws std::runtime_error when it cannot be written.
void write_png(const std::string& path, const Picture& picture);

/// Writes `<stem>-actual.png`, `<stem>-expected.png` and `<stem>-difference.png` (codes apart, times 8); returns a
/// sentence that names them, for a test's failure message.
std::string save_failure(const std::string& stem, const Picture& actual, const Picture& expected);

}  // namespace zerkalo::reference
