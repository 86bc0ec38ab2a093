#include "tools/zerkalo/messages.hpp"

#include "platform/write_all.hpp"
#include "tools/zerkalo/failure.hpp"

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <unistd.h>

namespace zerkalo {

bool color_allowed(int descriptor) {
    const char* no_color = std::getenv("NO_COLOR");
    const char* terminal = std::getenv("TERM");
    if (no_color && *no_color) return false;
    if (terminal && std::string_view(terminal) == "dumb") return false;
    return isatty(descriptor) == 1;
}

void print_error(const std::string& message) {
    const bool color = color_allowed(STDERR_FILENO);
    const char *red = color ? "\x1b[1;31m" : "", *plain = color ? "\x1b[0m" : "";
    std::fprintf(stderr, "zerkalo: %serror:%s %s\n", red, plain, message.c_str());
}

void print_result(const std::string& text) {
    const int error = write_all(STDOUT_FILENO, text.data(), text.size());
    if (error != 0) throw Failure(ExitCode::io_failed, format("standard output: %s", std::strerror(error)));
}

std::string format(const char* pattern, ...) {
    std::va_list arguments, again;
    va_start(arguments, pattern);
    va_copy(again, arguments);
    std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, pattern, arguments)), '\0');
    std::vsnprintf(text.data(), text.size() + 1, pattern, again);
    va_end(arguments);
    va_end(again);
    return text;
}

}  // namespace zerkalo
