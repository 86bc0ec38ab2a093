// A picture in passes: each makes it better, none is wasted, and after each the picture is whole and its error known.
//
//     begin_pass(plan, {kFirstSamples, rotation, true});                   // a survey of every tile
//     for (every tile) add_pass(plan, kernel, tile, accumulator, counts);
//     while (estimated_error(plan, accumulator) > wanted) {
//         plan_round(plan, accumulator, wanted);                           // who needs how many samples more
//         for (int step = 0; step < kLadderSteps; ++step) {                // tiles of one step share a pass
//             begin_pass(plan, {samples_of_step(step), ++rotation});
//             for (every tile with tiles[i].next == samples_of_step(step)) add_pass(...);
//         }
//     }
//
// Tiles of one pass may be added by many threads at once, in any order: a tile touches its own pixels and its own
// TileProgress. Everything here is a pure function of the plan and of the passes so far: same bytes for any order,
// thread count, instruction set. README.md has the reasons.
#pragma once

#include "core/render/render.hpp"

namespace zerkalo {

constexpr std::int32_t kFirstSamples = kSpreadParts;   // of the survey, the floor: no tile is trusted with fewer
constexpr std::int32_t kMostSamples = 1 << 14;         // of one pass: what this does not reach is given up
constexpr int kLadderSteps = 24;                       // and so many sizes a pass can have

/// Whether the error of a rule is known from its parts. Not where every fourth point is far from an even set:
/// `jittered` and `sobol`.
bool can_tell_error(Estimator estimator);

/// Samples of the passes after the survey: 4, 8, 12, 16, 24, 32, 48, ... kMostSamples.
std::int32_t samples_of_step(int step);

/// What is known of a tile. All zero before its first pass.
struct TileProgress {
    double weight = 0;         // of its passes together
    double variance = 0;       // of the mean over them, summed over the tile's pixels and channels
    double hits = 0;           // mirror hits, camera rays counted, from which lobe rays go out that can see something
    std::int64_t samples = 0;  // lobe rays a hit, of all passes
    std::int32_t passes = 0;
    std::int32_t next = 0;     // samples of the pass that it should get next; 0: none
    double pace = 0;           // how fast its weight should grow beside other tiles'; set with `next`
};

/// The picture so far, in the caller's memory.
struct Accumulator {
    LinearImage picture;            // the mean over all passes; whole once every tile has had one
    float* variance = nullptr;      // of each pixel, summed over its channels, row-major, zeroed to begin with; or null
    TileProgress* tiles = nullptr;  // tile_count(plan), zeroed to begin with
};

/// A tile between two passes: what its pixels were before the kernel painted over them, and how sure the new ones are.
struct TilePass {
    float before[3 * kTilePixels];
    TileSpread spread;
};

/// Keeps the tile's pixels as they are, if it has had a pass.
void keep_tile(const PlanHead& plan, const Accumulator& accumulator, int tile, TilePass& pass);

/// From the new pass in the picture, which took so many lobe rays, to the mean of all passes.
void mix_tile(const PlanHead& plan, const Accumulator& accumulator, int tile, const TilePass& pass,
              std::uint64_t lobe_rays);

/// Renders one tile with the plan's samples and rotation and adds it to the picture so far; adds to `counts`. The first
/// pass of every tile must be a survey. Precondition: plan.samples is a multiple of kSpreadParts.
/// Here and not in the core's units, which call nothing through a pointer.
inline void add_pass(const Plan& plan, SpreadFunction kernel, int tile, const Accumulator& accumulator,
                     RayCounts& counts) {
    TilePass pass;
    keep_tile(plan, accumulator, tile, pass);
    const std::uint64_t lobe_before = counts.lobe;
    kernel(plan, tile_at(plan, tile), accumulator.picture, counts, pass.spread);
    mix_tile(plan, accumulator, tile, pass, counts.lobe - lobe_before);
}

/// Estimated root of the mean square over all pixels and channels of (picture so far - limit of infinitely many
/// samples at the same camera rays); infinite before every tile has had a pass. Linear light.
double estimated_error(const PlanHead& plan, const Accumulator& accumulator);

/// The same of one tile.
double estimated_error(const PlanHead& plan, const Accumulator& accumulator, int tile);

/// Sets `next` of every tile, so that the estimate should then be at most `error`: samples go where they lower it the
/// most. Returns false, and nobody gets a pass, if every tile that could need one has had kMostSamples.
bool plan_round(const PlanHead& plan, const Accumulator& accumulator, double error);

/// Sets `next` of every tile, so that the round shoots about `lobe_rays`, where they lower the error the most.
/// Returns false, and nobody gets a pass, where no tile needs lobe rays or all have had kMostSamples.
bool plan_round_of(const PlanHead& plan, const Accumulator& accumulator, double lobe_rays);

}  // namespace zerkalo
