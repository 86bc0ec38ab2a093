#include "tests/bad_input/scene_text.hpp"

#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace zerkalo::bad_input {
namespace {

/// The numbers of one line, which begins at byte `begin` of the text. A number belongs to the last key before it.
void find_numbers(const std::string& line, std::size_t begin, int line_number, std::vector<NumberToken>& out) {
    static const std::regex word(R"(([a-z_]+) *=|"[^"]*"|[-+]?[0-9][0-9.e+-]*)");
    std::string key;
    for (std::sregex_iterator at(line.begin(), line.end(), word), end; at != end; ++at) {
        const auto place = static_cast<std::size_t>(at->position());
        if ((*at)[1].matched) {
            key = (*at)[1];
        } else if ((*at)[0].str().front() != '"') {
            const auto length = static_cast<std::size_t>(at->length());
            out.push_back({begin + place, length, line_number, static_cast<int>(place) + 1, key});
        }
    }
}

SceneText read(const std::string& name) {
    std::ifstream file(ZERKALO_SOURCE_DIR "/tests/bad_input/scenes/" + name);
    SceneText scene{name, {std::istreambuf_iterator<char>(file), {}}, {}};
    if (scene.text.empty()) throw std::runtime_error(name + " cannot be read");
    std::istringstream lines(scene.text);
    std::size_t begin = 0;
    int number = 0;
    for (std::string line; std::getline(lines, line); begin += line.size() + 1) {
        ++number;
        if (line.empty() || line.front() == '#') continue;
        find_numbers(line, begin, number, scene.numbers);
    }
    return scene;
}

}  // namespace

const std::vector<SceneText>& scene_texts() {
    static const std::vector<SceneText> texts{read("round.toml"), read("sharp.toml")};
    return texts;
}

std::string replaced(const SceneText& text, const std::vector<Replacement>& replacements) {
    std::string result;
    std::size_t at = 0;
    for (const auto& [token, literal] : replacements) {
        result += text.text.substr(at, token->begin - at) + literal;
        at = token->begin + token->length;
    }
    return result + text.text.substr(at);
}

}  // namespace zerkalo::bad_input
