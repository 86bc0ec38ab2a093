// What the program says: messages on stderr, results on stdout.
#pragma once

#include <string>

namespace zerkalo {

/// True when `descriptor` is a terminal that may get colour: not with NO_COLOR set (and not empty), not with TERM=dumb.
bool color_allowed(int descriptor);

/// "zerkalo: error: ..." on stderr; "error:" in red where colour is allowed.
void print_error(const std::string& message);

/// Writes `text` to stdout at once. Throws Failure(io_failed) when stdout cannot take it.
void print_result(const std::string& text);

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

}  // namespace zerkalo
