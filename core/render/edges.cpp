#include "core/render/edges.hpp"

#include "core/numeric/float_mode.hpp"

namespace zerkalo {
namespace {

constexpr float kStep = 0x1p-4f;  // of the square root of light

/// |sqrt a - sqrt b| > kStep of values held in 0..1, without roots: of the larger one, a > b + 2 kStep sqrt b + kStep^2.
/// Without branches, so that a row of values is compared in vector registers.
std::uint32_t far_apart(float a, float b) {
    const float larger = a > b ? a : b, smaller = a > b ? b : a;
    const float high = larger < 1 ? larger : 1.0f, low = smaller > 0 ? smaller : 0.0f;
    const float beyond = high - low - kStep * kStep;
    const std::uint32_t further = beyond * beyond > 4 * kStep * kStep * low ? 1u : 0u;
    return beyond > 0 ? further : 0u;
}

constexpr int kMostPairs = kTileSide + 1;

/// Bit i: pixel i of `a` and of `b` are far apart in some channel.
std::uint32_t pairs_apart(const float* a, const float* b, int pixels) {
    std::uint32_t apart[3 * kMostPairs], any = 0;
    for (int i = 0; i < 3 * pixels; ++i) {
        apart[i] = far_apart(a[i], b[i]);
        any |= apart[i];
    }
    if (any == 0) return 0;
    std::uint32_t bits = 0;
    for (int i = 0; i < pixels; ++i) bits |= (apart[3 * i] | apart[3 * i + 1] | apart[3 * i + 2]) << i;
    return bits;
}

}  // namespace

std::uint64_t edge_pixels(const LinearImage& image, const Rect& tile) {
    const IeeeMode ieee;
    const std::uint32_t inside = (1u << tile.width) - 1;
    const int before = tile.left > 0 ? 1 : 0, after = tile.left + tile.width < image.width ? 1 : 0;
    const std::int32_t below = tile.top + tile.height < image.height ? 1 : 0;
    std::uint64_t edges = 0;
    std::uint32_t upwards = 0;  // pixels of a row that differ from the one above
    for (std::int32_t y = tile.top > 0 ? -1 : 0; y < tile.height; ++y) {
        const float* row = image.row(tile.top + y) + 3 * tile.left;
        std::uint32_t of_row = upwards;
        if (y >= 0) {
            // Bit i: pixel i - before and the one on its right.
            const float* first = row - 3 * before;
            const std::uint32_t sideways = pairs_apart(first, first + 3, tile.width - 1 + before + after);
            of_row |= sideways >> before | (before ? sideways : sideways << 1);
        }
        upwards = 0;
        if (y + 1 < tile.height + below) {
            upwards = pairs_apart(row, image.row(tile.top + y + 1) + 3 * tile.left, tile.width);
        }
        if (y >= 0) edges |= std::uint64_t{(of_row | upwards) & inside} << (y * kTileSide);
    }
    return edges;
}

}  // namespace zerkalo
