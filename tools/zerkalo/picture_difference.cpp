#include "tools/zerkalo/picture_difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace zerkalo {
namespace {

constexpr int kTopCode = 255;

double linear_error(float a, float b, bool clip) {
    if (std::isnan(a) && std::isnan(b)) return 0;
    if (a == b) return 0;  // also two equal infinities
    if (clip) {
        a = std::isnan(a) ? a : std::clamp(a, 0.0f, 1.0f);
        b = std::isnan(b) ? b : std::clamp(b, 0.0f, 1.0f);
    }
    return std::abs(static_cast<double>(a) - static_cast<double>(b));
}

int code_error(const Picture& a, const Picture& b, std::size_t i) {
    if (std::isnan(a.linear[i]) != std::isnan(b.linear[i])) return kTopCode;
    return std::abs(a.codes[i] - b.codes[i]);
}

}  // namespace

int steps_apart(const Picture& a, const Picture& b, std::size_t pixel) {
    return std::max({code_error(a, b, 3 * pixel), code_error(a, b, 3 * pixel + 1), code_error(a, b, 3 * pixel + 2)});
}

PictureDifference difference_of(const Picture& a, const Picture& b, const std::vector<bool>& mask) {
    const std::size_t pixels = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
    const bool clip = a.clipped || b.clipped;
    PictureDifference result;
    double linear_squares = 0, code_squares = 0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        if (!mask.empty() && !mask[pixel]) continue;
        const int worst = steps_apart(a, b, pixel);
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
            const double linear = linear_error(a.linear[i], b.linear[i], clip);
            const int code = code_error(a, b, i);
            linear_squares += linear * linear;
            code_squares += static_cast<double>(code) * code;
            // A NaN sticks: nothing is larger than it.
            if (std::isnan(linear) || linear > result.max_linear) result.max_linear = linear;
        }
        result.max_srgb8 = std::max(result.max_srgb8, worst);
        ++result.pixels;
        result.differing_pixels += worst > 0;
        result.pixels_off_by_more_than_1 += worst > 1;
    }
    const double values = 3.0 * static_cast<double>(std::max<std::int64_t>(result.pixels, 1));
    result.rmse_linear = std::sqrt(linear_squares / values);
    result.rmse_srgb8 = std::sqrt(code_squares / values);
    result.psnr =
        code_squares == 0 ? std::numeric_limits<double>::infinity() : 20 * std::log10(kTopCode / result.rmse_srgb8);
    return result;
}

}  // namespace zerkalo
