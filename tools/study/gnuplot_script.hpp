// The diagrams of one scene as a gnuplot script that holds its own data.
#pragma once

#include "tools/study/series.hpp"

#include <string>

namespace zerkalo::study {

/// Draws NAME-time, NAME-rays and NAME-split as .svg and .png into the folder that gnuplot runs in. `rows` are of one
/// scene; what the references cannot tell is no dot. Empty when nothing is left to draw.
std::string gnuplot_script(const std::string& name, const std::vector<const Row*>& rows);

/// A string in gnuplot's single quotes.
std::string gnuplot_quoted(const std::string& text);

/// The estimator whose error is split in diagram and table: fibonacci, else the first one. Precondition: rows.
std::string split_estimator(const std::vector<const Row*>& rows);

}  // namespace zerkalo::study
