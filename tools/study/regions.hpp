// The parts of a picture whose errors are told apart. Which pixel belongs to which is asked of the renderer itself:
// pictures of the scene in which the colour of every object is its number.
#pragma once

#include "tools/study/light_picture.hpp"

#include <array>

namespace zerkalo::study {

/// picture: every pixel. mirror: the ray through the pixel's centre meets the front of a mirror first.
/// silhouettes: the pixel above, below, left or right meets another object, or in the polished mirror another image.
/// edges: pixels of `mirror` whose lobe meets more than one object (background included).
/// smooth: pixels of `mirror` whose lobe meets one solid and nothing else, and no rim of a shadow on it.
enum class Region { picture, mirror, silhouettes, edges, smooth };
constexpr int kRegionCount = 5;
constexpr const char* kRegionNames[kRegionCount] = {"picture", "mirror", "silhouettes", "edges", "smooth"};

/// One flag a pixel, row-major.
using Mask = std::vector<bool>;
using Regions = std::array<Mask, kRegionCount>;

inline const Mask& mask_of(const Regions& regions, Region region) { return regions[static_cast<std::size_t>(region)]; }
std::int64_t pixels_of(const Mask& mask);

/// Renders three small pictures, and one for every three lights. Throws as rendered() does.
Regions regions_of(const Renderer& renderer, const Scene& scene, const ImageSize& size);

}  // namespace zerkalo::study
