// P17: light goes both ways. The lobe of the unpolished mirror as a reflectance f(a, b), out of the core's own parts.
#include "tests/core/support/random.hpp"
#include "tests/core/support/rays.hpp"
#include "tests/core/support/widths.hpp"

namespace zerkalo::test {
namespace {

/// Pairs of directions above the horizon of random normals.
struct Pairs {
    PointList a, b, n;
};
Pairs random_pairs(Random& random, Real80 exponent) {
    const auto above = [](const Exact3& d, const Exact3& n) { return dot(d, n) < 0 ? -d : d; };
    Pairs pairs;
    while (pairs.a.size() < kLawRays) {
        const Exact3 n = random.direction(), a = above(random.direction(), n);
        // Every other b near the mirror direction of a, where a narrow lobe is.
        const Exact3 mirrored = n * (2 * dot(n, a)) - a;
        const Exact3 near = unit(mirrored + random.direction() * (1 / std::sqrt(exponent + 1)));
        pairs.a.add(a), pairs.n.add(n), pairs.b.add(above(random.below(2) == 0 ? random.direction() : near, n));
    }
    return pairs;
}

class P17 : public Widths {
protected:
    /// f(in, out) = (n + 1) / (2 pi) cos^n(angle of `in` to the mirror direction of `out`) weight / cos_in; weight: the
    /// lobe's, or 1 for the seed's lobe.
    static std::vector<Real80> reflectance(const PointList& in, const PointList& out, const PointList& n,
                                           float exponent, bool max_phong) {
        const std::size_t count = in.size();
        PointList axis(count);
        optics().mirror_direction(out, n, axis.out(), static_cast<int>(count));
        Floats x, powers(count), weight(1);
        for (std::size_t k = 0; k < count; ++k) {
            const Exact3 chord = axis[k] - in[k];
            x.push_back(float(dot(chord, chord) / 2));
        }
        const Floats exponents(count, exponent);
        lanes().power(x.data(), exponents.data(), powers.data(), static_cast<int>(count));
        std::vector<Real80> f;
        Floats cosines(probes::kWidest), weights(probes::kWidest, 1);
        for (std::size_t k = 0; k < count; ++k) {
            const Real80 cos_in = dot(in[k], n[k]), cos_out = dot(out[k], n[k]);
            if (max_phong) {
                cosines.assign(probes::kWidest, float(cos_in));
                optics().weight(cosines.data(), float(1 / cos_out), weights.data(), probes::kWidest);
            }
            const Real80 density = x[k] < 1 ? (exponent + 1) / (2 * kPi80) * powers[k] : 0;
            f.push_back(density * weights[0] / cos_in);
        }
        return f;
    }
    // Roundings of the weight and of the power; of its base, which the power multiplies by n / cos.
    static constexpr Real80 kOfWeightAndPower = 24, kOfCosine = 8;

    struct Outcome {
        std::size_t asked = 0, unequal = 0;
    };
    /// How many pairs see another reflectance when light goes the other way.
    static Outcome both_ways(float exponent, bool max_phong) {
        Random random(171 + static_cast<unsigned>(exponent));
        const Pairs pairs = random_pairs(random, exponent);
        const auto there = reflectance(pairs.a, pairs.b, pairs.n, exponent, max_phong);
        const auto back = reflectance(pairs.b, pairs.a, pairs.n, exponent, max_phong);
        Outcome outcome;
        for (std::size_t k = 0; k < there.size(); ++k) {
            const Exact3 a = pairs.a[k], b = pairs.b[k], n = pairs.n[k];
            const Real80 n_dot_a = dot(a, n), n_dot_b = dot(b, n), cosine = 2 * n_dot_a * n_dot_b - dot(a, b);
            const Real80 larger = std::max(there[k], back[k]);
            // Next to nothing is left where the pair is a right angle off the mirror direction, or along the mirror.
            if (cosine < 1e-2L || larger < 1e-9L || std::min(n_dot_a, n_dot_b) < 1e-3L) continue;
            ++outcome.asked;
            const Real80 room = (kOfWeightAndPower + kOfCosine * exponent / cosine) * kU;
            outcome.unequal += std::abs(there[k] - back[k]) > room * larger;
        }
        return outcome;
    }
};

constexpr float kLobeExponents[] = {0, 1, 20, 1000};

TEST_P(P17, MaxPhongReflectsAlikeBothWays) {
    for (const float exponent : kLobeExponents) {
        const Outcome outcome = both_ways(exponent, true);
        EXPECT_EQ(outcome.unequal, 0u) << "of " << outcome.asked << ", exponent " << exponent;
        EXPECT_GT(outcome.asked, kLawRays / 8) << "exponent " << exponent;
    }
}

TEST_P(P17, TheSeedsLobeDoesNot) {
    for (const float exponent : kLobeExponents) {
        const Outcome outcome = both_ways(exponent, false);
        // Only where both directions happen to be equally steep.
        EXPECT_GT(double(outcome.unequal), 0.9 * double(outcome.asked)) << "exponent " << exponent;
    }
}

ZERKALO_OVER_ALL_WIDTHS(P17);

}  // namespace
}  // namespace zerkalo::test
