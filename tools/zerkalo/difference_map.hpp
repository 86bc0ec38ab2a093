// The picture of the differences of two pictures: where they differ, and by how much.
#pragma once

#include "tools/zerkalo/picture_difference.hpp"

#include <array>
#include <string>

namespace zerkalo {

/// One class of the map's scale: pixels whose worst channel is off by `up_to` steps of 8-bit sRGB or fewer, and by
/// more than the class before.
struct MapClass {
    int up_to;
    std::array<std::uint8_t, 3> color;  // 8-bit sRGB
    const char* name;                   // of the colour, for help and messages
};

/// From equal to utterly different. The classes double, so that one step and a wrong silhouette are both plain to see;
/// each colour is brighter than the one before, so that the map reads without colours too.
constexpr MapClass kMapScale[] = {
    {0, {0, 0, 0}, "black"},        {1, {45, 70, 215}, "blue"},     {2, {125, 60, 225}, "violet"},
    {4, {190, 55, 195}, "magenta"}, {8, {230, 70, 115}, "crimson"}, {16, {240, 100, 45}, "vermilion"},
    {32, {245, 150, 30}, "orange"}, {64, {250, 195, 30}, "yellow"}, {128, {252, 232, 130}, "pale yellow"},
    {255, {255, 255, 255}, "white"}};

/// Pixels that the mask leaves out.
constexpr std::array<std::uint8_t, 3> kMapMasked{64, 64, 64};

/// "black 0, blue 1, violet 2, magenta to 4, ...": the scale in words.
std::string map_legend();

/// The map, three codes a pixel, row-major, row 0 on top. Preconditions and `mask` as for difference_of().
std::vector<std::uint8_t> difference_map(const Picture& a, const Picture& b, const std::vector<bool>& mask);

}  // namespace zerkalo
