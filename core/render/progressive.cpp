#include "core/render/progressive.hpp"

#include "core/numeric/float_mode.hpp"
#include "core/numeric/setup.hpp"

namespace zerkalo {
namespace {

/// How the error of a rule falls, measured over the shipped scenes (README.md): the variance as samples^-gain.
constexpr double gain_of(Estimator estimator) { return estimator == Estimator::random ? 1 : 1.5; }

/// What a pass counts for beside others: in proportion to the inverse of its expected variance.
double weight_of(const PlanHead& plan, double samples) {
    const double gain = gain_of(plan.sampling.estimator);
    return gain == 1 ? samples : samples * square_root(samples);
}

/// Variance of an average over its expectation from independent parts, by log2 of the samples from 4 on, linear
/// between: measured over the shipped scenes. The parts of a lattice lie so that together they are the better lattice.
constexpr double kLattice[] = {0.43, 0.44, 0.29, 0.17, 0.155, 0.20, 0.28, 0.31, 0.36, 0.33, 0.30};
constexpr double kR2[] = {0.50, 0.42, 0.42, 0.25, 0.13, 0.17, 0.23, 0.23, 0.23, 0.23, 0.23};
// Rays off normals that the viewer sees lie less evenly.
constexpr double kLatticeOfGgx[] = {0.62, 0.57, 0.46, 0.32, 0.24, 0.26, 0.34, 0.37, 0.43, 0.40, 0.36};
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
    double sum = 0;
    for (std::int32_t y = 0; y < tile.height; ++y) {
        const std::ptrdiff_t row = std::ptrdiff_t{tile.top + y} * plan.width + tile.left;
        for (std::int32_t x = 0; x < tile.width; ++x) {
            const double fresh = of_new * double(spread.variance[y * kTileSide + x]);
            sum += fresh;
            if (accumulator.variance == nullptr) continue;
            float& variance = accumulator.variance[row + x];
            variance = float(first ? fresh : of_old * double(variance) + fresh);
        }
    }
    return sum;
}

constexpr double kOwnShare = 7.0 / 8;   // of a tile's variance in what it is planned by; the rest is the average tile's
constexpr double kWorthAPass = 2;       // a pass costs its camera rays: it has to make the weight so many times larger
constexpr double kLargestStep = 16;     // times the samples so far: an estimate from few samples must not decide all
constexpr double kMargin = 0.95;         // of the variance asked for: the next estimate is not exactly the expected one
constexpr int kBisections = 12;         // of a range of speeds, by their logarithm

/// What a round is planned by.
struct Outlook {
    double weights[kLadderSteps];
    double variance_of_hit;  // of one mirror hit with one unit of weight, on average
    double slowest, fastest;  // speeds at which the first tile and every tile gets a pass, the latter the largest one
};

/// The variance of a tile with one unit of weight, drawn a little to the average.
double unit_variance(const Outlook& outlook, const TileProgress& tile) {
    return kOwnShare * (tile.variance * tile.weight) + (1 - kOwnShare) * (tile.hits * outlook.variance_of_hit);
}

bool may_get_more(const TileProgress& tile) { return tile.hits > 0 && tile.samples < kMostSamples; }

/// Also sets every tile's pace: with V = u / weight and weight = samples^g, the sum of V falls fastest for its rays
/// where the tiles' weights are as (u / hits)^(g / (g + 1)). The power of 3/5 is made of square roots, as 5/8.
Outlook outlook_of(const PlanHead& plan, const Accumulator& accumulator) {
    Outlook outlook{};
    for (int step = 0; step < kLadderSteps; ++step) outlook.weights[step] = weight_of(plan, samples_of_step(step));
    const int count = tile_count(plan);
    double variance = 0, hits = 0;
    for (int i = 0; i < count; ++i) {
        const TileProgress& tile = accumulator.tiles[i];
        variance += tile.variance * tile.weight;
        hits += tile.hits;
    }
    outlook.variance_of_hit = hits > 0 ? variance / hits : 0;
    const bool half = gain_of(plan.sampling.estimator) == 1;
    const double largest = outlook.weights[kLadderSteps - 1];
    outlook.slowest = kInfinity, outlook.fastest = 0;
    for (int i = 0; i < count; ++i) {
        TileProgress& tile = accumulator.tiles[i];
        tile.next = 0;
        const double each = may_get_more(tile) ? unit_variance(outlook, tile) / tile.hits : 0;
        const double root = square_root(each);
        tile.pace = half ? root : root * square_root(square_root(square_root(each)));
        if (tile.pace == 0) continue;
        const double first = kWorthAPass * tile.weight / tile.pace;
        const double last = (kWorthAPass * tile.weight + largest) / tile.pace;
        outlook.slowest = first < outlook.slowest ? first : outlook.slowest;
        outlook.fastest = last > outlook.fastest ? last : outlook.fastest;
    }
    return outlook;
}

/// The ladder's step that brings a tile to the weight pace * speed; -1 where that is not worth a pass.
int step_for(const Outlook& outlook, const TileProgress& tile, double speed) {
    const double wanted = tile.pace * speed;
    if (tile.pace == 0 || wanted < kWorthAPass * tile.weight) return -1;
    const double most = kLargestStep * double(tile.samples);
    int step = 0;
    while (step + 1 < kLadderSteps && outlook.weights[step] < wanted - tile.weight &&
           samples_of_step(step + 1) <= most) {
        ++step;
    }
    // The nearer of two: what one tile gets too little another one gets too much.
    const double half_way = step > 0 ? (outlook.weights[step - 1] + outlook.weights[step]) / 2 : 0;
    return wanted - tile.weight < half_way ? step - 1 : step;
}

/// What a round at some speed would come to.
struct Forecast {
    double variance = 0, lobe_rays = 0;
};

Forecast forecast(const PlanHead& plan, const Accumulator& accumulator, const Outlook& outlook, double speed) {
    Forecast sum;
    const int count = tile_count(plan);
    for (int i = 0; i < count; ++i) {
        const TileProgress& tile = accumulator.tiles[i];
        const int step = step_for(outlook, tile, speed);
        if (step < 0) {
            sum.variance += tile.variance;
            continue;
        }
        const double then = unit_variance(outlook, tile) / (tile.weight + outlook.weights[step]);
        sum.variance += then < tile.variance ? then : tile.variance;
        sum.lobe_rays += tile.hits * samples_of_step(step);
    }
    return sum;
}

/// Gives the passes of the slowest speed that is `enough`, or of the fastest there is; false if these are none.
template <class Enough>
bool give_passes(const PlanHead& plan, const Accumulator& accumulator, const Enough& enough) {
    const Outlook outlook = outlook_of(plan, accumulator);
    if (outlook.fastest == 0) return false;
    double slow = outlook.slowest, fast = outlook.fastest;
    for (int i = 0; i < kBisections; ++i) {
        const double middle = square_root(slow) * square_root(fast);
        (enough(forecast(plan, accumulator, outlook, middle)) ? fast : slow) = middle;
    }
    bool any = false;
    const int count = tile_count(plan);
    for (int i = 0; i < count; ++i) {
        TileProgress& tile = accumulator.tiles[i];
        const int step = step_for(outlook, tile, fast);
        tile.next = step < 0 ? 0 : samples_of_step(step);
        any = any || step >= 0;
    }
    return any;
}

/// Pixels times channels.
double values_of(const PlanHead& plan) { return 3.0 * plan.width * plan.height; }

}  // namespace

bool can_tell_error(Estimator estimator) {
    return estimator != Estimator::jittered && estimator != Estimator::sobol;
}

std::int32_t samples_of_step(int step) {
    // 4, 8, 12, 16, 24, 32, 48, ...: from 8 on every step but the last of an octave is half of the octave.
    if (step == 0) return kFirstSamples;
    const std::int32_t octave = (2 * kFirstSamples) << ((step - 1) / 2);
    return step % 2 == 1 ? octave : octave + octave / 2;
}

void keep_tile(const PlanHead& plan, const Accumulator& accumulator, int tile, TilePass& pass) {
    if (accumulator.tiles[tile].passes == 0) return;
    const Rect rect = tile_at(plan, tile);
    for_rows(accumulator.picture, rect, [&](const float* row, std::int32_t first) {
        for (std::int32_t i = 0; i < 3 * rect.width; ++i) pass.before[first + i] = row[i];
    });
}

void mix_tile(const PlanHead& plan, const Accumulator& accumulator, int tile, const TilePass& pass,
              std::uint64_t lobe_rays) {
    const IeeeMode ieee;
    const Rect rect = tile_at(plan, tile);
    TileProgress& progress = accumulator.tiles[tile];
    const bool first = progress.passes == 0;
    const double weight = weight_of(plan, plan.samples);
    const double share = weight / (progress.weight + weight);
    progress.weight += weight;
    progress.samples += plan.samples;
    ++progress.passes;
    progress.next = 0;
    if (first) {
        progress.hits = double(lobe_rays) / plan.samples;
        if (progress.hits == 0) return;
    } else {
        mix(accumulator.picture, rect, pass.before, share);
    }
    const double fresh = mix_variance(plan, accumulator, rect, pass.spread, share, first);
    progress.variance = (1 - share) * (1 - share) * progress.variance + fresh;
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

bool plan_round(const PlanHead& plan, const Accumulator& accumulator, double error) {
    const IeeeMode ieee;
    const double variance = kMargin * error * error * values_of(plan);
    return give_passes(plan, accumulator, [&](const Forecast& then) { return then.variance <= variance; });
}

bool plan_round_of(const PlanHead& plan, const Accumulator& accumulator, double lobe_rays) {
    const IeeeMode ieee;
    return give_passes(plan, accumulator, [&](const Forecast& then) { return then.lobe_rays >= lobe_rays; });
}

}  // namespace zerkalo
