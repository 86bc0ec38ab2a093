// Checked arithmetic: what fits passes, and an operation that would lose a digit ends the program and says its name.
#include "core/numeric/fixed_elementary.hpp"

#include <gtest/gtest.h>

namespace zerkalo::test {
namespace {

static_assert(kCheckedFixed);

using Int = std::int64_t;
using Word = std::uint64_t;
constexpr Int kMostInt = std::numeric_limits<Int>::max(), kLeastInt = std::numeric_limits<Int>::min();
constexpr Word kMostWord = std::numeric_limits<Word>::max();

TEST(CheckedFixed, WhatFitsIsTheSameNumber) {
    EXPECT_EQ(checked_sum<Int>(kMostInt - 1, 1, "sum"), kMostInt);
    EXPECT_EQ(checked_sum<Word>(kMostWord - 1, 1, "sum"), kMostWord);
    EXPECT_EQ(checked_product<Int>(kMostInt, -1, "product"), -kMostInt);
    EXPECT_EQ(checked_product<Word>(Word{1} << 32, (Word{1} << 32) - 1, "product"), kMostWord - (Word{1} << 32) + 1);
    EXPECT_EQ(checked_shift<Word>(3, 62, "shift"), Word{3} << 62);
    EXPECT_EQ((checked_narrow<std::int32_t, Int>(-kLargest<std::int32_t>, "narrow")), -kLargest<std::int32_t>);
}

TEST(CheckedFixed, LostDigitsEndTheProgram) {
    EXPECT_DEATH(checked_sum<Int>(kMostInt, 1, "this sum"), "fixed point: this sum lost digits");
    EXPECT_DEATH(checked_sum<Int>(kLeastInt, -1, "this sum"), "this sum");
    EXPECT_DEATH(checked_sum<Word>(kMostWord, 1, "this sum"), "this sum");
    EXPECT_DEATH(checked_product<Int>(kLeastInt, -1, "this product"), "this product");
    EXPECT_DEATH(checked_product<Word>(Word{1} << 32, Word{1} << 32, "this product"), "this product");
    EXPECT_DEATH(checked_shift<Word>(3, 63, "this shift"), "this shift");
    EXPECT_DEATH(checked_shift<Word>(0, 64, "this shift"), "this shift");
    EXPECT_DEATH((checked_narrow<std::int32_t, Int>(Int{1} << 31, "this narrowing")), "this narrowing");
    EXPECT_DEATH((checked_narrow<Word, Int>(-1, "this narrowing")), "this narrowing");
}

/// The most negative integer is no number of a format: its negative would wrap around to itself.
TEST(CheckedFixed, NumbersOutsideOfTheirFormatEndTheProgram) {
    FixedFormats::Length beyond{};
    beyond.raw = std::numeric_limits<std::int32_t>::min();
    // Nobody computes what nobody reads: operations have no side effects.
    [[maybe_unused]] volatile std::int32_t read = 0;
    EXPECT_DEATH(read = (-beyond).raw, "fixed point: -x lost digits");
}

/// The ends of the formats are not beyond them: every operation takes them.
TEST(CheckedFixed, TheEndsOfTheFormatsPass) {
    using N = FixedNumbers<1>;
    const Length<N> ends[] = {Length<N>::far_away(), -Length<N>::far_away(), Length<N>(0), Length<N>::from_raw(1)};
    for (const auto a : ends) {
        for (const auto b : ends) {
            const auto square = a * b;
            EXPECT_EQ(square, b * a);
            EXPECT_EQ(a + b, b + a);
            EXPECT_EQ(as<Area<N>>(square + square), as<Area<N>>(b * a + b * a));
            EXPECT_EQ(product<Length<N>>(a, quotient<Inverse<N>>(b, a)), product<Length<N>>(quotient<Inverse<N>>(b, a), a));
            EXPECT_LE(absolute(quotient<Length<N>>(square, b)), Length<N>::far_away());
            EXPECT_GE(root<Length<N>>(a * a), Length<N>(0));
            EXPECT_GE(reciprocal<Inverse<N>>(a * a), Inverse<N>(0));
        }
    }
}

}  // namespace
}  // namespace zerkalo::test
