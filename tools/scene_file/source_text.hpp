// A text file in memory with its lines: turns byte offsets into positions and gives the line for an excerpt.
#pragma once

#include "tools/scene_file/diagnostic.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace zerkalo::scene_file {

class SourceText {
public:
    /// `name` is what diagnostics call the file.
    SourceText(std::string name, std::string text);

    const std::string& name() const { return name_; }
    std::string_view text() const { return text_; }

    /// Line `number` from 1, without its line end; empty when there is no such line.
    std::string_view line(int number) const;

    /// The place of a byte, `length` characters long.
    Position position_at(std::size_t byte, int length = 1) const;

    /// The first byte of a place; the end of its line when the column lies beyond it.
    std::size_t byte_at(int line, int column) const;

private:
    std::string name_;
    std::string text_;
    std::vector<std::size_t> starts_;  // byte offset of every line
};

}  // namespace zerkalo::scene_file
