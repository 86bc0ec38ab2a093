// Scene files as texts whose numbers can be replaced, one token at a time.
#pragma once

#include <string>
#include <vector>

namespace zerkalo::bad_input {

/// A number in a text, and the key whose value it belongs to.
struct NumberToken {
    std::size_t begin, length;
    int line, column;  // from 1, in characters
    std::string key;
};

struct SceneText {
    std::string name, text;
    std::vector<NumberToken> numbers;
};

/// The scene files of this folder, round.toml and sharp.toml.
const std::vector<SceneText>& scene_texts();

/// The text with other words in place of some of its numbers (in the order of the text).
struct Replacement {
    const NumberToken* token;
    const char* literal;
};
std::string replaced(const SceneText& text, const std::vector<Replacement>& replacements);

}  // namespace zerkalo::bad_input
