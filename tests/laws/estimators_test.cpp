// The rules that place lobe rays: each converges to the same integral, at the rate that it is known for.
#include "tests/laws/rules.hpp"
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace zerkalo::laws {
namespace {

constexpr double kWayToWall = 10;     // how far away the edge is
constexpr double kEdgeExponent = 60;  // of the lobe that sees it

/// The share of a lobe cos^n that lies beyond a great circle at that angle from its axis: at theta the share
/// acos(tan angle / tan theta) / pi of all azimuths does.
double share_beyond(double angle, double n) {
    constexpr int kSteps = 20000;
    double sum = 0;
    for (int k = 0; k < kSteps; ++k) {
        // The root in acos is smooth in the square root of theta - angle.
        const double span = std::sqrt(kPi / 2 - angle), s = (k + 0.5) / kSteps * span, theta = angle + s * s;
        const double density = (n + 1) * std::pow(std::cos(theta), n) * std::sin(theta);
        sum += density * std::acos(std::tan(angle) / std::tan(theta)) / kPi * 2 * s * span / kSteps;
    }
    return sum;
}

/// A mirror in z = 0 and a glowing wall, z >= 10 and x >= 0, which it blurs.
Scene wall_with_an_edge() {
    Scene scene;
    add(scene, box({200, -200, kWayToWall + 200}, 400, 400, glowing({1, 1, 1})));
    Mirror mirror = ideal_mirror({0, 0, 0}, {0, 0, 1}, 40);
    mirror.lobe = Lobe::phong;
    mirror.lobe_exponent = kEdgeExponent;
    add(scene, mirror);
    return scene;
}

/// Seen where the wall's edge lies `angle` off the lobe's axis: all of the lobe but what lies beyond it.
double at_an_edge(const Settings& settings, double angle) {
    return look(wall_with_an_edge(), {kWayToWall * std::tan(angle), 0, 5}, {0, 0, -1}, settings).g;
}
double exact_at_an_edge(double angle) { return 1 - share_beyond(angle, kEdgeExponent); }

/// A mirror overhead shows a floor that a lamp lights unevenly: the lobe sees no edge.
double on_a_smooth_field(const Settings& settings) {
    Scene scene;
    scene.ambient = {0, 0, 0};
    add(scene, box({0, -1, 0}, 256, 1, chalk()));
    add(scene, lamp({3, 4, 0}));
    Mirror mirror = ideal_mirror({0, 6, 0}, {0, -1, 0}, 1);
    mirror.up = {0, 0, 1};
    mirror.lobe = Lobe::phong;
    mirror.lobe_exponent = 100;
    add(scene, mirror);
    return look(scene, {0, 5, 0}, {0, 1, 0}, settings).g;
}

constexpr std::array<double, 4> kEdgeAngles = {0.013, 0.051, 0.094, 0.142};  // at lobes about 0.13 wide

double edge_error(Estimator rule, std::int32_t samples) {
    constexpr int kRotations = 16;
    double squares = 0;
    for (const double angle : kEdgeAngles) {
        const double exact = exact_at_an_edge(angle);
        for (int rotation = 1; rotation <= kRotations; ++rotation) {
            const double error = at_an_edge(placed_by(rule, samples, rotation), angle) - exact;
            squares += error * error / (kRotations * kEdgeAngles.size());
        }
    }
    return std::sqrt(squares);
}

double smooth_error(Estimator rule, std::int32_t samples, double exact) {
    constexpr int kRotations = 48;
    double squares = 0;
    for (int rotation = 1; rotation <= kRotations; ++rotation) {
        const double error = on_a_smooth_field(placed_by(rule, samples, rotation)) - exact;
        squares += error * error / kRotations;
    }
    return std::sqrt(squares);
}

/// The slope of log error over log samples by least squares, from 16 to 1024 samples: rules that step by an irrational
/// number have good and bad counts.
template <class Error>
double slope_of(const Error& error) {
    double sum = 0, squares = 0;
    for (int step = -6; step <= 6; ++step) {
        const double log2_samples = 7 + step / 2.0;
        sum += step / 2.0 * std::log2(error(static_cast<std::int32_t>(std::lround(std::exp2(log2_samples)))));
        squares += step / 2.0 * (step / 2.0);
    }
    return sum / squares;
}

struct Bounds {
    Estimator rule;
    double low, high;
};

// Known: -1/2 for Monte Carlo, about -3/4 where points are spread evenly.
TEST(Estimators, ConvergeAtAnEdgeAtTheirOwnRate) {
    constexpr Bounds kBounds[] = {{Estimator::random, -0.62, -0.38},
                                  {Estimator::jittered, -0.95, -0.62},
                                  {Estimator::sobol, -1.1, -0.62},
                                  {Estimator::r2, -1.1, -0.62},
                                  {Estimator::fibonacci, -1.1, -0.72}};
    for (const auto& [rule, low, high] : kBounds) {
        const double slope = slope_of([r = rule](std::int32_t samples) { return edge_error(r, samples); });
        RecordProperty(std::string("edge-") + name_of(rule), std::to_string(slope));
        EXPECT_GE(slope, low) << name_of(rule);
        EXPECT_LE(slope, high) << name_of(rule);
    }
}

// Known: -1/2, -1, about -5/4, -1; the lattice, whose shares shrink towards the rim, falls faster than all of them.
TEST(Estimators, ConvergeOnASmoothFieldAtTheirOwnRate) {
    constexpr Bounds kBounds[] = {{Estimator::random, -0.62, -0.38},
                                  {Estimator::jittered, -1.2, -0.8},
                                  {Estimator::sobol, -1.7, -1.0},
                                  {Estimator::r2, -1.2, -0.5},
                                  {Estimator::fibonacci, -2.1, -1.5}};
    constexpr int kMany = 64;
    double exact = 0;
    for (int rotation = 0; rotation < kMany; ++rotation) {
        exact += on_a_smooth_field(placed_by(Estimator::fibonacci, 2048, rotation)) / kMany;
    }
    for (const auto& [rule, low, high] : kBounds) {
        const double slope =
            slope_of([&, r = rule](std::int32_t samples) { return smooth_error(r, samples, exact); });
        RecordProperty(std::string("smooth-") + name_of(rule), std::to_string(slope));
        EXPECT_GE(slope, low) << name_of(rule);
        EXPECT_LE(slope, high) << name_of(rule);
    }
    for (const std::int32_t samples : {16, 1024}) {
        const double chance = smooth_error(Estimator::random, samples, exact);
        EXPECT_LE(smooth_error(Estimator::fibonacci, samples, exact), chance * (samples == 16 ? 0.2 : 0.005)) << samples;
    }
}

TEST(Estimators, HaveTheIntegralAsTheirMeanOverRotations) {
    constexpr int kRotations = 400;
    for (const Estimator rule : kRules) {
        for (const std::int32_t samples : {1, 3, 8}) {
            const double angle = kEdgeAngles[1], exact = exact_at_an_edge(angle);
            double sum = 0, squares = 0;
            for (int rotation = 1; rotation <= kRotations; ++rotation) {
                const double seen = at_an_edge(placed_by(rule, samples, rotation), angle);
                sum += seen, squares += seen * seen;
            }
            const double mean = sum / kRotations;
            const double deviation = std::sqrt((squares / kRotations - mean * mean) / kRotations);
            EXPECT_NEAR(mean, exact, 4 * deviation) << name_of(rule) << ", " << samples << " samples";
            EXPECT_GT(deviation, 0) << name_of(rule) << ": all rotations are alike";
        }
    }
}

// Pixels of a tile share their set, turned and moved: the errors of its four classes cancel so far that the mean of a
// tile is as good as that of as many independent pixels. Were the classes alike, the ratio would be 8.
TEST(Estimators, NoTileStandsOut) {
    constexpr int kSide = 8, kTiles = 12;
    Scene scene = wall_with_an_edge();
    scene.camera = camera_at({0.5, 0, 5}, {0, 0, -1}, 0.002);  // all pixels see the same
    for (const Estimator rule : kKeyed) {
        Settings settings = placed_by(rule, 16, 1);
        settings.width = settings.height = kSide * kTiles;
        const Image image = render(scene, settings);
        const double exact = exact_at_an_edge(std::atan(0.5 / kWayToWall));
        double of_pixels = 0, of_tiles = 0;
        for (int tile = 0; tile < kTiles * kTiles; ++tile) {
            double mean = 0;
            for (int pixel = 0; pixel < kSide * kSide; ++pixel) {
                const int x = tile % kTiles * kSide + pixel % kSide, y = tile / kTiles * kSide + pixel / kSide;
                const double error = image.at(x, y).g - exact;
                of_pixels += error * error, mean += error / (kSide * kSide);
            }
            of_tiles += mean * mean;
        }
        const double ratio = std::sqrt(of_tiles / (of_pixels / (kSide * kSide)));
        RecordProperty(std::string("tile-") + name_of(rule), std::to_string(ratio));
        EXPECT_LE(ratio, 1.5) << name_of(rule);
    }
}

}  // namespace
}  // namespace zerkalo::laws
