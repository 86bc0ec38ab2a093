// The one public header of the renderer: prepare a plan once, then render its tiles in any order, on any thread.
//
//     Plan plan;                                              // caller's memory, about 250 KB
//     const Status status = prepare(scene, settings, plan);   // checks, constants, chosen features
//     const TileFunction render_tile = kernel_for(plan, best_isa());
//     for (int i = 0; i < tile_count(plan); ++i) render_tile(plan, tile_at(plan, i), image, counts);
#pragma once

#include "core/image/image_view.hpp"
#include "core/render/plan.hpp"
#include "core/scene/scene.hpp"
#include "core/status.hpp"

namespace zerkalo {

/// The instruction sets a kernel can be built for; which exist in this program and on this CPU: see available().
enum class Isa : std::uint8_t { scalar, sse2, sse4_2, avx2, avx512, neon };
constexpr int kIsaCount = 6;

/// "scalar", "sse2", "sse4.2", "avx2", "avx512", "neon".
const char* name_of(Isa isa);

/// Pixels a packet: 1, 4, 8 or 16.
int lanes_of(Isa isa);

/// The instruction set whose kernel renders fixed point where `isa` is asked for, and its pixels a packet: 1, 4 or 8.
Isa fixed_isa_of(Isa isa);
int fixed_lanes_of(Isa isa);

/// True when this program has the kernel and this CPU can run it.
bool available(Isa isa);

/// The widest available one.
Isa best_isa();

/// Rays by kind, exact counts, the same for every ISA, thread count and tile order.
struct RayCounts {
    std::uint64_t primary = 0, reflected = 0, lobe = 0, refracted = 0, shadow = 0;
    // Lobe rays that are not sent, for they can meet nothing, and of which the background counts, each by its weight.
    std::uint64_t weighed = 0;
    // Of the estimator fibonacci+coverage, lobes instead of rays: those in which solids are covered, and those that may
    // meet a solid which is left to plain rays (hidden in part by another, or without an outline). Some are both.
    std::uint64_t covered = 0, sampled = 0;
};

/// Places in lobes that were looked at, by a ray or by its weight alone.
constexpr std::uint64_t lobe_samples_of(const RayCounts& rays) { return rays.lobe + rays.weighed; }

/// Renders one tile of the plan's picture into `image` (whole picture, plan.width x plan.height); adds to `counts`.
/// Touches no pixel but the tile's. A pure function of the plan: same bytes for any order, thread or ISA.
using TileFunction = void (*)(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts);
using FixedTileFunction = void (*)(const FixedPlan& plan, const Tile& tile, const LinearImage& image,
                                   RayCounts& counts);
using DoubleTileFunction = void (*)(const DoublePlan& plan, const Tile& tile, const LinearImage& image,
                                    RayCounts& counts);

/// How far apart the parts of the lobe rays lie, by pixel of a tile, row-major over the full tile side: the variance
/// of the pixel's value, summed over its channels, if the parts were independent. 0 where no lobe ray is needed, and
/// beyond the picture's edge.
struct TileSpread {
    float variance[kTilePixels];
    alignas(64) float parts[4][kSpreadParts * kTilePixels];  // working memory of the kernels
};

/// A TileFunction that also adds the spread of the tile's pixels; the picture's bytes are the same. Precondition:
/// plan.samples is a multiple of kSpreadParts.
using SpreadFunction = void (*)(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts,
                                TileSpread& spread);

/// Checks scene and settings and derives every constant of the frame. On error `plan` is left unspecified.
Status prepare(const Scene& scene, const Settings& settings, Plan& plan);

/// The same for the fixed-point kernel. Also refuses what the formats cannot hold, with the field and the reason.
Status prepare(const Scene& scene, const Settings& settings, FixedPlan& plan);

/// The same in double, for references: the samples of float to the last of its bits, rounded to float as pixels alone.
Status prepare(const Scene& scene, const Settings& settings, DoublePlan& plan);

/// Gives a prepared plan another pass: from now on it renders, byte for byte, what prepare() with these samples, this
/// rotation and these camera rays would have made it render, for a thousandth of the work. No tile may be in work.
/// Refuses what prepare() refuses, and the plan stays as it was.
Status begin_pass(Plan& plan, const Pass& pass);
Status begin_pass(DoublePlan& plan, const Pass& pass);
Status begin_pass(FixedPlan& plan, const Pass& pass);

/// The smallest kernel that covers what the plan needs. Precondition: available(isa).
TileFunction kernel_for(const Plan& plan, Isa isa);
SpreadFunction spread_kernel_for(const Plan& plan, Isa isa);
FixedTileFunction kernel_for(const FixedPlan& plan, Isa isa);
DoubleTileFunction kernel_for(const DoublePlan& plan, Isa isa);

/// Tiles of the picture, row-major; the last column and row may be smaller.
int tile_count(const PlanHead& plan);
Rect tile_at(const PlanHead& plan, int index);

/// The features that the plan uses, as names; returns how many were written (at most `capacity`).
int feature_names(const PlanHead& plan, const char** names, int capacity);

}  // namespace zerkalo
