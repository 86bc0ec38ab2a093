// Which tile gets how many samples in the next round.
#include "core/render/progressive.hpp"

#include "core/numeric/float_mode.hpp"
#include "core/numeric/setup.hpp"
#include "core/render/progressive_weight.hpp"

namespace zerkalo {
namespace {

constexpr double kOwnShare = 7.0 / 8;   // of a tile's variance in what it is planned by; the rest is the average tile's
constexpr double kWorthAPass = 2;       // a pass costs its camera rays: it has to make the weight so many times larger
constexpr double kLargestStep = 16;     // times the samples so far: an estimate from few samples must not decide all
constexpr double kMargin = 0.95;         // of the variance asked for: the next estimate is not exactly the expected one
constexpr int kBisections = 12;         // of a range of speeds, by their logarithm

/// The samples of each step.
struct Ladder {
    std::int32_t samples[kLadderSteps];
};
constexpr Ladder kLadder = [] {
    Ladder ladder{};
    for (int step = 0; step < kLadderSteps; ++step) ladder.samples[step] = samples_of_step(step);
    return ladder;
}();

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
    const int count = tile_count(plan);
    double variance = 0, hits = 0;
    bool told_by_passes = false;
    for (int i = 0; i < count; ++i) {
        const TileProgress& tile = accumulator.tiles[i];
        variance += tile.variance * tile.weight;
        hits += tile.hits;
        told_by_passes = told_by_passes || tile.deviations > 0;
    }
    const int gain = gain_of(plan, told_by_passes);
    for (int step = 0; step < kLadderSteps; ++step) outlook.weights[step] = weight_of(samples_of_step(step), gain);
    outlook.variance_of_hit = hits > 0 ? variance / hits : 0;
    const bool half = gain == 8;
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
           kLadder.samples[step + 1] <= most) {
        ++step;
    }
    // The nearer of two: what one tile gets too little another one gets too much.
    const double half_way = step > 0 ? (outlook.weights[step - 1] + outlook.weights[step]) / 2 : 0;
    return wanted - tile.weight < half_way ? step - 1 : step;
}

/// What a round at some speed would come to.
struct Forecast {
    double variance = 0, lobe_samples = 0;
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
        sum.lobe_samples += tile.hits * kLadder.samples[step];
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

}  // namespace

bool plan_round(const PlanHead& plan, const Accumulator& accumulator, double error) {
    const IeeeMode ieee;
    const double variance = kMargin * error * error * values_of(plan);
    return give_passes(plan, accumulator, [&](const Forecast& then) { return then.variance <= variance; });
}

bool plan_round_of(const PlanHead& plan, const Accumulator& accumulator, double lobe_samples) {
    const IeeeMode ieee;
    return give_passes(plan, accumulator, [&](const Forecast& then) { return then.lobe_samples >= lobe_samples; });
}

}  // namespace zerkalo
