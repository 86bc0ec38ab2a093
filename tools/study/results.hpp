// The results of a study as files: study.csv and study.json.
#pragma once

#include "tools/study/series.hpp"

#include <string>

namespace zerkalo::study {

/// All columns of every row, then the slopes of its series (regions mirror, edges, smooth).
std::string results_csv(const std::vector<Row>& rows);

/// {"plan": [lines], "rows": [{"exact": {...}, "measured": {...}, "slope": {...}}]}: the same names as in the CSV.
std::string results_json(const std::string& plan_text, const std::vector<Row>& rows);

/// Writes both into `folder`. Throws Failure(io_failed).
void write_results(const std::string& folder, const std::string& plan_text, const std::vector<Row>& rows);

}  // namespace zerkalo::study
