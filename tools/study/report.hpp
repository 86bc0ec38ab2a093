// The report of a study for people: study.md, tables and pictures.
#pragma once

#include "tools/study/series.hpp"

namespace zerkalo::study {

/// Markdown. `pictures`: the diagrams are there, `crops`: the crops are. The text tells what was measured with what.
std::string report_text(const std::vector<Row>& rows, const std::string& plan_text, bool pictures, bool crops);

}  // namespace zerkalo::study
