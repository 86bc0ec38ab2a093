// Finds numbers written with a decimal comma (0,8), the commonest slip of a writer whose language has one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace zerkalo::scene_file {

struct DecimalComma {
    std::size_t byte;      // where the number begins
    std::size_t size;      // its bytes
    std::string repaired;  // the same with a point
};

/// In a line that is not well-formed: a comma between digits outside brackets, or inside them where the elements are
/// separated by blanks or semicolons instead. Strings and comments are skipped.
std::optional<DecimalComma> decimal_comma_in_line(std::string_view line);

/// In an array with too many elements, given as its text "[...]": 0,8 or an 1,5 beside commas that blanks follow.
std::optional<DecimalComma> decimal_comma_in_array(std::string_view array);

}  // namespace zerkalo::scene_file
