// From the values of the kernel's two framebuffer structs to where each pixel lies, or to a refusal that says why.
// Source: linux/fb.h. Nothing is concluded from bits_per_pixel alone: the channel masks count.
#pragma once

#include "core/status.hpp"
#include "platform/pixel.hpp"

#include <linux/fb.h>

namespace zerkalo {

/// Pixel (x, y) of the visible picture lies at bytes offset + y * stride + x * format.bytes of the video memory.
struct FramebufferLayout {
    PixelFormat format;
    Extent extent;
    std::size_t offset = 0;
    std::size_t stride = 0;
    std::size_t memory_bytes = 0;  // what must be mapped: smem_len
};

/// Pure function of the two structs. Accepts packed true colour of 8, 16, 24 or 32 bits with any channel masks, padded
/// rows and panned offsets. Otherwise Status::field is the struct's member ("var.red.msb_right"), and `layout` is left
/// as it was.
Status layout_of(const fb_fix_screeninfo& fix, const fb_var_screeninfo& var, FramebufferLayout& layout);

}  // namespace zerkalo
