// One number for a picture: 64-bit FNV-1a over the bytes of its linear float32 pixels, little-endian, row-major, RGB.
// Source: Fowler, Noll, Vo, "The FNV Non-Cryptographic Hash Algorithm" (IETF draft-eastlake-fnv).
#pragma once

#include "core/image/image_view.hpp"

#include <bit>

namespace zerkalo {

/// The same on every machine for the same picture. Row padding does not count.
inline std::uint64_t hash_of(const LinearImage& image) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (std::int32_t y = 0; y < image.height; ++y) {
        const float* row = image.row(y);
        for (std::int32_t i = 0; i < 3 * image.width; ++i) {
            const std::uint32_t bits = std::bit_cast<std::uint32_t>(row[i]);
            for (int byte = 0; byte < 4; ++byte) {
                hash ^= (bits >> (8 * byte)) & 0xffu;
                hash *= 0x100000001b3u;
            }
        }
    }
    return hash;
}

}  // namespace zerkalo
