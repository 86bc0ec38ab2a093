#include "tools/scene_file/diagnostic.hpp"

#include "tools/scene_file/utf8.hpp"

#include <algorithm>

namespace zerkalo {
namespace scene_file {
namespace {

constexpr std::size_t kExcerptWidth = 100;
constexpr std::size_t kWordWidth = 40;

bool is_control(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    const bool c1 = character.size() == 2 && first == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0;
    return first < 0x20 || first == 0x7f || c1;
}

std::string printable_character(std::string_view character) {
    if (character == "\t") return " ";
    const bool stray_byte = character.size() == 1 && static_cast<unsigned char>(character[0]) >= 0x80;
    return is_control(character) || stray_byte ? "?" : std::string(character);
}

}  // namespace

std::string printable(std::string_view text) {
    std::string result;
    for (const std::string_view character : characters_of(text)) result += printable_character(character);
    return result;
}

std::string in_quotes(std::string_view word) {
    const auto characters = characters_of(word.substr(0, 4 * kWordWidth + 4));
    std::string result = "\"";
    for (std::size_t i = 0; i < std::min(characters.size(), kWordWidth); ++i) {
        result += printable_character(characters[i]);
    }
    return result + (characters.size() > kWordWidth ? "...\"" : "\"");
}

void attach_line(Diagnostic& diagnostic, std::string_view line) {
    const auto characters = characters_of(line);
    const std::size_t column = static_cast<std::size_t>(std::max(1, diagnostic.at.column)) - 1;
    const std::size_t before = column > kExcerptWidth / 2 ? column - kExcerptWidth / 2 : 0;
    const std::size_t first = characters.size() <= kExcerptWidth ? 0 : std::min(before, characters.size());
    const std::size_t last = std::min(characters.size(), first + kExcerptWidth);
    diagnostic.excerpt = first > 0 ? "..." : "";
    diagnostic.caret = static_cast<int>(std::clamp(column, first, last) - first + diagnostic.excerpt.size());
    for (std::size_t i = first; i < last; ++i) diagnostic.excerpt += printable_character(characters[i]);
    if (last < characters.size()) diagnostic.excerpt += "...";
}

}  // namespace scene_file

std::string to_text(const Diagnostic& diagnostic) {
    std::string text = scene_file::printable(diagnostic.file);
    if (diagnostic.at.line > 0) {
        text += ":" + std::to_string(diagnostic.at.line) + ":" + std::to_string(diagnostic.at.column);
    }
    text += ": error: " + diagnostic.message + "\n";
    if (diagnostic.excerpt.find_first_not_of(' ') != std::string::npos) {
        const int shown = static_cast<int>(scene_file::characters_of(diagnostic.excerpt).size());
        const int length = std::clamp(diagnostic.at.length, 1, std::max(1, shown - diagnostic.caret));
        text += "    " + diagnostic.excerpt + "\n";
        text += "    " + std::string(static_cast<std::size_t>(diagnostic.caret), ' ') + "^" +
                std::string(static_cast<std::size_t>(length - 1), '~') + "\n";
    }
    if (!diagnostic.help.empty()) text += "    help: " + diagnostic.help + "\n";
    return text;
}

}  // namespace zerkalo
