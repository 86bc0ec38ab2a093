// The checks of a framebuffer's description, from what the memory means to whether it is long enough.
#include "platform/framebuffer_layout.hpp"

namespace zerkalo {
namespace {

constexpr std::uint32_t kMaxSide = 65536;

Status refuse(const char* field, const char* reason) { return {field, reason}; }

Status check_kind(const fb_fix_screeninfo& fix, const fb_var_screeninfo& var) {
    if (fix.type != FB_TYPE_PACKED_PIXELS) return refuse("fix.type", "planes or text; packed pixels are needed");
    switch (fix.visual) {
        case FB_VISUAL_TRUECOLOR: break;
        case FB_VISUAL_PSEUDOCOLOR:
        case FB_VISUAL_STATIC_PSEUDOCOLOR: return refuse("fix.visual", "a palette; true colour is needed");
        case FB_VISUAL_DIRECTCOLOR: return refuse("fix.visual", "direct colour (ramps); true colour is needed");
        case FB_VISUAL_MONO01:
        case FB_VISUAL_MONO10: return refuse("fix.visual", "monochrome; true colour is needed");
        default: return refuse("fix.visual", "not true colour");
    }
    if (var.grayscale != 0) return refuse("var.grayscale", "grey levels or a FOURCC format; must be 0");
    if (var.nonstd != 0) return refuse("var.nonstd", "a non-standard pixel format; must be 0");
    const std::uint32_t bits = var.bits_per_pixel;
    if (bits != 8 && bits != 16 && bits != 24 && bits != 32)
        return refuse("var.bits_per_pixel", "must be 8, 16, 24 or 32");
    return kOk;
}

struct NamedField {
    const fb_bitfield& field;
    const char *offset, *length, *msb_right;
};

// A channel may not leave its pixel, nor share a bit with `taken`, to which it is added.
Status take_channel(const NamedField& named, std::uint32_t bits_per_pixel, bool may_be_empty, std::uint64_t& taken) {
    const fb_bitfield& field = named.field;
    if (field.length == 0 && may_be_empty) return kOk;
    if (field.msb_right != 0) return refuse(named.msb_right, "the most significant bit is on the right; must be 0");
    if (field.length < 1 || field.length > 16) return refuse(named.length, "must be 1 to 16 bits");
    if (field.offset >= bits_per_pixel || field.length > bits_per_pixel - field.offset)
        return refuse(named.offset, "the channel leaves its pixel");
    const std::uint64_t mask = ((std::uint64_t{1} << field.length) - 1) << field.offset;
    if ((taken & mask) != 0) return refuse(named.offset, "the channel overlaps another one");
    taken |= mask;
    return kOk;
}

Status check_channels(const fb_var_screeninfo& var, std::uint32_t& alpha) {
    const NamedField colors[] = {
        {var.red, "var.red.offset", "var.red.length", "var.red.msb_right"},
        {var.green, "var.green.offset", "var.green.length", "var.green.msb_right"},
        {var.blue, "var.blue.offset", "var.blue.length", "var.blue.msb_right"},
    };
    std::uint64_t taken = 0;
    for (const NamedField& color : colors)
        if (const Status status = take_channel(color, var.bits_per_pixel, false, taken); !status.ok()) return status;
    const std::uint64_t color_bits = taken;
    const NamedField transparency{var.transp, "var.transp.offset", "var.transp.length", "var.transp.msb_right"};
    if (const Status status = take_channel(transparency, var.bits_per_pixel, true, taken); !status.ok()) return status;
    alpha = static_cast<std::uint32_t>(taken & ~color_bits);
    return kOk;
}

// All in 64 bits: the kernel's 32-bit values may multiply past 32.
Status check_memory(const fb_fix_screeninfo& fix, const fb_var_screeninfo& var) {
    if (var.xres < 1 || var.xres > kMaxSide) return refuse("var.xres", "must be 1 to 65536");
    if (var.yres < 1 || var.yres > kMaxSide) return refuse("var.yres", "must be 1 to 65536");
    const std::uint64_t right = std::uint64_t{var.xoffset} + var.xres, bottom = std::uint64_t{var.yoffset} + var.yres;
    if (right > var.xres_virtual) return refuse("var.xoffset", "the visible part leaves xres_virtual");
    if (bottom > var.yres_virtual) return refuse("var.yoffset", "the visible part leaves yres_virtual (or wraps)");
    const std::uint64_t row_bytes = right * (var.bits_per_pixel / 8);
    if (fix.line_length < row_bytes) return refuse("fix.line_length", "shorter than a visible row");
    if (fix.smem_len < (bottom - 1) * fix.line_length + row_bytes)
        return refuse("fix.smem_len", "the memory is too short for the visible picture");
    return kOk;
}

Channel channel_of(const fb_bitfield& field) {
    return {static_cast<std::uint8_t>(field.offset), static_cast<std::uint8_t>(field.length)};
}

}  // namespace

Status layout_of(const fb_fix_screeninfo& fix, const fb_var_screeninfo& var, FramebufferLayout& layout) {
    std::uint32_t alpha = 0;
    if (const Status status = check_kind(fix, var); !status.ok()) return status;
    if (const Status status = check_channels(var, alpha); !status.ok()) return status;
    if (const Status status = check_memory(fix, var); !status.ok()) return status;

    const std::uint8_t bytes = static_cast<std::uint8_t>(var.bits_per_pixel / 8);
    layout.format = {bytes, channel_of(var.red), channel_of(var.green), channel_of(var.blue), alpha};
    layout.extent = {static_cast<std::int32_t>(var.xres), static_cast<std::int32_t>(var.yres)};
    layout.offset = std::size_t{var.yoffset} * fix.line_length + std::size_t{var.xoffset} * bytes;
    layout.stride = fix.line_length;
    layout.memory_bytes = fix.smem_len;
    return kOk;
}

}  // namespace zerkalo
