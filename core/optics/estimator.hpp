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

constexpr std::int32_t kShareSteps = 512;  // places in one of the N shares of a lobe's energy

/// Of one frame. The mean over all rotations is the integral: an estimate of the error comes from a few of them.
struct Sampling {
    Estimator estimator;
    std::uint32_t turn;  // added to every azimuth: a turn is 2^32
    std::int32_t place;  // where in its share each even point lies, in steps: the middle, or any odd number
};

// A turn is 2^32: 1 over the golden ratio of it, and 1 over the plastic number p and p^2, p = 1.32471795724...
constexpr std::uint32_t kGoldenTurn = 0x9e3779b9u, kPlasticTurn = 0xc13fa9a9u, kPlasticTurn2 = 0x91e10da5u;

/// The lobe rays of one camera sample of a pixel: a lattice of their own, which with those of the others is one.
struct LatticePart {
    std::int32_t place[2];  // of every even and every odd point in its share of the lobe's energy, of 2^20
    std::uint32_t turn;     // in azimuth
};
constexpr int kPlaceBits = 20;

/// Of camera sample a of n: point s lies at s g + a h turns, h = (g + k) / n, and at (a + place) / n of its share. So
/// each part steps by g, the golden ratio, and all together, n points a share, by h, since n h is g and whole turns. Of
/// these h it is the nearest to 1 / p, which goes well with 1 and g, the steps of the camera's lattice over the pixel.
constexpr LatticePart lattice_part(const Sampling& sampling, std::uint32_t a, std::int32_t n) {
    const auto parts = static_cast<std::uint64_t>(n);
    const std::uint64_t whole_turns = (parts * kPlasticTurn - kGoldenTurn + (1ull << 31)) >> 32;
    const auto step = static_cast<std::uint32_t>(((whole_turns << 32) + kGoldenTurn) / parts);
    // Rotations also turn the parts round over the camera samples, or each would see its own piece of the shares alone.
    a = static_cast<std::uint32_t>((a + (std::uint64_t{sampling.turn * kPlasticTurn} * parts >> 32)) % parts);
    const auto place = [&](std::int32_t in_part) {
        const std::uint64_t steps = std::uint64_t{a} * kShareSteps + static_cast<std::uint64_t>(in_part);
        return static_cast<std::int32_t>(((steps << kPlaceBits) / kShareSteps + parts / 2) / parts);
    };
    return {{place(sampling.place), place(kShareSteps - sampling.place)}, a * step};
}

}  // namespace zerkalo
