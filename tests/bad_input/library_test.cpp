// Bad numbers through the library: one at a time and in pairs, every scene is refused by the name of a field that is
// wrong, or gives a finite picture that is the same for every instruction set.
#include "tests/bad_input/bad_values.hpp"
#include "tests/bad_input/base_scenes.hpp"
#include "tests/bad_input/verdict.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <random>

namespace zerkalo::bad_input {
namespace {

// Without ZERKALO_ALL_PAIRS in the environment so many pairs a scene are drawn; with it all are tried.
constexpr int kPairs = ZERKALO_BAD_PAIRS;
constexpr unsigned kSeed = 20261123;
constexpr int kShownFailures = 20;

/// One field and one value for it.
struct Fault {
    Field field;
    int value;
};

std::vector<Fault> faults_of(const Scene& scene) {
    std::vector<Fault> faults;
    for (const Field& field : fields_in_use(scene)) {
        for (int value = 0; value < value_count(field); ++value) faults.push_back({field, value});
    }
    return faults;
}

void expect_single_faults_well_answered(const BaseScene& base) {
    Judge judge(Thoroughness::every_isa);
    const auto scene = std::make_unique<Scene>();
    for (const auto& [field, value] : faults_of(base.scene)) {
        *scene = base.scene;
        spoil(*scene, field, value);
        const std::string fault = judge.verdict(*scene, {&field, 1});
        EXPECT_EQ(fault, "") << base.name << ": " << text_of(field, value);
    }
    EXPECT_GT(judge.accepted(), 100) << base.name;
    EXPECT_GT(judge.refused(), 100) << base.name;
}

TEST(BadInput, OneBadNumberIsRefusedByNameOrGivesAFinitePicture) {
    for (const BaseScene& base : small_scenes()) expect_single_faults_well_answered(base);
}

TEST(BadInput, OneBadNumberInACrowdedSceneIsRefusedByNameOrGivesAFinitePicture) {
    expect_single_faults_well_answered(crowded_scene());
}

/// Calls try_pair(a, b) for all pairs of different fields, or for a sample of them.
template <class TryPair>
void each_pair(const std::vector<Fault>& faults, TryPair try_pair) {
    if (std::getenv("ZERKALO_ALL_PAIRS") != nullptr) {
        for (std::size_t i = 0; i < faults.size(); ++i) {
            for (std::size_t j = i + 1; j < faults.size(); ++j) try_pair(faults[i], faults[j]);
        }
        return;
    }
    std::mt19937 random(kSeed);
    for (int k = 0; k < kPairs; ++k) {
        const std::size_t i = random() % faults.size();
        try_pair(faults[i], faults[random() % faults.size()]);
    }
}

TEST(BadInput, TwoBadNumbersAreRefusedByNameOrGiveAFinitePicture) {
    for (const BaseScene& base : small_scenes()) {
        Judge judge(Thoroughness::one_other_isa);
        const auto scene = std::make_unique<Scene>();
        int failures = 0;
        each_pair(faults_of(base.scene), [&](const Fault& a, const Fault& b) {
            if (a.field.offset == b.field.offset) return;
            *scene = base.scene;
            spoil(*scene, a.field, a.value);
            spoil(*scene, b.field, b.value);
            const Field changed[] = {a.field, b.field};
            const std::string fault = judge.verdict(*scene, changed);
            if (fault.empty() || ++failures > kShownFailures) return;
            ADD_FAILURE() << base.name << ": " << text_of(a.field, a.value) << ", " << text_of(b.field, b.value) << ": "
                          << fault;
        });
        EXPECT_EQ(failures, 0) << base.name;
        EXPECT_GT(judge.accepted(), kPairs / 10) << base.name;
        EXPECT_GT(judge.refused(), kPairs / 10) << base.name;
    }
}

}  // namespace
}  // namespace zerkalo::bad_input
