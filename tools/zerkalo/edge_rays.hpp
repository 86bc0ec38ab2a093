// More camera rays for the pixels at edges of a picture that is finished but for them: core/render/edges.hpp on threads.
#pragma once

#include "tools/zerkalo/frame.hpp"

#include <functional>

namespace zerkalo {

/// The edges of a finished picture, tile by tile, and how many there are.
struct EdgePixels {
    std::vector<std::uint64_t> of_tile;
    std::int64_t count = 0;
};

EdgePixels find_edges(const Frame& frame);

/// Paints the pixels at edges again, with the plan's edge_antialias camera rays and no fewer than samples[i] lobe rays for
/// each in tile i; adds to `rays`. Tiles begun after `stopped()` stay as they were. The plan is left at one camera ray.
void paint_edges(const Frame& frame, const EdgePixels& edges, const std::vector<std::int32_t>& samples,
                 const std::function<bool()>& stopped, RayCounts& rays);

}  // namespace zerkalo
