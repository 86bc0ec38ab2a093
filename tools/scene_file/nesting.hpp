// How deep a TOML text is nested, found before it is parsed: the parser's own tables are nested objects, and a text
// such as [a.a.a.a ...] would make them deeper than any stack.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace zerkalo::scene_file {

constexpr int kMaxNesting = 64;

/// The byte where brackets, braces and dotted keys together first go deeper than kMaxNesting; nothing if they never do.
/// Exact for well-formed text; for other text never less than what a parser sees before its first error.
std::optional<std::size_t> first_too_deep(std::string_view text);

}  // namespace zerkalo::scene_file
