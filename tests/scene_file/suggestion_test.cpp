#include "tools/scene_file/suggestion.hpp"

#include <gtest/gtest.h>

#include <array>

namespace zerkalo::scene_file {
namespace {

constexpr std::array<std::string_view, 4> kWords{"position", "radius", "horizontal_fov_deg", "up"};

TEST(Suggestion, DistanceCountsInsertionsDeletionsReplacementsAndSwaps) {
    EXPECT_EQ(edit_distance("", ""), 0);
    EXPECT_EQ(edit_distance("radius", "radius"), 0);
    EXPECT_EQ(edit_distance("raduis", "radius"), 1);
    EXPECT_EQ(edit_distance("radus", "radius"), 1);
    EXPECT_EQ(edit_distance("radiuss", "radius"), 1);
    EXPECT_EQ(edit_distance("radios", "radius"), 1);
    EXPECT_EQ(edit_distance("Radius", "radius"), 0);
    EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(Suggestion, NearestIsTheWordWithTheFewestEdits) {
    EXPECT_EQ(nearest("raduis", kWords), "radius");
    EXPECT_EQ(nearest("positon", kWords), "position");
}

TEST(Suggestion, PartOfAWordSuggestsIt) { EXPECT_EQ(nearest("fov", kWords), "horizontal_fov_deg"); }

TEST(Suggestion, FarWordsSuggestNothing) {
    EXPECT_EQ(nearest("temperature", kWords), "");
    EXPECT_EQ(nearest("", kWords), "");
    EXPECT_EQ(nearest(std::string(100000, 'r'), kWords), "");
    EXPECT_EQ(did_you_mean("temperature", kWords, "no idea"), "no idea");
    EXPECT_EQ(did_you_mean("radios", kWords, "no idea"), "did you mean \"radius\"?");
}

}  // namespace
}  // namespace zerkalo::scene_file
