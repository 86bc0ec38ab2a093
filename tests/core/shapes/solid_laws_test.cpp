// Laws that hold for every solid: Cavalieri's volume, Cauchy's shadow, and that a convex solid never shadows itself.
#include "tests/core/support/meshes.hpp"
#include "tests/core/support/solids.hpp"
#include "tests/core/support/widths.hpp"

namespace zerkalo::test {
namespace {


class SolidLaws : public Widths {};

struct SolidSubject {
    const char* name;
    Solid solid;
    std::vector<Triangle> triangles;
    Real80 volume, surface;
};

/// Base and lateral area of a regular polygon's prism or pyramid with circumradius r.
struct PolygonMeasures {
    Real80 area, side, apothem;
};
PolygonMeasures polygon(int sides, Real80 r) {
    const Real80 half = kPi80 / sides;
    return {sides * r * r * std::sin(half) * std::cos(half), 2 * r * std::sin(half), r * std::cos(half)};
}

SolidSubject polyhedron(const char* name, SolidKind kind, int sides, Real80 r, Real80 h, Random& random) {
    SolidSubject subject{name, placed(kind, random), {}, 0, 0};
    subject.solid.sides = sides, subject.solid.radius = double(r), subject.solid.height = double(h);
    const PolygonMeasures base = polygon(sides, r);
    const bool prism = kind == SolidKind::prism;
    subject.volume = base.area * h / (prism ? 1 : 3);
    subject.surface =
        prism ? 2 * base.area + sides * base.side * h : base.area + sides * base.side * std::hypot(base.apothem, h) / 2;
    return subject;
}

SolidSubject tube(const char* name, SolidKind kind, Real80 r, Real80 h, Real80 taper, Random& random) {
    SolidSubject subject{name, placed(kind, random), {}, 0, 0};
    subject.solid.radius = double(r), subject.solid.height = double(h), subject.solid.taper = double(taper);
    const Real80 top = r * taper;
    subject.volume = kPi80 * h * (r * r + r * top + top * top) / 3;
    subject.surface = kPi80 * (r * r + top * top + (r + top) * std::hypot(h, r - top));
    return subject;
}

/// All six kinds, with closed forms for volume and surface.
std::vector<SolidSubject> subjects(Random& random) {
    std::vector<SolidSubject> all;
    all.push_back(polyhedron("pyramid", SolidKind::pyramid, 5, 1, 1.5L, random));
    all.push_back(polyhedron("prism", SolidKind::prism, 6, 0.8L, 1.2L, random));
    SolidSubject ball{"sphere", placed(SolidKind::sphere, random), {}, kPi80 * 4 / 3, 4 * kPi80};
    all.push_back(ball);
    all.push_back(tube("cylinder", SolidKind::cylinder, 0.7L, 1.6L, 1, random));
    all.push_back(tube("cone", SolidKind::cone, 1, 1.5L, 0, random));
    all.push_back(tube("widening cone", SolidKind::cone, 0.5L, 1, 1.75L, random));
    SolidSubject mesh = polyhedron("mesh", SolidKind::prism, 7, 0.9L, 1, random);
    mesh.triangles = triangles_of(mesh.solid);
    mesh.solid = meshed(mesh.solid, mesh.triangles);
    all.push_back(mesh);
    return all;
}

/// Parallel rays along d on a square grid of side * side that covers the solid, and the grid cell's area.
struct Grid {
    RayList rays;
    Real80 cell;
};
Grid grid_of(const Plan& plan, const Exact3& d, int side) {
    const Exact3 across = unit(cross(d, std::abs(d.x) < 0.5 ? Exact3{1, 0, 0} : Exact3{0, 1, 0}));
    const Exact3 beside = cross(d, across);
    const Real80 size = size_of(plan), step = 2 * size / side;
    Grid grid{{}, step * step};
    for (int i = 0; i < side * side; ++i) {
        const Real80 u = (i % side + 0.5L) * step - size, v = (i / side + 0.5L) * step - size;
        grid.rays.add(centre_of(plan) - d * (3 * size) + across * u + beside * v, d);
    }
    grid.rays.pad();
    return grid;
}

constexpr int kGridSide = kLawRays >= 100000 ? 320 : 96;

Real80 volume_by_chords(const probes::ShapeProbes& shapes, const Plan& plan, const Exact3& d) {
    const Grid grid = grid_of(plan, d, kGridSide);
    const SpanList spans = spans_of(shapes, plan, grid.rays);
    Real80 sum = 0;
    for (std::size_t k = 0; k < kGridSide * std::size_t{kGridSide}; ++k) {
        if (spans.entry[k] < spans.exit[k]) sum += Real80(spans.exit[k]) - spans.entry[k];
    }
    return sum * grid.cell;
}

// A midpoint rule over a shadow with a kinked rim: its error falls like the cell's width to the power 3/2.
const Real80 kGridError = 8 * std::pow(Real80(kGridSide), -1.5L);

TEST_P(SolidLaws, ChordLengthsSumToVolume) {
    Random random(71);
    for (const SolidSubject& subject : subjects(random)) {
        const auto plan = plan_of(subject.solid, subject.triangles);
        const Real80 volume = volume_by_chords(shapes(), *plan, random.direction());
        EXPECT_NEAR(double(volume / subject.volume), 1, double(kGridError)) << subject.name;
    }
}

TEST_P(SolidLaws, ConeFillsAThirdOfItsCylinderAndAPyramidAThirdOfItsPrism) {
    Random random(72);
    const SolidKind pairs[][2] = {{SolidKind::cone, SolidKind::cylinder}, {SolidKind::pyramid, SolidKind::prism}};
    for (const auto& pair : pairs) {
        Solid pointed = placed(pair[0], random), straight = pointed;
        straight.kind = pair[1], straight.taper = 1;
        const Exact3 d = random.direction();
        const Real80 part = volume_by_chords(shapes(), *plan_of(pointed), d);
        const Real80 whole = volume_by_chords(shapes(), *plan_of(straight), d);
        EXPECT_NEAR(double(part / whole), 1.0 / 3, double(kGridError))
            << (pair[0] == SolidKind::cone ? "cone" : "pyramid");
    }
}

// Lines through random points of a disc, at right angles to it, in random directions: the mean shadow is hits / lines.
TEST_P(SolidLaws, MeanShadowIsAQuarterOfTheSurface) {
    Random random(73);
    for (const SolidSubject& subject : subjects(random)) {
        const auto plan = plan_of(subject.solid, subject.triangles);
        const Real80 size = size_of(*plan);
        RayList rays;
        while (rays.size() < kLawRays) {
            const Exact3 d = random.direction();
            const Exact3 across = unit(cross(d, std::abs(d.x) < 0.5 ? Exact3{1, 0, 0} : Exact3{0, 1, 0}));
            const Real80 rho = size * std::sqrt(random.uniform(0, 1)), around = random.uniform(0, 2 * double(kPi80));
            const Exact3 foot = across * (rho * std::cos(around)) + cross(d, across) * (rho * std::sin(around));
            rays.add(centre_of(*plan) + foot - d * (3 * size), d);
        }
        const SpanList spans = spans_of(shapes(), *plan, rays);
        Real80 hits = 0;
        for (std::size_t k = 0; k < rays.size(); ++k) hits += spans.entry[k] < spans.exit[k];
        const Real80 share = hits / rays.size();
        // Five standard deviations of a share of so many lines.
        const Real80 room = 5 * std::sqrt(share * (1 - share) / rays.size());
        const Real80 wanted = subject.surface / 4 / (kPi80 * size * size);
        EXPECT_NEAR(double(share), double(wanted), double(room)) << subject.name;
    }
}

Exact3 outward_normal(const probes::ShapeProbes& shapes, const Plan& plan, const Exact3& p, float face) {
    const SolidPlan& solid = plan.solids[0];
    PointList at, n(probes::kWidest);
    while (at.size() < probes::kWidest) at.add(p);
    if (solid.shape == ShapeKind::sphere) {
        shapes.sphere_normal(solid.sphere, at, n.out(), at.count());
        return n[0];
    }
    if (solid.shape == ShapeKind::tube) {
        const std::vector<float> faces(at.size(), face);
        shapes.tube_normal(solid.tube, at, faces.data(), n.out(), at.count());
        const bool below = dot(p - exact(solid.tube.centre), exact(solid.tube.axis_y)) < 0;
        return face == 1 && below ? -n[0] : n[0];
    }
    const Slab& slab = plan.slabs[solid.half_spaces.first_slab + static_cast<int>(face)];
    const bool low = dot(exact(slab.n), p - exact(solid.half_spaces.centre)) < 0 && std::isfinite(slab.lo);
    return low ? -exact(slab.n) : exact(slab.n);
}

// From a hit, as float holds it, along any direction w that leaves the surface at more than 6 degrees: whatever span
// the solid answers with has ended, but for the hit's own roundings seen along w. Nothing of the solid lies ahead.
TEST_P(SolidLaws, OutgoingRayNeverMeetsItAgain) {
    Random random(74);
    constexpr Real80 kRoundings = 48, kLeastCosine = 0.1L;
    for (const SolidSubject& subject : subjects(random)) {
        if (!subject.triangles.empty()) continue;  // a mesh knows its own triangle instead: it need not be convex
        const auto plan = plan_of(subject.solid);
        RayList incoming, outgoing;
        while (incoming.size() < kLawRays / 8) add_ray_towards(incoming, *plan, random, 3);
        incoming.pad();
        const SpanList hits = spans_of(shapes(), *plan, incoming);
        std::vector<Real80> cosines;
        for (std::size_t k = 0; k < incoming.size(); ++k) {
            if (!(hits.entry[k] < hits.exit[k])) continue;
            const Exact3 p = exact(rounded_to_float(incoming.o[k] + incoming.d[k] * hits.entry[k]));
            const Exact3 n = outward_normal(shapes(), *plan, p, hits.face_in[k]);
            const Exact3 w = random.direction();
            const Real80 cosine = dot(w, n);
            if (std::abs(cosine) < kLeastCosine) continue;
            outgoing.add(p, cosine > 0 ? w : -w);
            cosines.push_back(std::abs(cosine));
        }
        ASSERT_GT(cosines.size(), kLawRays / 50) << subject.name;
        outgoing.pad();
        const SpanList spans = spans_of(shapes(), *plan, outgoing);
        for (std::size_t k = 0; k < cosines.size(); ++k) {
            if (!(spans.entry[k] < spans.exit[k])) continue;
            const Real80 room = kRoundings * kU * (4 * size_of(*plan) + length(outgoing.o[k])) / cosines[k];
            ASSERT_LE(spans.exit[k], room) << subject.name << ", " << text(outgoing, k);
        }
    }
}

// The prism lies in its cylinder and holds the cylinder of its apothem; with n sides they differ by r (1 - cos(pi/n)).
TEST_P(SolidLaws, PrismWithManySidesApproachesTheCylinder) {
    Random random(75);
    for (const int sides : {8, 16, 32, 64}) {
        Solid prism = placed(SolidKind::prism, random);
        prism.sides = sides;
        Solid cylinder = prism;
        cylinder.kind = SolidKind::cylinder;
        const auto prism_plan = plan_of(prism), cylinder_plan = plan_of(cylinder);
        RayList rays;
        while (rays.size() < kLawRays / 4) add_ray_towards(rays, *prism_plan, random, 3);
        rays.pad();
        Outcome outcome;
        const Real80 gap = 1 - std::cos(kPi80 / sides), roundings = 16 * kU * 4 * size_of(*prism_plan);
        const TubeData& round = cylinder_plan->solids[0].tube;
        TubeData within = round;
        within.mid_radius = float(prism.radius * (1 - double(gap)));
        const SpanList spans = spans_of(shapes(), *prism_plan, rays);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            const ExactSpan most = exact_span(round, rays.o[k], rays.d[k], roundings);
            const ExactSpan least = exact_span(within, rays.o[k], rays.d[k], -roundings);
            if (!least.empty()) {
                ASSERT_LE(spans.entry[k], least.entry + roundings) << text(rays, k) << " sides " << sides;
                ASSERT_GE(spans.exit[k], least.exit - roundings) << text(rays, k) << " sides " << sides;
                ++outcome.hits;
            }
            if (spans.entry[k] < spans.exit[k]) {
                ASSERT_GE(spans.entry[k], most.entry - roundings) << text(rays, k) << " sides " << sides;
                ASSERT_LE(spans.exit[k], most.exit + roundings) << text(rays, k) << " sides " << sides;
            }
        }
        EXPECT_GT(outcome.hits, rays.size() / 8);
    }
}

ZERKALO_OVER_ALL_WIDTHS(SolidLaws);

}  // namespace
}  // namespace zerkalo::test
