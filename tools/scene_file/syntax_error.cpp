#include "tools/scene_file/syntax_error.hpp"

#include "tools/scene_file/decimal_comma.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace zerkalo::scene_file {
namespace {

constexpr std::string_view kBlanks = " \t";

/// The word of the line that begins at byte `start`: up to a blank or a delimiter.
std::string_view word_at(std::string_view line, std::size_t start) {
    return line.substr(start, line.find_first_of(" \t,]}#=", start) - start);
}

/// The word after the last '=' or ',' or '[' before `byte`: the value that the parser was reading.
std::string_view value_before(std::string_view line, std::size_t byte) {
    const std::size_t mark = line.find_last_of("=,[", byte == 0 ? 0 : byte - 1);
    if (mark == std::string_view::npos) return {};
    const std::size_t start = line.find_first_not_of(kBlanks, mark + 1);
    return start == std::string_view::npos ? std::string_view{} : word_at(line, start);
}

std::string lower(std::string_view word) {
    std::string result(word);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return result;
}

/// A number with nothing before or behind its point: TOML wants a digit on both sides.
std::string help_for_bare_point(std::string_view value) {
    if (value.size() > 40 || value.find_first_not_of("+-.0123456789") != std::string_view::npos) return {};
    if (std::count(value.begin(), value.end(), '.') != 1) return {};
    std::string repaired(value);
    const std::size_t point = repaired.find('.');
    if (point + 1 == repaired.size()) repaired += '0';
    if (point == 0 || repaired[point - 1] == '+' || repaired[point - 1] == '-') repaired.insert(point, "0");
    return repaired == value ? std::string{} : "write " + repaired;
}

std::string help_for_value(std::string_view value) {
    if (value.empty()) return {};
    const std::string word = lower(value);
    const bool negative = word.starts_with('-');
    const std::string bare = negative || word.starts_with('+') ? word.substr(1) : word;
    if (bare == "inf" || bare == "infinity") return std::string("write ") + (negative ? "-inf" : "inf");
    if (std::string help = help_for_bare_point(value); !help.empty()) return help;
    const bool is_word = bare.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos;
    if (is_word && bare != "nan" && value.size() < 40) return "words stand in quotes: \"" + std::string(value) + "\"";
    return {};
}

/// [light] written twice: the parser sees a table that is defined again.
std::string help_for_redefinition(std::string_view description) {
    for (const std::string_view name : {"light", "solid", "mirror"}) {
        const std::string name_in_quotes = "'" + std::string(name) + "'";
        if (description.find(name_in_quotes) != std::string_view::npos) {
            return "every " + std::string(name) + " begins with [[" + std::string(name) + "]], in double brackets";
        }
    }
    return "give it once";
}

/// True when the character at `byte` is Cyrillic: letters that look Latin are the usual reason.
bool is_cyrillic(std::string_view line, std::size_t byte) {
    const auto first = byte < line.size() ? static_cast<unsigned char>(line[byte]) : 0;
    return first == 0xd0 || first == 0xd1;
}

std::string help_for(std::string_view description, std::string_view line, std::size_t byte) {
    const auto says = [description](std::string_view part) { return description.find(part) != std::string_view::npos; };
    if (says("cannot redefine")) return help_for_redefinition(description);
    if (is_cyrillic(line, byte)) return "keys and numbers are written in Latin letters and digits";
    if (says("expected '=', saw ':'")) return "write = between a key and its value";
    if (says("a comment or whitespace, saw ','")) return "several numbers stand in brackets: [1.0, 2.0, 3.0]";
    if (says("while parsing string") || says("while parsing literal string")) return "a string ends with its quote";
    if (says("while parsing table header")) return "a table begins with [name], an element of a list with [[name]]";
    if (says("while parsing floating-point") || says("while parsing value"))
        return help_for_value(value_before(line, byte));
    if (says("while parsing boolean")) return help_for_value(value_before(line, byte));
    return {};
}

}  // namespace

void report_syntax_error(const toml::parse_error& error, Report& report) {
    const Position at = position_of(error.source());
    const std::string_view line = report.source().line(at.line);
    if (const auto comma = decimal_comma_in_line(line)) {
        const std::size_t start = report.source().byte_at(at.line, 1);
        report.error(report.source().position_at(start + comma->byte, static_cast<int>(comma->size)),
                     "a comma inside a number", "write " + comma->repaired + ", with a point");
        return;
    }
    const std::size_t byte = report.source().byte_at(at.line, at.column) - report.source().byte_at(at.line, 1);
    report.error(at, "not TOML: " + std::string(error.description()), help_for(error.description(), line, byte));
}

}  // namespace zerkalo::scene_file
