// Prisms and pyramids with 3 to 64 sides against their closed form; no ray slips through an edge or a vertex.
#include "tests/core/support/solids.hpp"
#include "tests/core/support/widths.hpp"

namespace zerkalo::test {
namespace {

// Subtraction of the centre, two three-term dot products, one quotient.
constexpr Real80 kSlabRoundings = 8;

class HalfSpaces : public Widths {};

Solid polyhedron(SolidKind kind, int sides, Random& random) {
    Solid solid = placed(kind, random);
    solid.sides = sides;
    solid.radius = random.uniform(0.2, 2), solid.height = random.uniform(0.2, 3);
    return solid;
}

constexpr SolidKind kKinds[] = {SolidKind::prism, SolidKind::pyramid};
constexpr std::size_t kShapes = 2 * (kMaxSides - kMinSides + 1);

/// Calls visit(solid) for every number of sides of both kinds.
template <class F>
void for_each_polyhedron(Random& random, F visit) {
    for (const SolidKind kind : kKinds) {
        for (int sides = kMinSides; sides <= kMaxSides; ++sides) visit(polyhedron(kind, sides, random));
    }
}

TEST_P(HalfSpaces, SpanIsTheClosedFormToAFewRoundings) {
    Random random(31);
    Outcome outcome;
    for_each_polyhedron(random, [&](const Solid& solid) {
        const auto plan = plan_of(solid);
        RayList rays;
        while (rays.size() < kLawRays / kShapes) {
            add_ray_towards(rays, *plan, random, std::exp2(random.uniform(-3, 5)));
        }
        rays.pad();
        expect_exact_spans(shapes(), *plan, rays, kSlabRoundings, outcome);
    });
    EXPECT_GT(outcome.hits, kLawRays / 8);
    EXPECT_GT(outcome.misses, kLawRays / 8);
}

TEST_P(HalfSpaces, FarOriginLosesNoHit) {
    Random random(32);
    Outcome outcome;
    for_each_polyhedron(random, [&](const Solid& solid) {
        const auto plan = plan_of(solid);
        RayList rays;
        while (rays.size() < kLawRays / kShapes) add_ray_towards(rays, *plan, random, 1e3);
        rays.pad();
        expect_exact_spans(shapes(), *plan, rays, kSlabRoundings, outcome);
    });
    EXPECT_GT(outcome.hits, kLawRays / 8);
}

/// Corner `k` of the base, and of the top (a pyramid's apex): in world coordinates, before any rounding.
struct Corners {
    Exact3 base, top;
};
Corners corners(const Solid& solid, const Plan& plan, int k) {
    // The axes as the plan's slabs have them: the last slab's normal is the solid's own axis.
    const HalfSpacesData& body = plan.solids[0].half_spaces;
    const Exact3 up = exact(plan.slabs[body.first_slab + body.slab_count - 1].n);
    const Exact3 first = exact(plan.slabs[body.first_slab].n);
    const Exact3 out = unit(first - up * dot(first, up)), beside = cross(out, up);
    // The first face's middle is half a step from corner 0.
    const Real80 step = 2 * kPi80 / solid.sides, angle = (k - 0.5L) * step;
    const Exact3 rim = (out * std::cos(angle) + beside * std::sin(angle)) * solid.radius;
    const Exact3 middle = exact(body.centre), half = up * (Real80(solid.height) / 2);
    const bool prism = solid.kind == SolidKind::prism;
    return {middle - half + rim, prism ? middle + half + rim : middle + half};
}

/// How deep the middle of the solid lies below its nearest face.
Real80 depth_of_middle(const Plan& plan) {
    const HalfSpacesData& body = plan.solids[0].half_spaces;
    Real80 depth = kFar80;
    for (int s = body.first_slab; s < body.first_slab + body.slab_count; ++s) {
        depth = std::min({depth, Real80(plan.slabs[s].hi), -Real80(plan.slabs[s].lo)});
    }
    return depth;
}

// From outside at edges, vertices and the diagonals of the sides (where a triangle mesh would be cut): the target lies
// deeper inside than the roundings reach, so the ray must hit, and before its target.
TEST_P(HalfSpaces, RaysAtEdgesAndVerticesNeverLeak) {
    Random random(33);
    std::size_t aimed = 0;
    for_each_polyhedron(random, [&](const Solid& solid) {
        const auto plan = plan_of(solid);
        const Exact3 centre = exact(plan->solids[0].half_spaces.centre);
        const Real80 depth_of_centre = depth_of_middle(*plan);
        RayList rays;
        std::vector<Real80> depth;
        while (rays.size() < kLawRays / kShapes) {
            const int k = random.below(solid.sides);
            const Corners here = corners(solid, *plan, k), next = corners(solid, *plan, k + 1);
            const Exact3 ends[][2] = {{here.base, next.base}, {here.top, next.top},   {here.base, here.top},
                                      {here.base, next.top},  {here.base, here.base}, {here.top, here.top}};
            const auto& edge = ends[random.below(6)];
            const Exact3 on_edge = edge[0] + (edge[1] - edge[0]) * random.uniform(0, 1);
            const Real80 distance = random.uniform(2.1, 9) * size_of(*plan);
            const Exact3 from = exact(rounded_to_float(centre + random.direction() * distance));
            // Far enough inwards that the solid shrunk by all roundings still holds the target.
            const Real80 room = 2 * kSlabRoundings * kU * (length(from - centre) + size_of(*plan));
            const Exact3 target = on_edge + (centre - on_edge) * (room / depth_of_centre);
            rays.add(from, unit(target - from));
            depth.push_back(length(target - from) + room);
        }
        const std::size_t count = rays.size();
        rays.pad();
        const SpanList spans = spans_of(shapes(), *plan, rays);
        for (std::size_t k = 0; k < count; ++k) {
            ASSERT_LT(spans.entry[k], spans.exit[k]) << text(rays, k) << " leaks, sides " << solid.sides;
            ASSERT_LE(spans.entry[k], depth[k]) << text(rays, k) << " enters late, sides " << solid.sides;
            ++aimed;
        }
    });
    EXPECT_GT(aimed, kLawRays * 9 / 10);
}

TEST_P(HalfSpaces, EntryFaceIsTheOneThatTheRayMeets) {
    Random random(34);
    for_each_polyhedron(random, [&](const Solid& solid) {
        const auto plan = plan_of(solid);
        const HalfSpacesData& body = plan->solids[0].half_spaces;
        RayList rays;
        while (rays.size() < kLawRays / kShapes) add_ray_towards(rays, *plan, random, 3);
        rays.pad();
        const SpanList spans = spans_of(shapes(), *plan, rays);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            if (!(spans.entry[k] < spans.exit[k])) continue;
            const auto off_face = [&](float t, float face) {
                const Slab& slab = plan->slabs[body.first_slab + static_cast<int>(face)];
                const Real80 along = dot(exact(slab.n), rays.o[k] + rays.d[k] * t - exact(body.centre));
                return std::min(std::abs(along - slab.hi), std::abs(along - slab.lo));
            };
            const Real80 room = 2 * kSlabRoundings * kU * (length(rays.o[k] - centre_of(*plan)) + size_of(*plan));
            ASSERT_LE(off_face(spans.entry[k], spans.face_in[k]), room) << text(rays, k);
            ASSERT_LE(off_face(spans.exit[k], spans.face_out[k]), room) << text(rays, k);
        }
    });
}

TEST_P(HalfSpaces, WhatIsNotAskedForDoesNotChangeTheSpan) {
    Random random(35);
    const auto plan = plan_of(polyhedron(SolidKind::prism, 5, random));
    RayList rays;
    while (rays.size() < kLawRays) add_ray_towards(rays, *plan, random, 3);
    SpanList both(rays.size()), entry(rays.size()), none(rays.size());
    const HalfSpacesData& body = plan->solids[0].half_spaces;
    shapes().half_spaces(plan->slabs, body, Faces::both, rays, both);
    shapes().half_spaces(plan->slabs, body, Faces::entry, rays, entry);
    shapes().half_spaces(plan->slabs, body, Faces::none, rays, none);
    for (const SpanList* other : {&entry, &none}) {
        expect_same_bits(both.entry, other->entry, "entry");
        expect_same_bits(both.exit, other->exit, "exit");
    }
    expect_same_bits(both.face_in, entry.face_in, "face of entry");
}

// Two cubes of edge 2 upon each other: a ray in the plane between them belongs to the lower one alone.
TEST_P(HalfSpaces, RayInTheSharedPlaneMeetsOneOfTwoStackedSolids) {
    Solid cube;
    cube.kind = SolidKind::prism;
    cube.radius = std::sqrt(2.0), cube.height = 2;
    RayList rays;
    rays.add({4, 2, 0.25}, {-1, 0, 0});
    rays.add({-4, 2, 0.25}, {1, -0.0L, 0});
    rays.pad();
    int hits = 0;
    for (const double base : {0.0, 2.0}) {
        cube.position = {0, base, 0};
        const auto plan = plan_of(cube);
        const SpanList spans = spans_of(shapes(), *plan, rays);
        for (std::size_t k = 0; k < 2; ++k) {
            const bool hit = spans.entry[k] < spans.exit[k];
            EXPECT_EQ(hit, base == 0) << text(rays, k);
            hits += hit;
        }
    }
    EXPECT_EQ(hits, 2);
}

// Through the edge of a cube both faces are entered at the same t, to the bit: the first of the list is named, whichever
// of the two it is.
TEST_P(HalfSpaces, RayThroughAnEdgeIsNamedAfterTheFirstFace) {
    Solid cube;
    cube.kind = SolidKind::prism;
    cube.radius = std::sqrt(2.0), cube.height = 2;
    cube.rotation = {0, 3.14159265358979323846 / 4, 0};
    const auto plan = plan_of(cube);
    const HalfSpacesData& body = plan->solids[0].half_spaces;
    const float root = std::sqrt(0.5f);
    RayList rays;
    for (const float side : {-1.0f, 1.0f}) rays.add({4 * side, 1, 4 * side}, {-root * side, 0, -root * side});
    rays.pad();
    for (int order = 0; order < 2; ++order) {
        const SpanList spans = spans_of(shapes(), *plan, rays);
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_LT(spans.entry[k], spans.exit[k]) << text(rays, k);
            EXPECT_EQ(spans.face_in[k], 0) << text(rays, k) << " order " << order;
            EXPECT_EQ(spans.face_out[k], 0) << text(rays, k) << " order " << order;
        }
        // The other way round: if it were no tie, the other face would be named now.
        std::swap(plan->slabs[body.first_slab], plan->slabs[body.first_slab + 1]);
        std::swap(plan->slabs[body.first_slab].index, plan->slabs[body.first_slab + 1].index);
    }
}

TEST_P(HalfSpaces, EveryWidthGivesTheSameBits) {
    Random random(36);
    for_each_polyhedron(random, [&](const Solid& solid) {
        const auto plan = plan_of(solid);
        RayList rays;
        while (rays.size() < kLawRays / kShapes) add_ray_towards(rays, *plan, random, random.uniform(0, 4));
        rays.pad();
        const SpanList here = spans_of(shapes(), *plan, rays), there = spans_of(scalar().shapes, *plan, rays);
        expect_same_bits(here.entry, there.entry, "entry");
        expect_same_bits(here.exit, there.exit, "exit");
        expect_same_bits(here.face_in, there.face_in, "face in");
        expect_same_bits(here.face_out, there.face_out, "face out");
    });
}

ZERKALO_OVER_ALL_WIDTHS(HalfSpaces);

}  // namespace
}  // namespace zerkalo::test
