// Inversion of the lobe's distribution: P(cos a <= c) = c^(n+1), azimuth uniform.
#include "tests/support/reference_lobe.hpp"

#include <algorithm>
#include <numbers>

namespace zerkalo::reference {

std::vector<Vector> lobe_directions(const Vector& ideal, double exponent, unsigned count, Random& random) {
    const Vector side = normalized(cross(least_axis(ideal), ideal));
    const Vector other = cross(ideal, side);
    const auto rows = static_cast<unsigned>(std::sqrt(static_cast<double>(count)));
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<Vector> directions;
    for (unsigned i = 0; i < count; ++i) {
        double u = uniform(random), w = uniform(random);
        if (i < rows * rows) {
            u = (i / rows + u) / rows;
            w = (i % rows + w) / rows;
        }
        const double cosine = std::pow(u, 1 / (exponent + 1));
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        const double azimuth = 2 * std::numbers::pi * w;
        directions.push_back(sine * std::cos(azimuth) * side + sine * std::sin(azimuth) * other + cosine * ideal);
    }
    return directions;
}

}  // namespace zerkalo::reference
