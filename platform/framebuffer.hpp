// The Linux framebuffer as a display: open, map, copy rows, unmap.
#pragma once

#include "platform/console.hpp"
#include "platform/display.hpp"
#include "platform/framebuffer_layout.hpp"

namespace zerkalo {

class Framebuffer {
public:
    Framebuffer() = default;
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;
    ~Framebuffer() { close(); }

    /// Opens and maps `path`, and takes the console so far as there is one (a machine without one is no error).
    /// ConsoleMode::untouched only looks: for listing devices. Errors: no such device, not a framebuffer, a layout
    /// that cannot be packed; the line names the member and the reason.
    IoStatus open(const char* path = "/dev/fb0", ConsoleMode mode = ConsoleMode::cursor_off);

    /// Unmaps and restores the console; the picture stays. Called by the destructor.
    void close();

    Extent extent() const { return layout_.extent; }
    PixelFormat format() const { return layout_.format; }

    /// Precondition: open. Cannot fail: what lies outside is left out.
    IoStatus present(const SrgbPart& part, const Point& at);

    const FramebufferLayout& layout() const { return layout_; }

private:
    IoStatus map(int file, const char* path);

    FramebufferLayout layout_;
    void* mapping_ = nullptr;
    std::size_t mapping_bytes_ = 0;
    std::size_t memory_offset_ = 0;  // of the video memory in the mapping
    Console console_;
};

static_assert(Display<Framebuffer>);

}  // namespace zerkalo
