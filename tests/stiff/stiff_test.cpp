// Every stiff and extreme case: the renderer keeps the law at every width, with equal bits, and the textbook's formula
// breaks it.
#include "tools/stability/stiff_case.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>
#include <string>

namespace zerkalo::stability {

void PrintTo(const StiffCase& row, std::ostream* out) { *out << row.id << ": " << row.input; }

namespace {

class Stiff : public testing::TestWithParam<StiffCase> {};

TEST_P(Stiff, HoldsAtEveryWidth) {
    const StiffCase& row = GetParam();
    const double scalar = row.ours(Stage(Isa::scalar));
    EXPECT_TRUE(std::isfinite(scalar)) << row.law;
    EXPECT_TRUE(holds(row, scalar)) << row.law << ": " << scalar << " " << row.unit << ", at most " << row.bound;
    for (const Isa isa : stages()) {
        const double error = row.ours(Stage(isa));
        EXPECT_EQ(std::bit_cast<std::uint64_t>(error), std::bit_cast<std::uint64_t>(scalar))
            << name_of(isa) << " gives " << error << ", scalar " << scalar;
    }
}

TEST_P(Stiff, BreaksItsNaiveTwin) {
    const StiffCase& row = GetParam();
    const double error = row.naive();
    EXPECT_FALSE(holds(row, error)) << row.failure << ": only " << error << " " << row.unit;
}

INSTANTIATE_TEST_SUITE_P(Row, Stiff, testing::ValuesIn(all_cases()),
                         [](const testing::TestParamInfo<StiffCase>& info) { return std::string(info.param.id); });

TEST(StiffTable, HasEveryRowOnce) {
    std::set<std::string> ids;
    for (const StiffCase& row : all_cases()) EXPECT_TRUE(ids.insert(row.id).second) << row.id << " stands there twice";
    constexpr int kRows = 70;
    for (int number = 1; number <= kRows; ++number) {
        const std::string id = (number < 10 ? "S0" : "S") + std::to_string(number);
        EXPECT_TRUE(ids.count(id)) << id << " is missing";
    }
    EXPECT_EQ(ids.size(), static_cast<std::size_t>(kRows));
}

}  // namespace
}  // namespace zerkalo::stability
