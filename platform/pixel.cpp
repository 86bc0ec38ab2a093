// Packing of 8-bit sRGB codes into a display's pixels: one formula over the channel masks. The formats that displays
// really have are instantiated as constants, so that the masks fold into shifts; any other goes by its values.
#include "platform/pixel.hpp"

#include <algorithm>
#include <cstring>

namespace zerkalo {
namespace {

constexpr std::int32_t kMatrixSide = 8;
constexpr std::int32_t kChunk = 256;  // pixels packed on the stack before they go to the display in one copy

// Rank 0..63 of a pixel in the threshold matrix: the bits of x^y and y interleaved, lowest first.
constexpr std::uint32_t rank_of(std::int32_t x, std::int32_t y) {
    std::uint32_t rank = 0;
    for (int bit = 0; bit < 3; ++bit) {
        rank = (rank << 1) | (((x ^ y) >> bit) & 1);
        rank = (rank << 1) | ((y >> bit) & 1);
    }
    return rank;
}

// Thresholds at the middle of 64 equal steps of 0..255: all above 0 and below 255, so that black stays black and
// white stays white.
struct ThresholdMatrix {
    std::uint8_t at[kMatrixSide][kMatrixSide]{};

    constexpr ThresholdMatrix() {
        for (std::int32_t y = 0; y < kMatrixSide; ++y)
            for (std::int32_t x = 0; x < kMatrixSide; ++x)
                at[y][x] = static_cast<std::uint8_t>(255 * (2 * rank_of(x, y) + 1) / 128);
    }
};

constexpr ThresholdMatrix kThresholds{};
constexpr std::uint32_t kHalf = 127;  // (code * levels + 127) / 255 rounds to nearest: no tie exists, 255 is odd

constexpr std::uint32_t scaled(std::uint32_t code, int length, std::uint32_t threshold) {
    const std::uint32_t levels = (1u << length) - 1;
    return (code * levels + (length < 8 ? threshold : kHalf)) / 255;
}

constexpr std::uint32_t packed(const PixelFormat& format, const std::uint8_t* rgb, std::uint32_t threshold) {
    return scaled(rgb[0], format.red.length, threshold) << format.red.offset |
           scaled(rgb[1], format.green.length, threshold) << format.green.offset |
           scaled(rgb[2], format.blue.length, threshold) << format.blue.offset;
}

// Packs `count` pixels of display row y from column x on.
inline void pack_run(const PixelFormat& format, std::uint32_t fill, unsigned char* out, const std::uint8_t* rgb,
                     std::int32_t count, std::int32_t x, std::int32_t y) {
    const std::uint8_t* thresholds = kThresholds.at[y & (kMatrixSide - 1)];
    for (std::int32_t i = 0; i < count; ++i) {
        const std::uint32_t value = packed(format, rgb + 3 * i, thresholds[(x + i) & (kMatrixSide - 1)]) | fill;
        for (int byte = 0; byte < format.bytes; ++byte)
            out[format.bytes * i + byte] = static_cast<unsigned char>(value >> (8 * byte));
    }
}

using RunPacker = void (*)(const PixelFormat&, unsigned char*, const std::uint8_t*, std::int32_t, std::int32_t,
                           std::int32_t);

template <PixelFormat kFormat>
void pack_known(const PixelFormat& format, unsigned char* out, const std::uint8_t* rgb, std::int32_t count,
                std::int32_t x, std::int32_t y) {
    pack_run(kFormat, format.fill, out, rgb, count, x, y);
}

void pack_masks(const PixelFormat& format, unsigned char* out, const std::uint8_t* rgb, std::int32_t count,
                std::int32_t x, std::int32_t y) {
    pack_run(format, format.fill, out, rgb, count, x, y);
}

struct KnownFormat {
    PixelFormat format;
    const char* name;
    RunPacker pack;
};

constexpr KnownFormat kKnownFormats[] = {
    {kXrgb8888, "XRGB8888", pack_known<kXrgb8888>}, {kXbgr8888, "XBGR8888", pack_known<kXbgr8888>},
    {kRgb565, "RGB565", pack_known<kRgb565>},       {kBgr565, "BGR565", pack_known<kBgr565>},
    {kRgb888, "RGB888", pack_known<kRgb888>},       {kBgr888, "BGR888", pack_known<kBgr888>},
};

KnownFormat known_or_masks(PixelFormat format) {
    format.fill = 0;
    for (const KnownFormat& known : kKnownFormats)
        if (known.format == format) return known;
    return {format, "masks", pack_masks};
}

}  // namespace

const char* name_of(const PixelFormat& format) { return known_or_masks(format).name; }

std::uint32_t quantise(std::uint8_t code, int length, std::int32_t x, std::int32_t y) {
    return scaled(code, length, kThresholds.at[y & (kMatrixSide - 1)][x & (kMatrixSide - 1)]);
}

void pack_part(const PixelFormat& format, unsigned char* memory, std::size_t stride, const Extent& extent,
               const SrgbPart& part, const Point& at) {
    // Clip in 64 bits: `at` plus a width may leave 32.
    const std::int64_t left = std::max<std::int64_t>(at.x, 0), top = std::max<std::int64_t>(at.y, 0);
    const std::int64_t right = std::min<std::int64_t>(std::int64_t{at.x} + part.width, extent.width);
    const std::int64_t bottom = std::min<std::int64_t>(std::int64_t{at.y} + part.height, extent.height);
    const RunPacker pack = known_or_masks(format).pack;

    for (std::int64_t y = top; y < bottom; ++y) {
        const std::uint8_t* source = part.row(static_cast<std::int32_t>(y - at.y));
        unsigned char* row = memory + static_cast<std::size_t>(y) * stride;
        for (std::int64_t x = left; x < right; x += kChunk) {
            // Device memory is slow byte by byte: pack on the stack, hand over whole runs.
            unsigned char run[kChunk * 4];
            const std::int32_t count = static_cast<std::int32_t>(std::min<std::int64_t>(kChunk, right - x));
            pack(format, run, source + 3 * (x - at.x), count, static_cast<std::int32_t>(x),
                 static_cast<std::int32_t>(y));
            std::memcpy(row + x * format.bytes, run, static_cast<std::size_t>(count) * format.bytes);
        }
    }
}

}  // namespace zerkalo
