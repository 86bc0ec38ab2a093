// What was to be reached, and what the rows show.
#pragma once

#include "tools/study/series.hpp"

namespace zerkalo::study {

struct Goal {
    std::string wanted, reached;
    bool met = false;
};

/// Of the scenes that the rows have. What the rows cannot tell is told as such and not met.
std::vector<Goal> goals_of(const std::vector<Row>& rows);

/// RMSE in steps of 8-bit sRGB, mirror region, rotation 0.
double srgb_steps(const Row& row);

/// Lobe rays a pixel of the mirror region.
double lobe_rays_a_pixel(const Row& row);

}  // namespace zerkalo::study
