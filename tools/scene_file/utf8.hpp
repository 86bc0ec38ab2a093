// UTF-8 text as characters. Source: Unicode Standard 15.0, table 3-7, "Well-Formed UTF-8 Byte Sequences".
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace zerkalo::scene_file {

/// Bytes of the well-formed character that `text` begins with; 0 when it begins with none.
std::size_t character_size(std::string_view text);

/// Splits a text into characters; a byte that fits nowhere is a character of its own.
std::vector<std::string_view> characters_of(std::string_view text);

/// The first byte that is not part of a well-formed character; npos when all are.
std::size_t first_malformed(std::string_view text);

}  // namespace zerkalo::scene_file
