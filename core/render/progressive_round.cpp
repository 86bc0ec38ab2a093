// Which tile gets how many samples in the next round.
#include "core/render/progressive.hpp"

#include "core/numeric/float_mode.hpp"
#include "core/numeric/setup.hpp"
#include "core/render/progressive_weight.hpp"

namespace zerkalo {
namespace {

constexpr double kOwnShare = 7.0 / 8;  // of a tile's variance in what it is planned by; the rest is the average tile's
constexpr double kStride = 4;          // from worth to worth, until the one looked for is passed
constexpr int kStrides = 64;           // at most
constexpr int kBisections = 4;         // of a stride, by its logarithm

/// The samples of each step.
struct Ladder {
    std::int32_t samples[kLadderSteps];
};
constexpr Ladder kLadder = [] {
    Ladder ladder{};
    for (int step = 0; step < kLadderSteps; ++step) ladder.samples[step] = samples_of_step(step);
    return ladder;
}();

/// What tiles are planned by.
struct Outlook {
    double weights[kLadderSteps];
    int gain;
    double price_of_tile;    // of a pass before its first lobe ray, in lobe rays
    double variance_of_hit;  // of one mirror hit with one unit of weight, on average
};

/// The variance of a tile with one unit of weight, drawn a little to the average.
double unit_variance(const Outlook& outlook, const TileProgress& tile) {
    return kOwnShare * (tile.variance * tile.weight) + (1 - kOwnShare) * (tile.hits * outlook.variance_of_hit);
}

bool may_get_more(const TileProgress& tile) { return tile.hits > 0 && tile.samples < kMostSamples; }

/// x^(g / (g + 1)) for g = 1, and for g = 1.5, where the power of 3/5 is made of square roots, as 5/8.
double pace_of(double x, int gain) {
    const double root = square_root(x);
    return gain == 8 ? root : root * square_root(square_root(root));
}

/// Also sets every tile's pace: with V = u / weight and weight = samples^g a unit of variance that is worth m lobe rays
/// buys each tile the weight (m g u / hits)^(g / (g + 1)).
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
    outlook.gain = gain_of(plan, told_by_passes);
    outlook.price_of_tile = kTilePixels * (rays_are_dear(plan) || told_by_passes ? kPriceOfGeneral : kPriceOfOneBounce);
    outlook.price_of_tile *= plan.antialias;
    for (int step = 0; step < kLadderSteps; ++step) {
        outlook.weights[step] = weight_of(kLadder.samples[step], outlook.gain);
    }
    outlook.variance_of_hit = hits > 0 ? variance / hits : 0;
    for (int i = 0; i < count; ++i) {
        TileProgress& tile = accumulator.tiles[i];
        tile.next = 0;
        tile.pace = may_get_more(tile) ? pace_of(unit_variance(outlook, tile) / tile.hits, outlook.gain) : 0;
    }
    return outlook;
}

/// A tile's next pass: its step of the ladder, -1 if there is none, and its variance then.
struct Choice {
    int step;
    double variance;
};

/// What it should get where a unit of variance is worth so many lobe rays. `speed`: what its pace is to be taken times.
Choice choice_for(const Outlook& outlook, const TileProgress& tile, double worth, double speed) {
    Choice choice{-1, tile.variance};
    const double wanted = tile.pace * speed - tile.weight;
    if (tile.pace == 0 || wanted <= 0) return choice;
    const double most = kLargestStep * double(tile.samples);
    int step = 0;
    while (step + 1 < kLadderSteps && outlook.weights[step] < wanted && kLadder.samples[step + 1] <= most) ++step;
    // The nearer of two: what one tile gets too little another one gets too much.
    if (step > 0 && wanted < (outlook.weights[step - 1] + outlook.weights[step]) / 2) --step;
    const double unit = unit_variance(outlook, tile), then = unit / (tile.weight + outlook.weights[step]);
    const double price = outlook.price_of_tile + tile.hits * kLadder.samples[step];
    // What it brings has to be worth more than it costs.
    if (worth * (unit / tile.weight - then) < price) return choice;
    return {step, then < tile.variance ? then : tile.variance};
}

/// What a round would come to.
struct Forecast {
    double variance = 0, lobe_samples = 0;
};

double speed_of(const Outlook& outlook, double worth) { return pace_of(worth * (outlook.gain / 8.0), outlook.gain); }

Forecast forecast(const PlanHead& plan, const Accumulator& accumulator, const Outlook& outlook, double worth) {
    Forecast sum;
    const double speed = speed_of(outlook, worth);
    const int count = tile_count(plan);
    for (int i = 0; i < count; ++i) {
        const TileProgress& tile = accumulator.tiles[i];
        if (tile.hits == 0) continue;
        const Choice choice = choice_for(outlook, tile, worth, speed);
        sum.variance += choice.variance;
        if (choice.step >= 0) sum.lobe_samples += tile.hits * kLadder.samples[choice.step];
    }
    return sum;
}

/// The least worth whose round is `enough`, found from `start` on; the greatest there is where none is.
template <class Enough>
double least_worth(double start, const Enough& enough) {
    double low = start, high = start;
    if (enough(start)) {
        for (int i = 0; i < kStrides && enough(low /= kStride); ++i) high = low;
    } else {
        for (int i = 0; i < kStrides && !enough(high *= kStride); ++i) low = high;
    }
    for (int i = 0; i < kBisections; ++i) {
        const double middle = square_root(low) * square_root(high);
        (enough(middle) ? high : low) = middle;
    }
    return high;
}

/// Gives the passes of the least worth that is `enough`, or of the greatest; false if these are none.
template <class Enough>
bool give_passes(const PlanHead& plan, const Accumulator& accumulator, const Enough& enough) {
    const Outlook outlook = outlook_of(plan, accumulator);
    const int count = tile_count(plan);
    // As if all that is known had been bought at one worth: not far from what is looked for.
    double variance = 0, price = 0;
    for (int i = 0; i < count; ++i) {
        const TileProgress& tile = accumulator.tiles[i];
        if (tile.pace == 0) continue;
        variance += tile.variance;
        price += outlook.price_of_tile + tile.hits * double(tile.samples);
    }
    if (variance == 0) return false;
    const double worth = least_worth(price / variance, [&](double each) {
        return enough(forecast(plan, accumulator, outlook, each));
    });
    const double speed = speed_of(outlook, worth);
    bool any = false;
    for (int i = 0; i < count; ++i) {
        TileProgress& tile = accumulator.tiles[i];
        const int step = choice_for(outlook, tile, worth, speed).step;
        tile.next = step < 0 ? 0 : samples_of_step(step);
        any = any || step >= 0;
    }
    return any;
}

}  // namespace

bool plan_round(const PlanHead& plan, const Accumulator& accumulator, double error) {
    const IeeeMode ieee;
    const double variance = variance_for(plan, error);
    return give_passes(plan, accumulator, [&](const Forecast& then) { return then.variance <= variance; });
}

bool plan_round_of(const PlanHead& plan, const Accumulator& accumulator, double lobe_samples) {
    const IeeeMode ieee;
    return give_passes(plan, accumulator, [&](const Forecast& then) { return then.lobe_samples >= lobe_samples; });
}

}  // namespace zerkalo
