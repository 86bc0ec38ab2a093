// Driver of /dev/fb*. Source: linux/fb.h and the kernel's Documentation/fb/api.rst.
#include "platform/framebuffer.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace zerkalo {

IoStatus Framebuffer::open(const char* path, ConsoleMode mode) {
    close();
    const int file = ::open(path, O_RDWR | O_CLOEXEC);
    if (file < 0) return io_failure(path, "cannot open the framebuffer", errno);
    const IoStatus status = map(file, path);
    ::close(file);  // the mapping lives on
    if (status.ok()) (void)console_.take(mode);
    return status;
}

IoStatus Framebuffer::map(int file, const char* path) {
    fb_fix_screeninfo fix{};
    fb_var_screeninfo var{};
    if (::ioctl(file, FBIOGET_FSCREENINFO, &fix) != 0 || ::ioctl(file, FBIOGET_VSCREENINFO, &var) != 0)
        return io_failure(path, "not a framebuffer", errno);
    FramebufferLayout layout;
    if (const Status status = layout_of(fix, var, layout); !status.ok()) {
        char reason[160];
        std::snprintf(reason, sizeof reason, "cannot draw on it: %s: %s", status.field, status.reason);
        return io_failure(path, reason);
    }

    // The kernel maps whole pages: the video memory begins where it begins within its first page.
    const std::size_t page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    const std::size_t offset = fix.smem_start % page;
    const std::size_t bytes = offset + layout.memory_bytes;
    void* mapping = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (mapping == MAP_FAILED) return io_failure(path, "cannot map the video memory", errno);
    layout_ = layout;
    mapping_ = mapping;
    mapping_bytes_ = bytes;
    memory_offset_ = offset;
    return {};
}

void Framebuffer::close() {
    if (mapping_ != nullptr) ::munmap(mapping_, mapping_bytes_);
    mapping_ = nullptr;
    layout_ = {};
    console_.restore();
}

IoStatus Framebuffer::present(const SrgbPart& part, const Point& at) {
    unsigned char* memory = static_cast<unsigned char*>(mapping_) + memory_offset_ + layout_.offset;
    pack_part(layout_.format, memory, layout_.stride, layout_.extent, part, at);
    return {};
}

}  // namespace zerkalo
