// Directions of the unpolished mirror's lobe, drawn at random: density (n+1)/(2 pi) cos^n a about the ideal direction.
#pragma once

#include "tests/support/reference_vector.hpp"

#include <random>
#include <vector>

namespace zerkalo::reference {

using Random = std::mt19937_64;

/// A direction that light comes from, and what it counts for.
struct WeightedDirection {
    Vector direction;
    double weight;
};

/// `count` directions of a rough mirror of GGX microfacets of width `alpha` in (0, 1], white Fresnel. `viewer` is unit,
/// above the mirror. Normals are drawn from D(m) cos m, all of them, seen or not: a way that the renderer does not take.
/// Source: Walter, Marschner, Li, Torrance, EGSR 2007, equations 33 to 36 and 41, with Smith's correlated G.
std::vector<WeightedDirection> ggx_directions(const Vector& normal, const Vector& viewer, double alpha, unsigned count,
                                              Random& random);

/// `count` unit vectors about the unit vector `ideal`, each distributed by the lobe of that exponent (finite, >= 0).
/// Stratified: the largest square number of them shares out the unit square, the rest is drawn freely.
std::vector<Vector> lobe_directions(const Vector& ideal, double exponent, unsigned count, Random& random);

}  // namespace zerkalo::reference
