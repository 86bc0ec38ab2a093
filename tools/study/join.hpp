// Merges the shards of a study into one folder.
#pragma once

#include "tools/study/row.hpp"

#include <string>

namespace zerkalo::study {

/// What the folders hold together.
struct Joined {
    std::string plan_text;
    std::vector<Row> rows;  // in the order of the plan
};

/// Reads the shards. Throws Failure: io_failed for a folder without a study; usage for folders of different plans;
/// pictures_differ when two hold the same row with other errors; io_failed when rows of the plan are in none.
Joined joined(const std::vector<std::string>& folders);

}  // namespace zerkalo::study
