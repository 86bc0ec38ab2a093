// Every stiff and extreme case: the renderer keeps the law in float and in fixed point, at every width, with equal bits,
// or refuses what fixed point cannot hold; and the textbook's formula breaks it.
#include "tools/stability/stiff_case.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <optional>
#include <set>
#include <string>

namespace zerkalo::stability {

void PrintTo(const StiffCase& row, std::ostream* out) { *out << row.id << ": " << row.input; }

namespace {

class Stiff : public testing::TestWithParam<StiffCase> {};

void expect_law(const StiffCase& row, Number number) {
    std::optional<double> scalar;
    for (const Isa isa : stages(number)) {
        const Verdict verdict = judge(row, isa, number);
        const double error = verdict.error.value_or(0);
        EXPECT_TRUE(verdict.holds) << row.law << ": " << name_of(isa) << " gives "
                                   << (verdict.error ? std::to_string(error) : "nothing") << " " << row.unit
                                   << ", at most " << bound_of(row, number) << "; refused: \"" << verdict.refused << '"';
        EXPECT_TRUE(std::isfinite(error)) << row.law;
        if (!scalar) scalar = error;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(error), std::bit_cast<std::uint64_t>(*scalar))
            << name_of(isa) << " gives " << error << ", scalar " << *scalar;
    }
}

TEST_P(Stiff, HoldsAtEveryWidth) { expect_law(GetParam(), Number::floating); }

TEST_P(Stiff, HoldsInFixedPoint) { expect_law(GetParam(), Number::fixed); }

TEST_P(Stiff, BreaksItsNaiveTwin) {
    const StiffCase& row = GetParam();
    const double error = row.naive();
    EXPECT_TRUE(breaks(row, error)) << row.failure << ": only " << error << " " << row.unit;
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
