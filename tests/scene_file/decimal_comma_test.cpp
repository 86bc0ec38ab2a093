#include "tools/scene_file/decimal_comma.hpp"

#include <gtest/gtest.h>

namespace zerkalo::scene_file {
namespace {

TEST(DecimalComma, IsFoundInALineOutsideStringsAndComments) {
    const auto found = decimal_comma_in_line("a = \"1,5\" + -20,75 # 3,5");
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->byte, 12u);
    EXPECT_EQ(found->size, 6u);
    EXPECT_EQ(found->repaired, "-20.75");
    EXPECT_FALSE(decimal_comma_in_line("a = '1,5' # 3,5").has_value());
}

TEST(DecimalComma, ListsOfNumbersAreNotTakenForIt) {
    EXPECT_FALSE(decimal_comma_in_line("a = [1,2,3").has_value());
    EXPECT_FALSE(decimal_comma_in_line("a = [0,1, 2").has_value());
    EXPECT_FALSE(decimal_comma_in_line("a = 1,2,3").has_value());
    EXPECT_FALSE(decimal_comma_in_line("a = 1, 2").has_value());
    EXPECT_FALSE(decimal_comma_in_line("1,2").has_value()) << "a line inside a longer array";
    EXPECT_FALSE(decimal_comma_in_array("[1,2,3,4]").has_value());
    EXPECT_FALSE(decimal_comma_in_array("[1, 2, 3, 4]").has_value());
}

TEST(DecimalComma, IsFoundInAnArrayThatHasTooMany) {
    ASSERT_TRUE(decimal_comma_in_array("[0,8, 1, 2]").has_value());
    EXPECT_EQ(decimal_comma_in_array("[0,8, 1, 2]")->repaired, "0.8");
    ASSERT_TRUE(decimal_comma_in_array("[1, 2,5, 3]").has_value());
    EXPECT_EQ(decimal_comma_in_array("[1, 2,5, 3]")->repaired, "2.5");
    ASSERT_TRUE(decimal_comma_in_array("[-0,8,1,5,2,5]").has_value());
    EXPECT_EQ(decimal_comma_in_array("[-0,8,1,5,2,5]")->repaired, "-0.8");
    EXPECT_FALSE(decimal_comma_in_array("[10,8,1,5]").has_value());
}

}  // namespace
}  // namespace zerkalo::scene_file
