// "Did you mean ...?": the known word nearest to a mistyped one.
// Distance: optimal string alignment (insert, delete, replace, swap neighbours), R. A. Wagner and R. Lowrance, 1975.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace zerkalo::scene_file {

/// Edits that turn one word into the other; upper and lower case are the same letter.
int edit_distance(std::string_view a, std::string_view b);

/// The nearest candidate within a third of the word's length, or one that contains the word; empty when none is near.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// `did you mean "..."?`, or `fallback` when nothing is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates, std::string fallback);

/// "a, b, c".
std::string listed(std::span<const std::string_view> words);

}  // namespace zerkalo::scene_file
