// Non-owning views of pixels. Row 0 is on top; strides are in bytes; the memory belongs to the caller.
#pragma once

#include <cstddef>
#include <cstdint>

namespace zerkalo {

/// Linear RGB, three floats a pixel, row-major.
struct LinearImage {
    float* pixels = nullptr;
    std::int32_t width = 0, height = 0;
    std::ptrdiff_t stride = 0;

    float* row(std::int32_t y) const {
        return reinterpret_cast<float*>(reinterpret_cast<unsigned char*>(pixels) + y * stride);
    }
    float* below(float* pixel) const {
        return reinterpret_cast<float*>(reinterpret_cast<unsigned char*>(pixel) + stride);
    }
};

/// A rectangle of pixels, left and top inclusive.
struct Rect {
    std::int32_t left = 0, top = 0, width = 0, height = 0;
};

}  // namespace zerkalo
