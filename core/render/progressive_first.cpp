// How many samples a tile has in its first pass: what the tiles before it say of the others.
#include "core/render/progressive.hpp"

#include "core/numeric/float_mode.hpp"
#include "core/render/progressive_weight.hpp"

namespace zerkalo {
namespace {

/// Samples of the first pass beside those that all tiles alike would need. Where rays are dear beside a pass it pays to
/// leave more to the rounds, which give to the tiles that need it; measured over the shipped scenes (README.md).
constexpr double kShareOfOneBounce = 0.85, kShareOfGeneral = 0.375;

}  // namespace

int first_group(const PlanHead& plan, int tile) {
    // The set R2: tiles of every group lie evenly over the picture.
    const Rect rect = tile_at(plan, tile);
    const std::uint32_t place = std::uint32_t(rect.left / kTileSide) * 0xc13fa9a9u +
                                std::uint32_t(rect.top / kTileSide) * 0x91e10da5u;
    int group = 0;
    for (std::uint32_t share = place >> (33 - kFirstGroups); share != 0; share >>= 1) ++group;
    return group;
}

std::int32_t first_samples(const PlanHead& plan, const Accumulator& accumulator, double error) {
    const IeeeMode ieee;
    const int count = tile_count(plan);
    double units = 0, tiles = 0;
    for (int i = 0; i < count; ++i) {
        const TileProgress& tile = accumulator.tiles[i];
        units += tile.variance * tile.weight;
        tiles += tile.passes > 0;
    }
    if (units == 0) return kFirstSamples;
    const double weight = units * count / (tiles * variance_for(plan, error));
    const double share = rays_are_dear(plan) ? kShareOfGeneral : kShareOfOneBounce;
    const int gain = gain_of(plan, false);
    std::int32_t samples = kFirstSamples;
    // Until the next multiple of the parts is farther from what is wanted.
    while (samples < kLargestStep * kFirstSamples &&
           weight_of((samples + kSpreadParts / 2) / share, gain) < weight) {
        samples += kSpreadParts;
    }
    return samples;
}

}  // namespace zerkalo
