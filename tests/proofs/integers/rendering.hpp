// The picture of a fixed-point plan and its line of output, by integers alone.
#pragma once

#include "core/image/hash.hpp"
#include "core/render/render.hpp"

namespace zerkalo::integers {

constexpr std::int32_t kWidth = 45, kHeight = 32;

inline Settings settings() {
    Settings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.samples = 5;
    return settings;
}

/// Tile by tile, without the core's dispatch: a program may have nothing but the kernel.
inline std::uint64_t hash_of_picture(const FixedPlan& plan, FixedTileFunction render_tile) {
    alignas(8) static unsigned char pixels[kWidth * kHeight * 3 * sizeof(float)];
    const LinearImage image{reinterpret_cast<float*>(pixels), kWidth, kHeight,
                            kWidth * 3 * static_cast<std::ptrdiff_t>(sizeof(float))};
    RayCounts counts;
    for (std::int32_t top = 0; top < kHeight; top += kTileSide) {
        for (std::int32_t left = 0; left < kWidth; left += kTileSide) {
            const std::int32_t width = kWidth - left, height = kHeight - top;
            const Rect tile{left, top, width < kTileSide ? width : kTileSide, height < kTileSide ? height : kTileSide};
            render_tile(plan, tile, image, counts);
        }
    }
    return hash_of(image);
}

/// "everything fixed <hash as 16 hex digits>".
inline void describe(std::uint64_t hash, char* line) {
    for (const char* c = "everything fixed "; *c != '\0'; ++c) *line++ = *c;
    for (int shift = 60; shift >= 0; shift -= 4) *line++ = "0123456789abcdef"[(hash >> shift) & 15u];
    *line++ = '\n';
    *line = '\0';
}

}  // namespace zerkalo::integers
