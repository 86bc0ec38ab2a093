// Half blocks: the foreground colour is the upper pixel, the background colour the lower one.
// Source: ECMA-48 (SGR, CUU, CUD), ISO 8613-6 direct colour.
#include "platform/terminal.hpp"

#include "platform/write_all.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sys/ioctl.h>

namespace zerkalo {
namespace {

constexpr char kUpperHalf[] = "\xe2\x96\x80";
constexpr char kResetAndNextLine[] = "\033[0m\n";
constexpr std::int32_t kMaxCells = 10000;

std::int32_t size_from_environment(const char* name, std::int32_t otherwise) {
    const char* text = std::getenv(name);
    const long value = text == nullptr ? 0 : std::strtol(text, nullptr, 10);
    return value >= 1 && value <= kMaxCells ? static_cast<std::int32_t>(value) : otherwise;
}

// The colours that the terminal has now, so that only changes are sent.
class Pen {
public:
    explicit Pen(std::string& text) : text_(text) {}

    void foreground(const std::uint8_t* rgb) { select(foreground_, rgb, 38); }
    void background(const std::uint8_t* rgb) { select(background_, rgb, 48); }

private:
    void select(std::int32_t& current, const std::uint8_t* rgb, int code) {
        const std::int32_t color = rgb[0] << 16 | rgb[1] << 8 | rgb[2];
        if (color == current) return;
        current = color;
        char escape[32];
        std::snprintf(escape, sizeof escape, "\033[%d;2;%d;%d;%dm", code, rgb[0], rgb[1], rgb[2]);
        text_ += escape;
    }

    std::string& text_;
    std::int32_t foreground_ = -1, background_ = -1;
};

void append_move(std::string& text, std::int32_t lines, char direction) {
    if (lines <= 0) return;
    char escape[16];
    std::snprintf(escape, sizeof escape, "\033[%d%c", lines, direction);
    text += escape;
}

}  // namespace

Extent terminal_bounds(int file) {
    winsize size{};
    if (::ioctl(file, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) {
        size.ws_col = static_cast<unsigned short>(size_from_environment("COLUMNS", 80));
        size.ws_row = static_cast<unsigned short>(size_from_environment("LINES", 24));
    }
    const std::int32_t rows = size.ws_row > 1 ? size.ws_row - 1 : 1;
    return {size.ws_col, 2 * rows};
}

// A lower pixel that does not exist (odd height) keeps the terminal's own background.
void Terminal::append_line(std::int32_t line) {
    const SrgbPart frame = frame_.codes();
    const std::uint8_t* upper = frame.row(2 * line);
    const std::uint8_t* lower = 2 * line + 1 < frame.height ? frame.row(2 * line + 1) : nullptr;
    Pen pen(text_);
    for (std::int32_t x = 0; x < frame.width; ++x, upper += 3) {
        const bool one_color = lower != nullptr && std::memcmp(upper, lower, 3) == 0;
        if (!one_color) pen.foreground(upper);
        if (lower != nullptr) pen.background(lower);
        text_ += one_color ? " " : kUpperHalf;
        if (lower != nullptr) lower += 3;
    }
    text_ += kResetAndNextLine;
}

IoStatus Terminal::present(const SrgbPart& part, const Point& at) {
    const IoStatus kept = frame_.present(part, at);
    if (!kept.ok()) return kept;
    const std::int64_t height = extent().height;
    const std::int32_t lines = static_cast<std::int32_t>((height + 1) / 2);
    std::int32_t first = 0, last = lines;
    if (drawn_) {
        const std::int64_t bottom = std::min<std::int64_t>(std::int64_t{at.y} + part.height, height);
        first = std::clamp(at.y, 0, extent().height) / 2;
        last = static_cast<std::int32_t>((std::max<std::int64_t>(bottom, 0) + 1) / 2);
        if (first >= last) return {};
    }

    text_.clear();
    if (drawn_) append_move(text_, lines - first, 'A');
    for (std::int32_t line = first; line < last; ++line) append_line(line);
    if (drawn_) append_move(text_, lines - last, 'B');
    drawn_ = true;
    if (const int error = write_all(file_, text_.data(), text_.size()); error != 0)
        return io_failure("terminal", "cannot write", error);
    return {};
}

}  // namespace zerkalo
