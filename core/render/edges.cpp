#include "core/render/edges.hpp"

#include "core/numeric/float_mode.hpp"

namespace zerkalo {
namespace {

constexpr float kStep = 0x1p-4f;  // of the square root of light

/// |sqrt a - sqrt b| > kStep of values held in 0..1, without roots: of the larger one, a > b + 2 kStep sqrt b + kStep^2.
bool far_apart(float a, float b) {
    const float larger = a > b ? a : b, smaller = a > b ? b : a;
    const float high = larger < 1 ? larger : 1, low = smaller < 0 ? 0 : smaller;
    const float beyond = high - low - kStep * kStep;
    return beyond > 0 && beyond * beyond > 4 * kStep * kStep * low;
}

bool differ(const float* a, const float* b) {
    return far_apart(a[0], b[0]) || far_apart(a[1], b[1]) || far_apart(a[2], b[2]);
}

}  // namespace

std::uint64_t edge_pixels(const LinearImage& image, const Rect& tile) {
    const IeeeMode ieee;
    const std::int32_t right = tile.left + tile.width, bottom = tile.top + tile.height;
    std::uint64_t edges = 0;
    const auto mark = [&](std::int32_t x, std::int32_t y) {
        if (x < tile.left || x >= right || y < tile.top || y >= bottom) return;
        edges |= std::uint64_t{1} << ((y - tile.top) * kTileSide + (x - tile.left));
    };
    // Each pair of neighbours is asked once, from its left or upper pixel, which may lie outside of the tile.
    for (std::int32_t y = tile.top > 0 ? tile.top - 1 : 0; y < bottom; ++y) {
        const float* row = image.row(y);
        for (std::int32_t x = tile.left > 0 ? tile.left - 1 : 0; x < right; ++x) {
            const float* pixel = row + 3 * x;
            if (y >= tile.top && x + 1 < image.width && differ(pixel, pixel + 3)) mark(x, y), mark(x + 1, y);
            if (x >= tile.left && y + 1 < image.height && differ(pixel, image.row(y + 1) + 3 * x)) {
                mark(x, y), mark(x, y + 1);
            }
        }
    }
    return edges;
}

}  // namespace zerkalo
