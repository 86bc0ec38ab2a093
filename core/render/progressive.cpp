// Passes mixed into a picture, and how sure it is.
#include "core/render/progressive.hpp"

#include "core/numeric/float_mode.hpp"
#include "core/numeric/setup.hpp"
#include "core/render/progressive_weight.hpp"

namespace zerkalo {
namespace {

/// Variance of an average over its expectation from independent parts, by log2 of the samples from 4 on, linear
/// between: measured over the shipped scenes. The parts of a lattice lie so that together they are the better lattice.
constexpr double kLattice[] = {0.41, 0.40, 0.28, 0.165, 0.14, 0.19, 0.28, 0.37, 0.41, 0.41, 0.41};
constexpr double kR2[] = {0.50, 0.42, 0.42, 0.25, 0.13, 0.17, 0.23, 0.23, 0.23, 0.23, 0.23};
// Rays off normals that the viewer sees lie less evenly.
constexpr double kLatticeOfGgx[] = {0.54, 0.53, 0.44, 0.31, 0.21, 0.22, 0.25, 0.31, 0.38, 0.42, 0.42};
constexpr int kOctaves = sizeof kLattice / sizeof *kLattice;
static_assert(sizeof kR2 == sizeof kLattice && sizeof kLatticeOfGgx == sizeof kLattice);

double share_of_parts(const PlanHead& plan) {
    if (plan.sampling.estimator == Estimator::random) return 1;
    const double* of_lattice = plan.features & kFeatureGgx ? kLatticeOfGgx : kLattice;
    const double* table = plan.sampling.estimator == Estimator::r2 ? kR2 : of_lattice;
    std::int32_t octave = 0, start = kFirstSamples;
    for (; start * 2 <= plan.samples && octave < kOctaves - 1; start *= 2) ++octave;
    double share = table[octave];
    if (octave < kOctaves - 1) share += (table[octave + 1] - share) * (double(plan.samples - start) / start);
    // Rays between unpolished mirrors go on at random, one for each: a third of the variance is theirs.
    return plan.mirror_count > 1 ? (1 + 2 * share) / 3 : share;
}

template <class Work>
void for_rows(const LinearImage& image, const Rect& tile, const Work& work) {
    for (std::int32_t y = 0; y < tile.height; ++y) {
        work(image.row(tile.top + y) + 3 * tile.left, 3 * y * kTileSide);
    }
}

/// From the new pass in the image and the mean before to the mean of both; `share`: the new pass's weight in it.
void mix(const LinearImage& image, const Rect& tile, const float* before, double share) {
    for_rows(image, tile, [&](float* row, std::int32_t first) {
        for (std::int32_t i = 0; i < 3 * tile.width; ++i) {
            const double mean = before[first + i];
            row[i] = float(mean + share * (double(row[i]) - mean));
        }
    });
}

/// Adds the variance of the new pass's share to what is left of the old ones'.
double mix_variance(const PlanHead& plan, const Accumulator& accumulator, const Rect& tile, const TileSpread& spread,
                    double share, bool first) {
    const double of_new = share * share * share_of_parts(plan), of_old = (1 - share) * (1 - share);
    float columns[kTileSide] = {};  // sums that do not wait for one another
    for (std::int32_t y = 0; y < tile.height; ++y) {
        for (std::int32_t x = 0; x < kTileSide; ++x) columns[x] += spread.variance[y * kTileSide + x];
        if (accumulator.variance == nullptr) continue;
        float* row = accumulator.variance + (std::ptrdiff_t{tile.top + y} * plan.width + tile.left);
        for (std::int32_t x = 0; x < tile.width; ++x) {
            const double fresh = of_new * double(spread.variance[y * kTileSide + x]);
            row[x] = float(first ? fresh : of_old * double(row[x]) + fresh);
        }
    }
    double sum = 0;
    for (const float column : columns) sum += double(column);
    return of_new * sum;
}

/// The new pass's weight in the mean of all, which it counts for from now on.
double take_in(const PlanHead& plan, TileProgress& tile, std::uint64_t lobe_samples, bool told_by_passes) {
    const double weight = weight_of(plan.samples, gain_of(plan, told_by_passes));
    const double share = weight / (tile.weight + weight);
    if (tile.passes == 0) tile.hits = double(lobe_samples) / plan.samples;
    tile.weight += weight;
    tile.samples += plan.samples;
    ++tile.passes;
    tile.next = 0;
    return share;
}

/// Mixes the new pass in and adds to `deviations`, and to each pixel's variance, what it brings to the weighted sum of
/// the squares of all passes' deviations from their mean (West, "Updating mean and variance estimates", CACM 22(9),
/// 1979).
double mix_replica(const PlanHead& plan, const Accumulator& accumulator, const Rect& tile, const float* before,
                   const TileProgress& progress, double share) {
    const double passes = progress.passes, weight = progress.weight, old_weight = (1 - share) * weight;
    // From a pixel's variance to its deviations and back.
    const double of_old = (passes - 2) * old_weight, of_new = 1 / ((passes - 1) * weight);
    double sum = 0;
    for (std::int32_t y = 0; y < tile.height; ++y) {
        float* row = accumulator.picture.row(tile.top + y) + 3 * tile.left;
        const float* means = before + 3 * y * kTileSide;
        const std::ptrdiff_t first = std::ptrdiff_t{tile.top + y} * plan.width + tile.left;
        for (std::int32_t x = 0; x < tile.width; ++x) {
            double squares = 0;
            for (std::int32_t i = 3 * x; i < 3 * x + 3; ++i) {
                const double mean = means[i], off = double(row[i]) - mean;
                squares += off * off;
                row[i] = float(mean + share * off);
            }
            const double fresh = old_weight * share * squares;
            sum += fresh;
            if (accumulator.variance == nullptr) continue;
            float& variance = accumulator.variance[first + x];
            variance = float((of_old * double(variance) + fresh) * of_new);
        }
    }
    return sum;
}

}  // namespace

bool parts_tell_error(const PlanHead& plan) {
    const Estimator rule = plan.sampling.estimator;
    const bool unlike_its_table = rule == Estimator::r2 && (plan.features & kFeatureGgx) != 0;
    return rule != Estimator::jittered && rule != Estimator::sobol && !unlike_its_table;
}

void keep_tile(const PlanHead& plan, const Accumulator& accumulator, int tile, TileBefore& before) {
    if (accumulator.tiles[tile].passes == 0) return;
    const Rect rect = tile_at(plan, tile);
    for_rows(accumulator.picture, rect, [&](const float* row, std::int32_t first) {
        for (std::int32_t i = 0; i < 3 * rect.width; ++i) before.values[first + i] = row[i];
    });
}

void mix_tile(const PlanHead& plan, const Accumulator& accumulator, int tile, const TileBefore& before,
              const TileSpread& spread, std::uint64_t lobe_samples) {
    const IeeeMode ieee;
    const Rect rect = tile_at(plan, tile);
    TileProgress& progress = accumulator.tiles[tile];
    const double share = take_in(plan, progress, lobe_samples, false);
    const bool first = progress.passes == 1;
    if (first && progress.hits == 0) return;
    if (!first) mix(accumulator.picture, rect, before.values, share);
    const double fresh = mix_variance(plan, accumulator, rect, spread, share, first);
    progress.variance = (1 - share) * (1 - share) * progress.variance + fresh;
}

void mix_tile(const PlanHead& plan, const Accumulator& accumulator, int tile, const TileBefore& before,
              std::uint64_t lobe_samples) {
    const IeeeMode ieee;
    TileProgress& progress = accumulator.tiles[tile];
    const double share = take_in(plan, progress, lobe_samples, true);
    if (progress.hits == 0) return;
    if (progress.passes > 1) {
        progress.deviations += mix_replica(plan, accumulator, tile_at(plan, tile), before.values, progress, share);
    }
    if (progress.passes < kReplicas) {
        progress.variance = kInfinity;
        progress.next = plan.samples;
    } else {
        progress.variance = progress.deviations / ((progress.passes - 1) * progress.weight);
    }
}

double estimated_error(const PlanHead& plan, const Accumulator& accumulator) {
    const IeeeMode ieee;
    double variance = 0;
    const int count = tile_count(plan);
    for (int i = 0; i < count; ++i) {
        if (accumulator.tiles[i].passes == 0) return kInfinity;
        variance += accumulator.tiles[i].variance;
    }
    return square_root(variance / values_of(plan));
}

double estimated_error(const PlanHead& plan, const Accumulator& accumulator, int tile) {
    const IeeeMode ieee;
    const TileProgress& progress = accumulator.tiles[tile];
    const Rect rect = tile_at(plan, tile);
    if (progress.passes == 0) return kInfinity;
    return square_root(progress.variance / (3.0 * rect.width * rect.height));
}

}  // namespace zerkalo
