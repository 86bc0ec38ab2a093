// A text terminal as a display: a character cell shows two pixels, one above the other, as a half block in 24-bit
// colour.
#pragma once

#include "platform/memory_display.hpp"
#include "platform/shrink.hpp"

#include <string>

namespace zerkalo {

/// The pixels that a terminal can show: its columns, and twice its rows but one (left for the prompt). The size is
/// asked of `file`, else of the variables COLUMNS and LINES, else 80x24.
Extent terminal_bounds(int file);

/// Draws where the cursor stands and leaves it below the picture; the next part is drawn over the first frame. Output
/// into a file is plain lines. For a larger picture: fit() it into terminal_bounds() and shrink() it.
class Terminal {
public:
    /// Writes to `file`, which stays the caller's. `extent` should lie within terminal_bounds(): longer lines wrap.
    Terminal(int file, Extent extent) : file_(file), frame_(extent) {}

    Extent extent() const { return frame_.extent(); }
    PixelFormat format() const { return frame_.format(); }

    /// Draws the character lines that the part touches; the first time, all. Error: the terminal is gone.
    IoStatus present(const SrgbPart& part, const Point& at);

private:
    void append_line(std::int32_t line);

    int file_;
    MemoryDisplay frame_;  // a part may change one half of a cell: the other one is kept here
    bool drawn_ = false;
    std::string text_;
};

static_assert(Display<Terminal>);

}  // namespace zerkalo
