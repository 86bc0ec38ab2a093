// Keeps the kernel's text console from drawing into the picture, and gives it back afterwards.
#pragma once

#include "platform/io_status.hpp"

namespace zerkalo {

/// untouched: nothing is done. cursor_off: the cursor does not blink into the picture; text still may. graphics: the
/// console draws nothing at all until it is restored (KD_GRAPHICS); a program killed with SIGKILL leaves it dead.
enum class ConsoleMode : unsigned char { untouched, cursor_off, graphics };

class Console {
public:
    Console() = default;
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;
    ~Console() { restore(); }

    /// Takes the virtual terminal `path`. Errors: no such device, not a virtual terminal, not permitted.
    IoStatus take(ConsoleMode mode, const char* path = "/dev/tty0");

    /// Cursor and mode as they were. Called by the destructor.
    void restore();

private:
    int file_ = -1;
    int mode_before_ = 0;
    bool mode_changed_ = false;
};

}  // namespace zerkalo
