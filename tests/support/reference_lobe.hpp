// Directions of the unpolished mirror's lobe, drawn at random: density (n+1)/(2 pi) cos^n a about the ideal direction.
#pragma once

#include "tests/support/reference_vector.hpp"

#include <random>
#include <vector>

namespace zerkalo::reference {

using Random = std::mt19937_64;

/// `count` unit vectors about the unit vector `ideal`, each distributed by the lobe of that exponent (finite, >= 0).
/// Stratified: the largest square number of them shares out the unit square, the rest is drawn freely.
std::vector<Vector> lobe_directions(const Vector& ideal, double exponent, unsigned count, Random& random);

}  // namespace zerkalo::reference
