#include "tools/scene_file/nesting.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zerkalo::scene_file {
namespace {

std::string repeated(std::string_view part, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
}

TEST(Nesting, SixtyFourLevelsAreAllowedAndSixtyFiveAreNot) {
    const std::string good = "a = " + repeated("[", 64) + repeated("]", 64) + "\n";
    EXPECT_FALSE(first_too_deep(good).has_value());
    const std::string bad = "a = " + repeated("[", 65) + repeated("]", 65) + "\n";
    EXPECT_EQ(first_too_deep(bad), 4u + 64u);
    EXPECT_FALSE(first_too_deep("[a" + repeated(".a", 64) + "]\n").has_value());
    EXPECT_TRUE(first_too_deep("[a" + repeated(".a", 65) + "]\n").has_value());
    EXPECT_TRUE(first_too_deep("a" + repeated(".a", 65) + " = 1\n").has_value());
}

TEST(Nesting, HeadersKeysBracesAndBracketsAddUp) {
    const std::string header = "[a" + repeated(".a", 30) + "]\n";
    const std::string key = "b" + repeated(".b", 20) + " = ";
    EXPECT_FALSE(first_too_deep(header + key + repeated("[", 14) + repeated("]", 14)).has_value());
    EXPECT_TRUE(first_too_deep(header + key + repeated("[", 15) + repeated("]", 15)).has_value());
    EXPECT_FALSE(first_too_deep(header + key + repeated("{c.c=", 7) + "1" + repeated("}", 7)).has_value());
    EXPECT_TRUE(first_too_deep(header + key + repeated("{c.c=", 8) + "1" + repeated("}", 8)).has_value());
}

TEST(Nesting, ClosedBracketsDotsInNumbersStringsAndCommentsDoNotCount) {
    EXPECT_FALSE(first_too_deep(repeated("a = [[1.5, 2.5], { x.y = 3.25, z.y = 1 }]\n", 1000)).has_value());
    EXPECT_FALSE(first_too_deep("a = \"" + repeated("[", 100) + "\\\"" + repeated("[", 100) + "\"\n").has_value());
    EXPECT_FALSE(first_too_deep("a = '" + repeated("{", 100) + "'\n").has_value());
    EXPECT_FALSE(first_too_deep("a = \"\"\"\n" + repeated("[\n\"", 100) + "\"\"\"\"\n").has_value());
    EXPECT_FALSE(first_too_deep("a = '''\n" + repeated("[\n", 100) + "'''\n").has_value());
    EXPECT_FALSE(first_too_deep("# " + repeated("[", 100) + "\na = 1\n").has_value());
    EXPECT_FALSE(first_too_deep(repeated("[a.b.c]\nx.y = 1\n", 100)).has_value());
}

TEST(Nesting, BracketsBehindStringsAndCommentsCountAgain) {
    const std::string deep = "b = " + repeated("[", 65) + "\n";
    for (const std::string before :
         {"a = \"x\"\n", "a = 'x'\n", "a = \"\"\"x\"\"\"\n", "a = '''x'''''\n", "# x\n", "a = \"\"\n"}) {
        EXPECT_EQ(first_too_deep(before + deep), before.size() + 4 + 64) << before;
    }
}

}  // namespace
}  // namespace zerkalo::scene_file
