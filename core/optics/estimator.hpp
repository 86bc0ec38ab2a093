// How the lobe rays of an unpolished mirror are placed: by which rule, and which of its equally good placements.
#pragma once

#include <cstdint>

namespace zerkalo {

/// The rules by their names on the command line; what each does: optics/README.md.
enum class Estimator : std::uint8_t { random, jittered, sobol, r2, fibonacci, fibonacci_coverage };
constexpr int kEstimatorCount = 6;
constexpr const char* kEstimatorNames[kEstimatorCount] = {"random", "jittered", "sobol",
                                                          "r2",     "fibonacci", "fibonacci+coverage"};
constexpr const char* name_of(Estimator estimator) { return kEstimatorNames[static_cast<int>(estimator)]; }

/// Rules that give each tile points of its own (optics/point_sets.hpp); the others turn one lattice.
constexpr bool is_keyed(Estimator estimator) { return estimator < Estimator::fibonacci; }

constexpr std::int32_t kShareSteps = 512;  // places in one of N equal shares of a lobe's energy

/// Of one frame. The mean over all rotations is the integral: an estimate of the error comes from a few of them.
struct Sampling {
    Estimator estimator;
    std::uint32_t turn;  // added to every azimuth: a turn is 2^32
    std::int32_t place;  // where in its share each point lies, in steps: the middle, or any odd number
};

/// The smallest share u of a lobe's energy that lies farther out than one of its rays.
constexpr double least_share(const Sampling& sampling, std::int32_t samples) {
    return is_keyed(sampling.estimator) ? 0x1p-24 : double(sampling.place) / kShareSteps / samples;
}

}  // namespace zerkalo
