// A whole study: from a plan to its rows and results, or from the folders of its shards.
#pragma once

#include "tools/study/plan.hpp"
#include "tools/study/row_runner.hpp"

#include <optional>

namespace zerkalo::study {

/// Every `of`-th row of the plan, beginning with row `number` - 1; 1 <= number <= of.
struct Shard {
    int number = 1, of = 1;
};

struct StudyOptions {
    std::string folder;
    std::string references;  // folder of the references; empty: in `folder`
    Shard shard;
    Renderer renderer;
    Timing timing;
    double tolerance = 1e-3;  // references farther apart than this (RMSE, mirror region) are none
    bool progress = false;
};

/// Runs the rows that are missing and writes study.csv and study.json; a shard writes its rows alone. Finished rows
/// stay whatever happens. Throws Failure: io_failed; usage when the folder holds another plan; pictures_differ when
/// the references disagree; interrupted.
void run_study(const StudyPlan& plan, const StudyOptions& options);

/// Merges the shards in `folders` into options.folder and writes what run_study() writes. Throws as joined() does, and
/// Failure(io_failed).
void join_study(const std::vector<std::string>& folders, const StudyOptions& options);

/// "K/N" with 1 <= K <= N; nullopt for anything else.
std::optional<Shard> shard_of(const std::string& text);

/// The rows in the order of the plan; those that are missing are left out.
std::vector<Row> in_plan_order(const StudyPlan& plan, const std::vector<Row>& rows);

}  // namespace zerkalo::study
