// Turns the TOML parser's complaint into ours: where the slip is a common one, it says what to write instead.
#pragma once

#include "tools/scene_file/report.hpp"
#include "tools/scene_file/toml_tree.hpp"

namespace zerkalo::scene_file {

/// Adds exactly one error to the report.
void report_syntax_error(const toml::parse_error& error, Report& report);

}  // namespace zerkalo::scene_file
