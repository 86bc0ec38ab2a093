#include "tools/study/error_figures.hpp"

#include "core/image/resolve.hpp"
#include "platform/picture.hpp"
#include "tools/study/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zerkalo::study {
namespace {

constexpr double kTopCode16 = 65535;

std::vector<std::uint16_t> codes16_of(const LightPicture& picture) {
    const std::vector<float> linear(picture.rgb.begin(), picture.rgb.end());
    std::vector<std::uint16_t> codes(linear.size());
    resolve16(linear.data(), codes.data(), codes.size());
    return codes;
}

std::vector<std::uint16_t> codes8_of(const LightPicture& picture) {
    const std::vector<float> linear(picture.rgb.begin(), picture.rgb.end());
    std::vector<std::uint8_t> codes(linear.size());
    resolve8(linear.data(), codes.data(), codes.size());
    return {codes.begin(), codes.end()};
}

// The nearest of 2^bits codes, as a 16-bit code again.
std::uint16_t rounded_code(std::uint16_t code, int bits) {
    const double top = std::exp2(bits) - 1;
    return static_cast<std::uint16_t>(std::lround(std::round(code / kTopCode16 * top) / top * kTopCode16));
}

double psnr_of(const LightPicture& a, const LightPicture& b, const Mask& mask) {
    const auto codes_a = codes16_of(a), codes_b = codes16_of(b);
    double squares = 0;
    std::int64_t values = 0;
    for (std::size_t i = 0; i < codes_a.size(); ++i) {
        if (!mask[i / 3]) continue;
        const double off = codes_a[i] - codes_b[i];
        squares += off * off;
        ++values;
    }
    if (squares == 0) return std::numeric_limits<double>::infinity();
    return 20 * std::log10(kTopCode16 / std::sqrt(squares / static_cast<double>(values)));
}

}  // namespace

ErrorFigures error_figures(const LightPicture& a, const LightPicture& b, const Mask& mask) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        if (mask[i / 3]) errors.push_back(std::abs(a.rgb[i] - b.rgb[i]));
    }
    ErrorFigures figures;
    figures.psnr = psnr_of(a, b, mask);
    if (errors.empty()) return figures;
    figures.rmse = rmse_of(a, b, mask);
    figures.max = *std::max_element(errors.begin(), errors.end());
    figures.p999 = percentile(std::move(errors), 0.999);
    return figures;
}

double rmse_of(const LightPicture& a, const LightPicture& b, const Mask& mask) {
    double squares = 0;
    std::int64_t values = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        if (!mask[i / 3]) continue;
        const double off = a.rgb[i] - b.rgb[i];
        squares += off * off;
        ++values;
    }
    return values == 0 ? 0 : std::sqrt(squares / static_cast<double>(values));
}

LightPicture quantised(const LightPicture& picture, int bits) {
    CodePicture codes{picture.width, picture.height, bits == 8 ? 8 : 16, {}};
    codes.rgb = bits == 8 ? codes8_of(picture) : codes16_of(picture);
    if (bits == 10) {
        for (std::uint16_t& code : codes.rgb) code = rounded_code(code, bits);
    }
    const LinearPicture linear = linear_from_codes(codes);
    return {picture.width, picture.height, {linear.rgb.begin(), linear.rgb.end()}};
}

LightPicture clipped(LightPicture picture) {
    for (double& value : picture.rgb) value = std::clamp(value, 0.0, 1.0);
    return picture;
}

}  // namespace zerkalo::study
