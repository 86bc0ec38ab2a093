#include "tools/study/row_text.hpp"

#include <charconv>
#include <type_traits>

namespace zerkalo::study {
namespace {

std::string csv_value(const std::string& text) { return csv_cell(text); }
std::string csv_value(double value) { return csv_number(value); }
template <class Integer>
std::string csv_value(Integer value) {
    return std::to_string(value);
}

bool read_value(const std::string& cell, std::string& text) {
    text = cell;
    return true;
}
template <class Value>
bool read_value(const std::string& cell, Value& value) {
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return error == std::errc() && end == cell.data() + cell.size();
}

// Joins what a visitor is shown.
struct CellJoiner {
    std::string& line;

    template <class Value>
    void operator()(const std::string&, const Value& value) const {
        if (!line.empty()) line += ',';
        line += csv_value(value);
    }
};

}  // namespace

std::string key_of(const Row& row) {
    return row.scene + "/" + row.number + "/" + row.estimator + "/" + std::to_string(row.antialias) + "/" +
           (row.asked_error > 0 ? "error " + csv_number(row.asked_error) : std::to_string(row.samples));
}

std::string csv_cell(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

std::string csv_number(double value) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::optional<std::vector<std::string>> cells_of(std::string_view line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
            cells.back() += line[++i];
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            cells.emplace_back();
        } else {
            cells.back() += c;
        }
    }
    if (quoted) return std::nullopt;
    return cells;
}

std::string csv_header() {
    const Row row;
    std::string line;
    const auto add = [&](const std::string& name, const auto&) { line += (line.empty() ? "" : ",") + name; };
    visit_exact(row, add);
    visit_measured(row, add);
    return line;
}

std::string exact_csv_line(const Row& row) {
    std::string line;
    visit_exact(row, CellJoiner{line});
    return line;
}

std::string csv_line(const Row& row) {
    std::string line = exact_csv_line(row);
    visit_measured(row, CellJoiner{line});
    return line;
}

std::optional<Row> row_of(std::string_view line) {
    const auto cells = cells_of(line);
    if (!cells) return std::nullopt;
    Row row;
    std::size_t next = 0;
    bool good = true;
    const auto read = [&](const std::string&, auto& value) {
        good = good && next < cells->size() && read_value((*cells)[next++], value);
    };
    visit_exact(row, read);
    visit_measured(row, read);
    if (!good || next != cells->size()) return std::nullopt;
    return row;
}

}  // namespace zerkalo::study
