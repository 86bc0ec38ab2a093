// Rows as lines of comma-separated values (RFC 4180) and back.
#pragma once

#include "tools/study/row.hpp"

#include <optional>
#include <string_view>

namespace zerkalo::study {

/// Quoted where it must be.
std::string csv_cell(std::string_view text);

/// With as many digits as identify it; "inf", "nan" where it is none; independent of the locale.
std::string csv_number(double value);

/// The cells of a line without its end. nullopt when quotes do not pair.
std::optional<std::vector<std::string>> cells_of(std::string_view line);

/// The names of all columns, the deterministic ones first. No line end.
std::string csv_header();

/// All columns of a row in that order, and the deterministic ones alone.
std::string csv_line(const Row& row);
std::string exact_csv_line(const Row& row);

/// Reads what csv_line() wrote; every double comes back bit for bit. nullopt when the line is damaged.
std::optional<Row> row_of(std::string_view line);

}  // namespace zerkalo::study
