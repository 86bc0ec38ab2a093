#include "tools/scene_file/source_text.hpp"

#include "tools/scene_file/utf8.hpp"

#include <algorithm>
#include <utility>

namespace zerkalo::scene_file {

SourceText::SourceText(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
    starts_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i) {
        if (text_[i] == '\n') starts_.push_back(i + 1);
    }
}

std::string_view SourceText::line(int number) const {
    if (number < 1 || static_cast<std::size_t>(number) > starts_.size()) return {};
    const std::size_t index = static_cast<std::size_t>(number) - 1;
    const std::size_t end = index + 1 < starts_.size() ? starts_[index + 1] - 1 : text_.size();
    std::string_view line = text().substr(starts_[index], end - starts_[index]);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

Position SourceText::position_at(std::size_t byte, int length) const {
    const auto next = std::upper_bound(starts_.begin(), starts_.end(), byte);
    const std::size_t index = static_cast<std::size_t>(next - starts_.begin()) - 1;
    const std::string_view before = text().substr(starts_[index], byte - starts_[index]);
    return {static_cast<int>(index) + 1, static_cast<int>(characters_of(before).size()) + 1, length};
}

std::size_t SourceText::byte_at(int line_number, int column) const {
    const std::string_view text_of_line = line(line_number);
    const auto characters = characters_of(text_of_line);
    std::size_t byte = line_number < 1 || static_cast<std::size_t>(line_number) > starts_.size()
                           ? text_.size()
                           : starts_[static_cast<std::size_t>(line_number) - 1];
    for (std::size_t i = 0; i < characters.size() && static_cast<int>(i) + 1 < column; ++i)
        byte += characters[i].size();
    return byte;
}

}  // namespace zerkalo::scene_file
