// Inversion of the lobes' distributions: P(cos a <= c) = c^(n+1), tan^2 of a microfacet's angle, azimuths uniform.
#include "tests/support/reference_lobe.hpp"

#include <algorithm>
#include <numbers>

namespace zerkalo::reference {
namespace {

struct SquarePoint {
    double u, w;
};

/// Point i of `count` in the unit square.
SquarePoint stratified(unsigned i, unsigned count, Random& random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto rows = static_cast<unsigned>(std::sqrt(static_cast<double>(count)));
    const double u = uniform(random), w = uniform(random);
    if (i >= rows * rows) return {u, w};
    return {(i / rows + u) / rows, (i % rows + w) / rows};
}

/// The axis turned by an angle of that cosine towards that azimuth.
Vector turned(const Vector& axis, double cosine, double azimuth) {
    const Vector side = normalized(cross(least_axis(axis), axis));
    const Vector other = cross(axis, side);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return sine * std::cos(azimuth) * side + sine * std::sin(azimuth) * other + cosine * axis;
}

double smith_lambda(double cosine, double alpha) {
    const double tangent2 = std::max(0.0, 1 / (cosine * cosine) - 1);
    return (std::sqrt(1 + alpha * alpha * tangent2) - 1) / 2;
}

}  // namespace

std::vector<Vector> lobe_directions(const Vector& ideal, double exponent, unsigned count, Random& random) {
    std::vector<Vector> directions;
    for (unsigned i = 0; i < count; ++i) {
        const auto [u, w] = stratified(i, count, random);
        directions.push_back(turned(ideal, std::pow(u, 1 / (exponent + 1)), 2 * std::numbers::pi * w));
    }
    return directions;
}

std::vector<WeightedDirection> ggx_directions(const Vector& normal, const Vector& viewer, double alpha, unsigned count,
                                              Random& random) {
    const double cos_view = dot(viewer, normal);
    std::vector<WeightedDirection> directions;
    for (unsigned i = 0; i < count; ++i) {
        const auto [u, w] = stratified(i, count, random);
        const double cosine = 1 / std::sqrt(1 + alpha * alpha * u / (1 - u));
        const Vector facet = turned(normal, cosine, 2 * std::numbers::pi * w);
        const double facing = dot(viewer, facet);
        const Vector light = 2 * facing * facet - viewer;
        const double cos_light = dot(light, normal);
        if (facing <= 0 || cos_light <= 0) {
            directions.push_back({normal, 0});
            continue;
        }
        const double unshadowed = 1 / (1 + smith_lambda(cos_view, alpha) + smith_lambda(cos_light, alpha));
        directions.push_back({light, unshadowed * facing / (cos_view * cosine)});
    }
    return directions;
}

}  // namespace zerkalo::reference
