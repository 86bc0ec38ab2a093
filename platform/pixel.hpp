// How a display stores one pixel, and the packing of 8-bit sRGB codes into it. The names are the kernel's: the most
// significant channel first, stored little-endian, so kXrgb8888 lies in memory as B, G, R, X.
#pragma once

#include "core/image/image_view.hpp"

#include <cstddef>
#include <cstdint>

namespace zerkalo {

/// Bits [offset, offset + length) of the stored value; length 1..16.
struct Channel {
    std::uint8_t offset = 0, length = 0;

    friend constexpr bool operator==(const Channel&, const Channel&) = default;
};

/// One stored pixel: `bytes` (1..4) bytes, three channels that do not overlap, and bits that are always set (opaque
/// alpha).
struct PixelFormat {
    std::uint8_t bytes = 0;
    Channel red, green, blue;
    std::uint32_t fill = 0;

    friend constexpr bool operator==(const PixelFormat&, const PixelFormat&) = default;
};

constexpr PixelFormat kXrgb8888{4, {16, 8}, {8, 8}, {0, 8}, 0};
constexpr PixelFormat kXbgr8888{4, {0, 8}, {8, 8}, {16, 8}, 0};
constexpr PixelFormat kRgb565{2, {11, 5}, {5, 6}, {0, 5}, 0};
constexpr PixelFormat kBgr565{2, {0, 5}, {5, 6}, {11, 5}, 0};
constexpr PixelFormat kRgb888{3, {16, 8}, {8, 8}, {0, 8}, 0};
constexpr PixelFormat kBgr888{3, {0, 8}, {8, 8}, {16, 8}, 0};  // bytes R, G, B

/// "XRGB8888", ..., or "masks" for a format without a name. The fill does not count.
const char* name_of(const PixelFormat& format);

/// A rectangle of 8-bit sRGB codes, three bytes R, G, B a pixel; stride in bytes. The memory belongs to the caller.
struct SrgbPart {
    const std::uint8_t* pixels = nullptr;
    std::int32_t width = 0, height = 0;
    std::ptrdiff_t stride = 0;

    const std::uint8_t* row(std::int32_t y) const { return pixels + y * stride; }
};

struct Extent {
    std::int32_t width = 0, height = 0;

    friend constexpr bool operator==(const Extent&, const Extent&) = default;
};

struct Point {
    std::int32_t x = 0, y = 0;
};

/// 8-bit code -> `length` bits, for the display pixel (x, y). Exact rounding for 8 bits and more; below 8 bits an
/// ordered dither with an 8x8 threshold matrix, a pure function of (code, x, y). Code 0 gives 0, code 255 gives all
/// ones. Source: Bayer, "An optimum method for two-level rendition of continuous-tone pictures", ICC 1973.
std::uint32_t quantise(std::uint8_t code, int length, std::int32_t x, std::int32_t y);

/// Packs `part` into display memory with its top left pixel at `at`; what falls outside `extent` is left out (`at` may
/// be negative). `memory` is the display's pixel (0, 0), `stride` its bytes between rows. No byte between the rows is
/// touched. Same bytes for any cutting into parts.
void pack_part(const PixelFormat& format, unsigned char* memory, std::size_t stride, const Extent& extent,
               const SrgbPart& part, const Point& at);

}  // namespace zerkalo
