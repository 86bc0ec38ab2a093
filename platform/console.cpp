// The console's cursor and drawing mode. Sources: console_codes(4), ioctl_console(2).
#include "platform/console.hpp"

#include "platform/write_all.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/kd.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace zerkalo {
namespace {

constexpr char kHideCursor[] = "\033[?25l";
constexpr char kShowCursor[] = "\033[?25h";

// The escape that shows the cursor also overrides the kernel's own default, so ask what that is. Without an answer
// (no /sys) the cursor stays hidden: a blinking block in the picture is the worse mistake.
bool cursor_is_shown_by_default() {
    const int file = ::open("/sys/module/vt/parameters/global_cursor_default", O_RDONLY | O_CLOEXEC);
    if (file < 0) return false;
    char value = '0';
    const bool known = ::read(file, &value, 1) == 1;
    ::close(file);
    return known && value != '0';
}

}  // namespace

IoStatus Console::take(ConsoleMode mode, const char* path) {
    restore();
    if (mode == ConsoleMode::untouched) return {};
    file_ = ::open(path, O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (file_ < 0) return io_failure(path, "cannot open the console", errno);
    // Only a virtual terminal has a mode to give back; a serial line must not get our escapes.
    if (::ioctl(file_, KDGETMODE, &mode_before_) != 0) {
        const int error = errno;
        ::close(file_);
        file_ = -1;
        return io_failure(path, "not a virtual terminal", error);
    }
    if (const int error = write_all(file_, kHideCursor, std::strlen(kHideCursor)); error != 0)
        return io_failure(path, "cannot hide the cursor", error);
    if (mode == ConsoleMode::graphics) {
        if (::ioctl(file_, KDSETMODE, KD_GRAPHICS) != 0) return io_failure(path, "cannot enter graphics mode", errno);
        mode_changed_ = true;
    }
    return {};
}

void Console::restore() {
    if (file_ < 0) return;
    if (mode_changed_) ::ioctl(file_, KDSETMODE, mode_before_);
    if (cursor_is_shown_by_default()) (void)write_all(file_, kShowCursor, std::strlen(kShowCursor));
    ::close(file_);
    file_ = -1;
    mode_changed_ = false;
}

}  // namespace zerkalo
