// One frame on the host: the plan, the picture's memory, and the threads and the clock around the kernels.
#pragma once

#include "core/render/render.hpp"
#include "tools/number.hpp"

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace zerkalo {

/// A prepared frame. `image` covers all of the plan's picture and is backed by `pixels`.
struct Frame {
    std::unique_ptr<Plan> plan;  // one of the three
    std::unique_ptr<FixedPlan> fixed_plan;
    std::unique_ptr<DoublePlan> double_plan;
    std::unique_ptr<float[]> pixels;
    LinearImage image;
    Isa isa = Isa::scalar;
    int lanes = 1;
    TileFunction kernel = nullptr;
    FixedTileFunction fixed_kernel = nullptr;
    DoubleTileFunction double_kernel = nullptr;
    int threads = 1;
    std::int32_t samples = 1, rotation = 0;  // of its first pass

    const PlanHead& head() const {
        if (plan) return *plan;
        if (fixed_plan) return *fixed_plan;
        return *double_plan;
    }
    void render_tile(const Tile& tile, RayCounts& rays) const {
        if (plan) {
            kernel(*plan, tile, image, rays);
        } else if (fixed_plan) {
            fixed_kernel(*fixed_plan, tile, image, rays);
        } else {
            double_kernel(*double_plan, tile, image, rays);
        }
    }
    /// What the next tiles are rendered with: see begin_pass(). No tile may be in work.
    void begin(const Pass& pass) const;
};

/// What rendering cost: seconds of all tiles, one entry a repetition, and the rays of one repetition.
struct FrameCost {
    std::vector<double> seconds;
    RayCounts rays;
    std::int64_t edge_pixels = 0;  // that got more camera rays
};

/// One thread's counts, alone on their cache lines.
struct alignas(128) ThreadCounts {
    RayCounts rays;
};

/// Prepares the plan and a picture whose pages are already touched. Precondition: available(isa).
/// Throws Failure: usage when a setting is refused, scene_invalid when the scene is.
Frame prepare_frame(const Scene& scene, const Settings& settings, Isa isa, int threads,
                    Number number = Number::floating);

/// Renders the whole picture `repeat` times, with a progress line when `progress` is set. Where the settings ask for it
/// pixels at edges get more camera rays.
FrameCost render_frame(const Frame& frame, int repeat, bool progress);

/// Renders the picture once, but leaves the tiles out that are begun after `stopped` was set.
void render_until(const Frame& frame, const std::atomic<bool>& stopped);

RayCounts& operator+=(RayCounts& sum, const RayCounts& more);

/// All rays, of every kind.
std::uint64_t total_of(const RayCounts& rays);

/// The features that the plan uses.
std::vector<std::string> features_of(const PlanHead& plan);

/// The middle one of `values`, the mean of the middle two of an even number. Precondition: at least one.
double median(std::vector<double> values);

}  // namespace zerkalo
