// The descriptions that drivers really give, and one refusal for every reason.
#include "platform/framebuffer_layout.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace zerkalo {
namespace {

struct Screen {
    fb_fix_screeninfo fix{};
    fb_var_screeninfo var{};
};

// A plain 32-bit true colour screen.
Screen xrgb_screen(std::uint32_t width = 640, std::uint32_t height = 480) {
    Screen screen;
    screen.fix.type = FB_TYPE_PACKED_PIXELS;
    screen.fix.visual = FB_VISUAL_TRUECOLOR;
    screen.fix.line_length = 4 * width;
    screen.fix.smem_len = 4 * width * height;
    screen.var.xres = screen.var.xres_virtual = width;
    screen.var.yres = screen.var.yres_virtual = height;
    screen.var.bits_per_pixel = 32;
    screen.var.red = {16, 8, 0};
    screen.var.green = {8, 8, 0};
    screen.var.blue = {0, 8, 0};
    return screen;
}

Screen screen_of(const PixelFormat& format) {
    Screen screen = xrgb_screen();
    screen.var.bits_per_pixel = 8u * format.bytes;
    screen.fix.line_length = 640u * format.bytes;
    screen.var.red = {format.red.offset, format.red.length, 0};
    screen.var.green = {format.green.offset, format.green.length, 0};
    screen.var.blue = {format.blue.offset, format.blue.length, 0};
    return screen;
}

TEST(FramebufferLayout, TakesTheFormatFromTheMasks) {
    for (const PixelFormat& format : {kXrgb8888, kXbgr8888, kRgb565, kBgr565, kRgb888, kBgr888}) {
        const Screen screen = screen_of(format);
        FramebufferLayout layout;
        const Status status = layout_of(screen.fix, screen.var, layout);
        ASSERT_TRUE(status.ok()) << name_of(format) << ": " << status.field << ": " << status.reason;
        EXPECT_EQ(layout.format, format) << name_of(format);
        EXPECT_EQ(layout.extent, (Extent{640, 480}));
        EXPECT_EQ(layout.stride, 640u * format.bytes);
        EXPECT_EQ(layout.offset, 0u);
        EXPECT_EQ(layout.memory_bytes, screen.fix.smem_len);
    }
}

TEST(FramebufferLayout, AcceptsMasksThatBitsPerPixelDoesNotTell) {
    Screen screen = screen_of(kRgb565);
    screen.var.red = {10, 5, 0};
    screen.var.green = {5, 5, 0};
    FramebufferLayout layout;
    ASSERT_TRUE(layout_of(screen.fix, screen.var, layout).ok());
    EXPECT_EQ(layout.format, (PixelFormat{2, {10, 5}, {5, 5}, {0, 5}, 0}));

    Screen deep = xrgb_screen();
    deep.var.red = {20, 10, 0};
    deep.var.green = {10, 10, 0};
    deep.var.blue = {0, 10, 0};
    ASSERT_TRUE(layout_of(deep.fix, deep.var, layout).ok());
    EXPECT_EQ(layout.format, (PixelFormat{4, {20, 10}, {10, 10}, {0, 10}, 0}));
}

TEST(FramebufferLayout, MakesAlphaOpaque) {
    Screen screen = xrgb_screen();
    screen.var.transp = {24, 8, 0};
    FramebufferLayout layout;
    ASSERT_TRUE(layout_of(screen.fix, screen.var, layout).ok());
    EXPECT_EQ(layout.format.fill, 0xff000000u);
}

TEST(FramebufferLayout, FollowsPaddedRowsAndOffsets) {
    Screen screen = screen_of(kRgb888);
    screen.fix.line_length = 2048;
    screen.fix.smem_len = 2048 * 1000;
    screen.var.xres_virtual = 682;
    screen.var.yres_virtual = 1000;
    screen.var.xoffset = 42;
    screen.var.yoffset = 520;
    FramebufferLayout layout;
    const Status status = layout_of(screen.fix, screen.var, layout);
    ASSERT_TRUE(status.ok()) << status.field << ": " << status.reason;
    EXPECT_EQ(layout.stride, 2048u);
    EXPECT_EQ(layout.offset, 520u * 2048u + 42u * 3u);
}

TEST(FramebufferLayout, NeedsNoByteBehindTheLastVisiblePixel) {
    Screen screen = xrgb_screen(100, 10);
    screen.fix.line_length = 512;
    screen.fix.smem_len = 9 * 512 + 400;  // the padding of the last row may be missing
    FramebufferLayout layout;
    EXPECT_TRUE(layout_of(screen.fix, screen.var, layout).ok());
    screen.fix.smem_len -= 1;
    EXPECT_STREQ(layout_of(screen.fix, screen.var, layout).field, "fix.smem_len");
}

struct Refusal {
    const char* field;
    std::function<void(Screen&)> spoil;
};

TEST(FramebufferLayout, RejectsWhatItCannotPack) {
    const Refusal refusals[] = {
        {"fix.type", [](Screen& s) { s.fix.type = FB_TYPE_PLANES; }},
        {"fix.type", [](Screen& s) { s.fix.type = FB_TYPE_FOURCC; }},
        {"fix.visual", [](Screen& s) { s.fix.visual = FB_VISUAL_PSEUDOCOLOR; }},
        {"fix.visual", [](Screen& s) { s.fix.visual = FB_VISUAL_STATIC_PSEUDOCOLOR; }},
        {"fix.visual", [](Screen& s) { s.fix.visual = FB_VISUAL_DIRECTCOLOR; }},
        {"fix.visual", [](Screen& s) { s.fix.visual = FB_VISUAL_MONO01; }},
        {"fix.visual", [](Screen& s) { s.fix.visual = FB_VISUAL_FOURCC; }},
        {"var.grayscale", [](Screen& s) { s.var.grayscale = 1; }},
        {"var.nonstd", [](Screen& s) { s.var.nonstd = 1; }},
        {"var.bits_per_pixel", [](Screen& s) { s.var.bits_per_pixel = 15; }},
        {"var.bits_per_pixel", [](Screen& s) { s.var.bits_per_pixel = 0; }},
        {"var.bits_per_pixel", [](Screen& s) { s.var.bits_per_pixel = 64; }},
        {"var.red.msb_right", [](Screen& s) { s.var.red.msb_right = 1; }},
        {"var.transp.msb_right",
         [](Screen& s) {
             s.var.transp = {24, 8, 1};
         }},
        {"var.green.length", [](Screen& s) { s.var.green.length = 0; }},
        {"var.blue.length", [](Screen& s) { s.var.blue.length = 17; }},
        {"var.red.offset", [](Screen& s) { s.var.red.offset = 25; }},
        {"var.red.offset", [](Screen& s) { s.var.red.offset = 0xfffffff8u; }},
        {"var.blue.offset", [](Screen& s) { s.var.blue.offset = 7; }},
        {"var.transp.offset",
         [](Screen& s) {
             s.var.transp = {23, 8, 0};
         }},
        {"var.xres", [](Screen& s) { s.var.xres = 0; }},
        {"var.yres", [](Screen& s) { s.var.yres = 65537; }},
        {"var.xoffset", [](Screen& s) { s.var.xoffset = 1; }},
        {"var.xoffset", [](Screen& s) { s.var.xoffset = 0xffffffffu; }},
        {"var.yoffset", [](Screen& s) { s.var.yoffset = 1; }},
        {"fix.line_length", [](Screen& s) { s.fix.line_length -= 1; }},
        {"fix.smem_len", [](Screen& s) { s.fix.smem_len -= 1; }},
        {"fix.smem_len", [](Screen& s) { s.fix.line_length = 0x80000000u; }},  // (yres - 1) * stride passes 32 bits
    };
    for (const Refusal& refusal : refusals) {
        Screen screen = xrgb_screen();
        refusal.spoil(screen);
        FramebufferLayout layout;
        layout.offset = 77;
        const Status status = layout_of(screen.fix, screen.var, layout);
        ASSERT_FALSE(status.ok()) << refusal.field;
        EXPECT_STREQ(status.field, refusal.field) << status.reason;
        EXPECT_GT(std::string(status.reason).size(), 5u) << refusal.field;
        EXPECT_EQ(layout.offset, 77u) << refusal.field << ": a refusal leaves the layout as it was";
    }
}

}  // namespace
}  // namespace zerkalo
