// The diagrams of a study: a gnuplot script for every scene, and the pictures where gnuplot is installed.
#pragma once

#include "tools/study/series.hpp"

#include <string>

namespace zerkalo::study {

/// Writes FOLDER/diagrams/SCENE.gp and has gnuplot draw its pictures beside it. Returns false where there is no
/// gnuplot. Throws Failure(io_failed) when a file cannot be written or gnuplot refuses a script.
bool draw_diagrams(const std::string& folder, const std::vector<Row>& rows);

}  // namespace zerkalo::study
