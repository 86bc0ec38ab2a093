// What a study is going to do: its scenes and the settings of every row, in the order of the results.
#pragma once

#include "tools/study/setting.hpp"

#include <memory>
#include <string>
#include <vector>

namespace zerkalo::study {

/// What a person asked for.
struct Wish {
    std::vector<std::string> scenes;  // paths; "PATH@N" gives every unpolished mirror the lobe exponent N
    ImageSize size{160, 120};
    std::vector<Estimator> estimators;
    std::vector<Number> numbers;
    std::vector<std::int32_t> samples, fixed_samples, antialias;
    std::vector<std::int32_t> fibonacci_samples;  // of fibonacci in float beside `samples`: what errors are compared with
    std::vector<double> errors;  // to be reached by `render --error`: in float, by the lattices
    std::int32_t rotations = 32;
    std::int32_t reference_samples = 65536;
};

/// The wishes of a whole study and of one that ends within a minute.
Wish full_wish();
Wish quick_wish();

struct PlannedScene {
    std::string name;  // of the file without folders and extension; with "@N" as it was given
    std::unique_ptr<const Scene> scene;
    std::string lobe;          // of its first unpolished mirror
    double lobe_exponent = 0;  // of that mirror
};

struct StudyPlan {
    Wish wish;
    std::vector<PlannedScene> scenes;
    std::vector<Setting> rows;
    std::vector<std::string> refusals;  // "SCENE: NUMBER: ESTIMATOR: REASON": rows that cannot be
    std::string text;                   // of DIR/plan.txt: equal for equal plans

    const PlannedScene& scene_of(const Setting& setting) const {
        return scenes[static_cast<std::size_t>(setting.scene)];
    }
};

/// The key that the row of `setting` will have: key_of(Row).
std::string key_of(const StudyPlan& plan, const Setting& setting);

/// The keys of all rows of a plan from its text, in order.
std::vector<std::string> keys_of(const std::string& plan_text);

/// Reads the scenes and lists the rows. Throws Failure: io_failed and scene_invalid as read_scene() does;
/// scene_invalid also when the renderer refuses the scene; usage for two scenes of one name and for a scene without
/// an unpolished mirror.
StudyPlan plan_of(const Wish& wish);

}  // namespace zerkalo::study
