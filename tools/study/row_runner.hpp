// Renders what one row needs, and times it.
#pragma once

#include "tools/study/plan.hpp"
#include "tools/study/references.hpp"
#include "tools/study/row.hpp"

namespace zerkalo::study {

/// Of one scene: what every row of it is measured against.
struct SceneFacts {
    Regions regions;
    References references;
};

/// How rows are timed: `threads` render; repetitions until kMostRepetitions or, after the least, the budget is spent.
struct Timing {
    int threads = 1;
    double budget_seconds = 1;
};
constexpr int kMostRepetitions = 31;  // of a setting that is quick enough
constexpr int kLeastRepetitions = 6;  // of a slow one: fewer give no interval of 95 %

/// The whole row. `renderer` renders what is not timed. Throws Interrupted.
Row run_row(const StudyPlan& plan, const Setting& setting, const SceneFacts& facts, const Renderer& renderer,
            const Timing& timing);

}  // namespace zerkalo::study
