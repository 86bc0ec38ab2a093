#include "tools/scene_file/nesting.hpp"

#include <vector>

namespace zerkalo::scene_file {
namespace {

/// The byte after a string that begins at `start` with its quote; an unclosed one-line string ends with its line.
std::size_t end_of_string(std::string_view text, std::size_t start) {
    const char quote = text[start];
    const std::string_view triple = quote == '"' ? "\"\"\"" : "'''";
    const bool long_string = text.substr(start, 3) == triple;
    std::size_t i = start + (long_string ? 3 : 1);
    while (i < text.size()) {
        if (quote == '"' && text[i] == '\\') {
            i += 2;
        } else if (long_string && text.substr(i, 3) == triple) {
            // Up to two quotes may stand directly before the closing three.
            i += 3;
            while (i < text.size() && text[i] == quote) ++i;
            return i;
        } else if (!long_string && text[i] == quote) {
            return i + 1;
        } else if (!long_string && text[i] == '\n') {
            return i;
        } else {
            ++i;
        }
    }
    return text.size();
}

/// What the scanner knows between two characters.
class Nesting {
public:
    int depth() const { return header_dots_ + enclosing_ + key_dots_; }

    void read(char c) {
        switch (c) {
            case '\n': end_line(); break;
            case '=': in_key_ = false; break;
            case '.': read_dot(); break;
            case ',': next_element(); break;
            case '[':
            case '{': open(c); break;
            case ']':
            case '}': close(); break;
            default: break;
        }
    }

private:
    struct Level {
        char bracket;
        int dots;  // of the key that this level is the value of
    };

    void end_line() {
        in_header_ = false;
        if (!levels_.empty()) return;
        in_key_ = true;
        key_dots_ = 0;
    }

    void read_dot() {
        if (in_header_) {
            ++header_dots_;
        } else if (in_key_) {
            ++key_dots_;
        }
    }

    void next_element() {
        if (levels_.empty() || levels_.back().bracket != '{') return;
        in_key_ = true;
        key_dots_ = 0;
    }

    void open(char bracket) {
        if (bracket == '[' && levels_.empty() && in_key_) {
            in_header_ = true;
            header_dots_ = 0;
            return;
        }
        levels_.push_back({bracket, key_dots_});
        enclosing_ += 1 + key_dots_;
        key_dots_ = 0;
        in_key_ = bracket == '{';
    }

    void close() {
        if (levels_.empty()) return;
        key_dots_ = levels_.back().dots;
        enclosing_ -= 1 + key_dots_;
        levels_.pop_back();
        in_key_ = false;
    }

    std::vector<Level> levels_;
    int header_dots_ = 0, enclosing_ = 0, key_dots_ = 0;
    bool in_key_ = true, in_header_ = false;
};

}  // namespace

std::optional<std::size_t> first_too_deep(std::string_view text) {
    Nesting nesting;
    std::size_t i = 0;
    while (i < text.size()) {
        if (text[i] == '"' || text[i] == '\'') {
            i = end_of_string(text, i);
        } else if (text[i] == '#') {
            const std::size_t end = text.find('\n', i);
            i = end == std::string_view::npos ? text.size() : end;
        } else {
            nesting.read(text[i]);
            if (nesting.depth() > kMaxNesting) return i;
            ++i;
        }
    }
    return std::nullopt;
}

}  // namespace zerkalo::scene_file
