// How to render, as opposed to what: the knobs of `zerkalo render`.
#pragma once

#include "core/optics/estimator.hpp"

#include <cstdint>

namespace zerkalo {

constexpr std::int32_t kMaxImageSide = 65536;
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;
constexpr std::int32_t kMaxSamples = 1 << 20;
constexpr std::int32_t kMaxAntialias = 4096;
constexpr std::int32_t kMaxRotation = 0x7fffffff;
constexpr std::int32_t kMaxDepth = 255;
constexpr std::int32_t kMaxBranchDepth = 16;  // where a surface both reflects and transmits: the rays double each time

constexpr int kSpreadParts = 4;  // of the lobe rays: a spread needs a multiple of so many

/// What one pass over a frame has of its own: so many lobe rays, placed so (see Settings).
struct Pass {
    std::int32_t samples, rotation;
    bool survey = false;  // culling leaves in what more samples would need: the ray counts tell where lobe rays matter
    std::int32_t antialias = 0;  // camera rays a pixel; 0: as many as before
};

struct Settings {
    std::int32_t width = 0, height = 0;  // 0: the scene's
    std::int32_t samples = 16;           // lobe rays at the first glossy hit of a camera path, 1..kMaxSamples
    std::int32_t antialias = 1;          // camera rays a pixel, box filter; 1 is the pixel's centre
    std::int32_t edge_antialias = 0;     // of a pixel at an edge (render/edges.hpp); 0: as of the others, which have 1
    std::int32_t depth_limit = 6;        // a ray deeper than this is not traced and adds nothing, 0..kMaxDepth
    std::int32_t rotation = 0;           // one of the equally good placements of the lobe rays: independent frames
    Estimator estimator = Estimator::fibonacci;  // the rule that places them
    bool exact_plan = false;             // no culling at all: every solid is asked by every ray
};

}  // namespace zerkalo
