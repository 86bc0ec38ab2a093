// What every scene with bad numbers in it must give: a finite picture, the same everywhere, or a refusal by name.
#pragma once

#include "core/render/render.hpp"
#include "tests/bad_input/fields.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace zerkalo::bad_input {

/// How thoroughly an accepted scene is rendered: by every instruction set, or by one lane and one other in turn.
enum class Thoroughness { every_isa, one_other_isa };

class Judge {
public:
    explicit Judge(Thoroughness thoroughness);

    /// "" when all is well; else what is wrong. `changed`: the fields that hold bad numbers.
    std::string verdict(const Scene& scene, std::span<const Field> changed);

    std::int64_t accepted() const { return accepted_; }
    std::int64_t refused() const { return refused_; }

private:
    std::string picture_fault();
    std::string fault_in_double(const Scene& scene);

    Thoroughness thoroughness_;
    std::vector<Isa> isas_;
    std::size_t turn_ = 0;
    std::unique_ptr<Plan> plan_;
    std::unique_ptr<DoublePlan> double_plan_;
    std::int64_t accepted_ = 0, refused_ = 0;
};

}  // namespace zerkalo::bad_input
