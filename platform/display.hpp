// What a display is: three functions. And the two ways to fill one: with a linear picture, with black.
#pragma once

#include "core/image/resolve.hpp"
#include "platform/io_status.hpp"
#include "platform/pixel.hpp"

#include <algorithm>
#include <concepts>
#include <vector>

namespace zerkalo {

/// extent(): pixels that can be seen. format(): how one is stored. present(part, at): shows 8-bit sRGB codes with their
/// top left pixel at `at`; a part may be one tile, parts come in any order, what lies outside the extent is left out.
template <class D>
concept Display = requires(D display, const D& constant, const SrgbPart& part, const Point& at) {
    { constant.extent() } -> std::same_as<Extent>;
    { constant.format() } -> std::same_as<PixelFormat>;
    { display.present(part, at) } -> std::same_as<IoStatus>;
};

/// Bytes of the band in which a picture is resolved on its way to a display: far below a frame, and a whole terminal.
constexpr std::int64_t kBandBytes = 65536;

/// Resolves `picture` to sRGB band by band and presents it at `at`. Heap: one band.
template <Display D>
IoStatus present_linear(D& display, const LinearImage& picture, const Point& at = {}) {
    const std::int64_t row_bytes = std::int64_t{3} * picture.width;
    if (row_bytes <= 0) return {};
    const std::int32_t rows =
        static_cast<std::int32_t>(std::clamp<std::int64_t>(kBandBytes / row_bytes, 1, std::max(picture.height, 1)));
    std::vector<std::uint8_t> band(static_cast<std::size_t>(rows * row_bytes));
    for (std::int32_t y = 0; y < picture.height; y += rows) {
        const std::int32_t count = std::min(rows, picture.height - y);
        for (std::int32_t i = 0; i < count; ++i)
            resolve8(picture.row(y + i), band.data() + i * row_bytes, static_cast<std::size_t>(row_bytes));
        const IoStatus status = display.present({band.data(), picture.width, count, row_bytes}, {at.x, at.y + y});
        if (!status.ok()) return status;
    }
    return {};
}

/// Makes the whole display black. Heap: one row; the part's rows all lie on it (stride 0).
template <Display D>
IoStatus clear(D& display) {
    const Extent extent = display.extent();
    const std::vector<std::uint8_t> row(static_cast<std::size_t>(3) * static_cast<std::size_t>(extent.width));
    return display.present({row.data(), extent.width, extent.height, 0}, {0, 0});
}

}  // namespace zerkalo
