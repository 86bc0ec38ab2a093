// What the rays of a lobe's lattice count for, in the words of its tests.
#pragma once

#include "core/optics/shares.hpp"
#include "tests/core/support/rays.hpp"

namespace zerkalo::test {

/// What ray s of n counts for, of the whole lobe.
inline Real80 share_of_ray(int s, int n) {
    const Real80 full = 1 / Real80(rays_in_all(Estimator::fibonacci, n));
    return s < rays_at_rim(Estimator::fibonacci, n) ? full * weight_at_rim<float>(s, n) : full;
}

}  // namespace zerkalo::test
