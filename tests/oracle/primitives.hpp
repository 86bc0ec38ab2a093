// One random instance of a primitive after another: how the lanes are asked about it, and how its closed form judges.
#pragma once

#include "tests/core/support/solids.hpp"
#include "tests/oracle/tally.hpp"

#include <functional>
#include <memory>
#include <ostream>

namespace zerkalo::test {

/// The lanes' answers to a list of rays. Surfaces have one end, `entry`, and a hit is an `exit` that is not below it.
using Answers = SpanList;

/// A point of a ball somewhat larger than a primitive of size 1, from its centre.
inline Exact3 ball_aim(Random& random) { return random.direction() * (1.3L * std::cbrt(random.uniform(0, 1))); }

/// A primitive with all its constants fixed.
struct Instance {
    Exact3 centre;
    Real80 size = 1;  // no point of it is farther from the centre
    std::function<Exact3(Random&)> aim = ball_aim;  // a point at which a ray may go, from the centre, in sizes
    std::function<Answers(const probes::ShapeProbes&, const RayList&)> ask;
    std::function<void(Tally&, const RayList&, const Answers&, std::size_t, Real80 rounding)> judge;
};

struct Primitive {
    const char* name;
    Instance (*next)(Random& random);
    Real80 recentred_ulps = 4;  // of t times the cosine of incidence, of rays that start nearest to the centre
};
/// How GoogleTest prints the parameter.
inline void PrintTo(const Primitive& primitive, std::ostream* out) { *out << primitive.name; }

/// Sphere, cylinder, cone, frustum, prism, pyramid, plane mirror, curved mirror, triangle.
const std::vector<Primitive>& primitives();

/// Every second ray starts where it is nearest to the centre, so that its t is the recentred one.
inline bool is_recentred(std::size_t k) { return k % 2 == 0; }

/// Rays at one instance; those that are not recentred come from up to 2^10 sizes away.
void fill_rays(RayList& rays, const Instance& instance, std::size_t count, Random& random);

}  // namespace zerkalo::test
