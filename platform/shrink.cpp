// Box filter with exact area weights: in units of 1/target of a source pixel all borders are integers.
#include "platform/shrink.hpp"

#include <algorithm>

namespace zerkalo {
namespace {

// How much of source pixel i lies in target pixel t; the weights of one target pixel sum to `source`.
std::int64_t overlap(std::int64_t i, std::int64_t t, std::int64_t source, std::int64_t target) {
    return std::min((i + 1) * target, (t + 1) * source) - std::max(i * target, t * source);
}

std::int32_t scaled_side(std::int64_t side, std::int64_t to, std::int64_t from) {
    return static_cast<std::int32_t>(std::max<std::int64_t>((2 * side * to + from) / (2 * from), 1));
}

}  // namespace

Extent fit(const Extent& picture, const Extent& bounds) {
    if (picture.width <= bounds.width && picture.height <= bounds.height) return picture;
    if (std::int64_t{picture.width} * bounds.height >= std::int64_t{bounds.width} * picture.height)
        return {bounds.width, scaled_side(picture.height, bounds.width, picture.width)};
    return {scaled_side(picture.width, bounds.height, picture.height), bounds.height};
}

void shrink(const LinearImage& source, const LinearImage& target) {
    const double area = static_cast<double>(source.width) * source.height;
    for (std::int64_t y = 0; y < target.height; ++y) {
        const std::int64_t top = y * source.height / target.height;
        const std::int64_t bottom = ((y + 1) * source.height + target.height - 1) / target.height;
        for (std::int64_t x = 0; x < target.width; ++x) {
            const std::int64_t left = x * source.width / target.width;
            const std::int64_t right = ((x + 1) * source.width + target.width - 1) / target.width;
            double sum[3] = {0, 0, 0};
            for (std::int64_t j = top; j < bottom; ++j) {
                const float* row = source.row(static_cast<std::int32_t>(j));
                const std::int64_t row_weight = overlap(j, y, source.height, target.height);
                for (std::int64_t i = left; i < right; ++i) {
                    const double weight = static_cast<double>(row_weight * overlap(i, x, source.width, target.width));
                    for (int c = 0; c < 3; ++c) sum[c] += weight * static_cast<double>(row[3 * i + c]);
                }
            }
            float* pixel = target.row(static_cast<std::int32_t>(y)) + 3 * x;
            for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(sum[c] / area);
        }
    }
}

}  // namespace zerkalo
