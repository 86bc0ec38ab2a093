// One complaint about a text file, printed the way compilers do: where, what, the line with a caret, the remedy.
#pragma once

#include <string>
#include <string_view>

namespace zerkalo {

/// A place in a text: line and column from 1, column and length in characters, not bytes. Line 0: the whole file.
struct Position {
    int line = 0, column = 0, length = 1;
};

struct Diagnostic {
    std::string file;
    Position at;
    std::string message;
    std::string help;     // what would be right, or empty
    std::string excerpt;  // the source line, shortened around the place and printable, or empty
    int caret = 0;        // characters of `excerpt` before the place
};

/// "file:line:col: error: message", the source line, a caret line, "help: ..."; every line ends with a newline.
std::string to_text(const Diagnostic& diagnostic);

namespace scene_file {

/// The text with every control character and every byte that is not UTF-8 replaced by '?', a tab by one blank.
std::string printable(std::string_view text);

/// A word of the user's in double quotes, printable, shortened to 40 characters.
std::string in_quotes(std::string_view word);

/// Fills `excerpt` and `caret` from the line that the place is in: at most 100 characters around it.
void attach_line(Diagnostic& diagnostic, std::string_view line);

}  // namespace scene_file
}  // namespace zerkalo
