// A picture in passes: each makes it better, none is wasted, and after each the picture is whole and its error known.
//
//     const auto kernel = pass_kernel_for(plan, isa);
//     for (int group = 0; group < kFirstGroups; ++group) {                 // a survey of every tile, few tiles first
//         begin_pass(plan, {first_samples(plan, accumulator, wanted), rotation, true});
//         for (every tile with first_group(plan, i) == group) add_pass(plan, kernel, tile, accumulator, counts);
//     }
//     while (estimated_error(plan, accumulator) > wanted) {
//         plan_round(plan, accumulator, wanted);                           // who needs how many samples more
//         ++rotation;
//         for (int step = 0; step < kLadderSteps; ++step) {                // tiles of one step share a pass
//             begin_pass(plan, {samples_of_step(step), rotation});
//             for (every tile with tiles[i].next == samples_of_step(step)) add_pass(...);
//         }
//     }
//
// Without an error that is wanted, and always where kernel.spread is null, the survey is
//
//     for (int k = 0; k < kernel.survey_passes(); ++k, ++rotation) {
//         begin_pass(plan, {kernel.survey_samples(), rotation, k == 0});
//         for (every tile, or where k > 0 with tiles[i].next > 0) add_pass(...);
//     }
//
// Tiles of one pass may be added by many threads at once, in any order: a tile touches its own pixels and its own
// TileProgress. Everything here is a pure function of the plan and of the passes so far: same bytes for any order,
// thread count, instruction set. README.md has the reasons.
#pragma once

#include "core/render/render.hpp"

#include <type_traits>

namespace zerkalo {

constexpr std::int32_t kFirstSamples = kSpreadParts;   // of the survey, the floor: no tile is trusted with fewer
constexpr std::int32_t kMostSamples = 1 << 14;         // of one pass: what this does not reach is given up
constexpr int kLadderSteps = 24;                       // and so many sizes a later pass can have
constexpr int kFirstGroups = 5;                        // of tiles in a survey: the first ones tell what the next need
constexpr std::int32_t kReplicas = 4;                  // passes of a survey where one alone tells nothing of its error
constexpr std::int32_t kReplicaSamples = 2;            // and the lobe rays of each

/// Whether the parts of the plan's lobe rays tell the error of the whole. Not where every fourth point is far from an
/// even set, `jittered` and `sobol`, nor those of `r2` on a ggx mirror: there only whole passes do, each with a rotation
/// of its own.
bool parts_tell_error(const PlanHead& plan);

/// Samples of the passes after the survey: 4, 8, 12, 16, 24, 32, 48, ... kMostSamples.
constexpr std::int32_t samples_of_step(int step) {
    // From 8 on every step but the last of an octave is half of the octave.
    if (step == 0) return kFirstSamples;
    const std::int32_t octave = (2 * kFirstSamples) << ((step - 1) / 2);
    return step % 2 == 1 ? octave : octave + octave / 2;
}

/// What is known of a tile. All zero before its first pass.
struct TileProgress {
    double weight = 0;         // of its passes together
    double variance = 0;       // of the mean over them, summed over the tile's pixels and channels
    double deviations = 0;     // of passes told by one another: squares of their distances to the mean, by weight
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

/// A tile's pixels before the kernel paints over them.
struct TileBefore {
    float values[3 * kTilePixels];
};

/// Keeps the tile's pixels as they are, if it has had a pass.
void keep_tile(const PlanHead& plan, const Accumulator& accumulator, int tile, TileBefore& before);

/// From the new pass in the picture, which took so many lobe rays, to the mean of all passes. It tells its own error,
/// or is told by the others: then the tile's `next` is set until there are kReplicas.
void mix_tile(const PlanHead& plan, const Accumulator& accumulator, int tile, const TileBefore& before,
              const TileSpread& spread, std::uint64_t lobe_samples);
void mix_tile(const PlanHead& plan, const Accumulator& accumulator, int tile, const TileBefore& before,
              std::uint64_t lobe_samples);

/// What renders the tiles of the passes over a plan: all of them by one of these.
template <class F>
struct PassKernel {
    void (*tile)(const PlanOf<F>& plan, const Tile& tile, const LinearImage& image, RayCounts& counts);
    SpreadFunction spread;  // or null: passes are told by one another

    int survey_passes() const { return spread ? 1 : kReplicas; }
    std::int32_t survey_samples() const { return spread ? kFirstSamples : kReplicaSamples; }
};

/// A kernel in float whose lobe rays tell their spread, where their rule allows it. Precondition: available(isa).
template <class F>
PassKernel<F> pass_kernel_for(const PlanOf<F>& plan, Isa isa) {
    PassKernel<F> kernel{kernel_for(plan, isa), nullptr};
    if constexpr (std::is_same_v<F, FloatFormats>) {
        if (parts_tell_error(plan)) kernel.spread = spread_kernel_for(plan, isa);
    }
    return kernel;
}

/// Renders one tile with the plan's samples and rotation and adds it to the picture so far; adds to `counts`. A tile's
/// first passes must be those of the survey, no two with the same rotation. Precondition: plan.samples is a multiple of
/// kSpreadParts where the kernel tells its spread.
/// Here and not in the core's units, which call nothing through a pointer.
template <class F>
void add_pass(const PlanOf<F>& plan, const PassKernel<F>& kernel, int tile, const Accumulator& accumulator,
              RayCounts& counts) {
    TileBefore before;
    keep_tile(plan, accumulator, tile, before);
    const std::uint64_t samples_before = lobe_samples_of(counts);
    if constexpr (std::is_same_v<F, FloatFormats>) {
        if (kernel.spread) {
            TileSpread spread;
            kernel.spread(plan, tile_at(plan, tile), accumulator.picture, counts, spread);
            mix_tile(plan, accumulator, tile, before, spread, lobe_samples_of(counts) - samples_before);
            return;
        }
    }
    kernel.tile(plan, tile_at(plan, tile), accumulator.picture, counts);
    mix_tile(plan, accumulator, tile, before, lobe_samples_of(counts) - samples_before);
}

/// Estimated root of the mean square over all pixels and channels of (picture so far - limit of infinitely many
/// samples at the same camera rays); infinite before the survey of every tile is complete. Linear light.
double estimated_error(const PlanHead& plan, const Accumulator& accumulator);

/// The same of one tile.
double estimated_error(const PlanHead& plan, const Accumulator& accumulator, int tile);

/// The group of a tile, 0..kFirstGroups - 1: a sixteenth of the tiles is in the first one, as many as in all before it
/// in each later one. All lie evenly over the picture.
int first_group(const PlanHead& plan, int tile);

/// Samples of the next group's first pass, so that the whole picture should come a little short of `error`: by the
/// tiles that have had a pass, kFirstSamples where none has. A multiple of kSpreadParts.
std::int32_t first_samples(const PlanHead& plan, const Accumulator& accumulator, double error);

/// Sets `next` of every tile, so that the estimate should then be at most `error`: samples go where they lower it the
/// most. Returns false, and nobody gets a pass, if every tile that could need one has had kMostSamples. Precondition, of
/// both: the survey is complete.
bool plan_round(const PlanHead& plan, const Accumulator& accumulator, double error);

/// Sets `next` of every tile, so that the round takes about `lobe_samples` (lobe_samples_of), where they lower the error
/// the most. Returns false, and nobody gets a pass, where no tile needs lobe rays or all have had kMostSamples.
bool plan_round_of(const PlanHead& plan, const Accumulator& accumulator, double lobe_samples);

}  // namespace zerkalo
