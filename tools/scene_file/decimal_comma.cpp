#include "tools/scene_file/decimal_comma.hpp"

namespace zerkalo::scene_file {
namespace {

bool is_digit(std::string_view text, std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; }

/// The number around the comma at `comma`, which has a digit on both sides.
DecimalComma number_around(std::string_view text, std::size_t comma) {
    std::size_t first = comma;
    while (first > 0 && is_digit(text, first - 1)) --first;
    if (first > 0 && (text[first - 1] == '-' || text[first - 1] == '+')) --first;
    std::size_t last = comma + 1;
    while (is_digit(text, last)) ++last;
    std::string repaired(text.substr(first, last - first));
    repaired[comma - first] = '.';
    return {first, last - first, repaired};
}

bool is_part_of_a_number(std::string_view text, std::size_t comma) {
    return comma > 0 && is_digit(text, comma - 1) && is_digit(text, comma + 1);
}

/// True when the elements of an array are separated by something else than commas after this number.
bool separated_without_comma(std::string_view text, const DecimalComma& number) {
    std::size_t i = number.byte + number.size;
    const std::size_t next = text.find_first_not_of(" \t", i);
    if (next == std::string_view::npos) return false;
    return text[next] == ';' || (next > i && (is_digit(text, next) || text[next] == '-'));
}

/// True for 0,8 and -0,8: no list of numbers begins like that by habit.
bool begins_with_zero(const DecimalComma& number) {
    std::string_view digits = number.repaired;
    if (!is_digit(digits, 0)) digits.remove_prefix(1);
    return digits.starts_with("0.");
}

}  // namespace

std::optional<DecimalComma> decimal_comma_in_line(std::string_view line) {
    bool after_equals = false;
    int arrays = 0;
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '#') {
            break;
        } else if (c == '=') {
            after_equals = true;
        } else if (c == '[' || c == ']') {
            arrays += c == '[' ? 1 : -1;
        } else if (c == ',' && is_part_of_a_number(line, i)) {
            const DecimalComma number = number_around(line, i);
            const std::size_t end = number.byte + number.size;
            const bool in_a_list =
                (number.byte > 0 && line[number.byte - 1] == ',') || (end < line.size() && line[end] == ',');
            const bool lone = after_equals && arrays <= 0 && !in_a_list;
            if (lone || separated_without_comma(line, number)) return number;
        }
    }
    return std::nullopt;
}

std::optional<DecimalComma> decimal_comma_in_array(std::string_view array) {
    const bool has_wide_commas = array.find(", ") != std::string_view::npos;
    for (std::size_t i = 0; i < array.size(); ++i) {
        if (array[i] != ',' || !is_part_of_a_number(array, i)) continue;
        const DecimalComma number = number_around(array, i);
        if (has_wide_commas || begins_with_zero(number)) return number;
    }
    return std::nullopt;
}

}  // namespace zerkalo::scene_file
