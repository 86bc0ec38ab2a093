// Cylinder, cone and frustum against their closed form, in the ordinary and in every special position of a ray.
#include "tests/core/support/solids.hpp"
#include "tests/core/support/widths.hpp"

namespace zerkalo::test {
namespace {

// Rotation into the axes (three-term sums), recentring, the discriminant's two products, root and quotient.
constexpr Real80 kTubeRoundings = 24;

class Tube : public Widths {
protected:
    static SpanList spans_of_rays(const Plan& plan, const RayList& rays) { return spans_of(shapes(), plan, rays); }
};

Solid tube(double radius, double height, double taper) {
    Solid solid;
    solid.kind = SolidKind::cone;
    solid.radius = radius, solid.height = height, solid.taper = taper;
    return solid;
}

constexpr double kTapers[] = {1, 0, 0.5, 0.999, 2, 5};

TEST_P(Tube, SpanIsTheClosedFormToAFewRoundings) {
    Random random(21);
    Outcome outcome;
    for (const double taper : kTapers) {
        for (const double height : {0.1, 1.0, 10.0}) {
            Solid solid = placed(SolidKind::cone, random);
            solid.radius = random.uniform(0.2, 2), solid.height = height, solid.taper = taper;
            if (random.below(2) == 0) solid.rotation = {0, 0, 0};
            const auto plan = plan_of(solid);
            RayList rays;
            while (rays.size() < kLawRays / 16) {
                add_ray_towards(rays, *plan, random, std::exp2(random.uniform(-3, 4)));
            }
            rays.pad();
            expect_exact_spans(shapes(), *plan, rays, kTubeRoundings, outcome);
        }
    }
    EXPECT_GT(outcome.hits, kLawRays / 8);
    EXPECT_GT(outcome.misses, kLawRays / 8);
}

TEST_P(Tube, FacesSayWhichPieceBoundsTheSpan) {
    Random random(22);
    for (const double taper : kTapers) {
        const auto plan = plan_of(tube(1, 1.5, taper));
        const TubeData& data = plan->solids[0].tube;
        RayList rays;
        while (rays.size() < kLawRays / 16) add_ray_towards(rays, *plan, random, 3);
        rays.pad();
        const SpanList spans = spans_of_rays(*plan, rays);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            if (!(spans.entry[k] < spans.exit[k])) continue;
            const auto on_named_face = [&](float t, float face) {
                const Exact3 p = rays.o[k] + rays.d[k] * t - exact(data.centre);
                const Real80 from_axis = std::hypot(p.x, p.z), radius = data.mid_radius + Real80(data.slope) * p.y;
                const Real80 room = kTubeRoundings * kU * (1 + std::abs(data.slope)) * 4 * size_of(*plan);
                const Real80 off = face == 1 ? std::abs(p.y) - data.half_height : from_axis - radius;
                return std::abs(off) <= room;
            };
            ASSERT_TRUE(on_named_face(spans.entry[k], spans.face_in[k])) << text(rays, k) << " taper " << taper;
            ASSERT_TRUE(on_named_face(spans.exit[k], spans.face_out[k])) << text(rays, k) << " taper " << taper;
        }
    }
}

TEST_P(Tube, WhatIsNotAskedForDoesNotChangeTheSpan) {
    Random random(23);
    for (const double taper : {1.0, 0.0, 2.0}) {
        const auto plan = plan_of(tube(1, 1.5, taper));
        RayList rays;
        while (rays.size() < kLawRays / 4) add_ray_towards(rays, *plan, random, 3);
        rays.pad();
        SpanList both(rays.size()), entry(rays.size()), none(rays.size());
        shapes().tube(plan->solids[0].tube, Faces::both, rays, both);
        shapes().tube(plan->solids[0].tube, Faces::entry, rays, entry);
        shapes().tube(plan->solids[0].tube, Faces::none, rays, none);
        for (const SpanList* other : {&entry, &none}) {
            expect_same_bits(both.entry, other->entry, "entry");
            expect_same_bits(both.exit, other->exit, "exit");
        }
        expect_same_bits(both.face_in, entry.face_in, "face of entry");
    }
}

struct Special {
    const char* what;
    double taper;  // radius 1, height 2, base in y = 0
    Exact3 o, d;
    bool hit;
    float entry, exit;
};

// All values are exact in float: the answers must be too.
TEST_P(Tube, SpecialPositionsHaveExactAnswers) {
    const float root = std::sqrt(0.5f);
    const Special rows[] = {
        {"cylinder, along its axis", 1, {0, 5, 0}, {0, -1, 0}, true, 3, 5},
        {"cylinder, parallel to its axis inside", 1, {0.5, 5, 0.5}, {0, -1, 0}, true, 3, 5},
        {"cylinder, along a generator", 1, {1, 5, 0}, {0, -1, 0}, true, 3, 5},
        {"cylinder, parallel to its axis outside", 1, {1.5, 5, 0}, {0, -1, 0}, false, 0, 0},
        {"cylinder, across its middle", 1, {4, 1, 0}, {-1, 0, 0}, true, 3, 5},
        {"cylinder, in its top plane", 1, {4, 2, 0}, {-1, 0, 0}, true, 3, 5},
        {"cylinder, in its base plane (that of the solid below)", 1, {0, 0, -4}, {0, 0, 1}, false, 0, 0},
        {"cylinder, above its top plane", 1, {4, 2.25, 0}, {-1, 0, 0}, false, 0, 0},
        {"cylinder, tangent", 1, {4, 1, 1}, {-1, 0, 0}, false, 4, 4},
        {"cone, down its axis through the apex", 0, {0, 5, 0}, {0, -1, 0}, true, 3, 5},
        {"cone, up its axis", 0, {0, -3, 0}, {0, 1, 0}, true, 3, 5},
        {"cone, across its middle", 0, {4, 1, 0}, {-1, 0, 0}, true, 3.5, 4.5},
        {"cone, across above its apex", 0, {4, 2.5, 0}, {-1, 0, 0}, false, 0, 0},
        {"cone, steep beside its axis", 0, {0.5, -3, 0}, {0, 1, 0}, true, 3, 4},
        {"cone, in its base plane", 0, {4, 0, 0}, {-1, 0, 0}, false, 0, 0},
        {"widening tube, down its axis", 2, {0, 5, 0}, {0, -1, 0}, true, 3, 5},
        {"widening tube, steep outside its base", 2, {1.5, 5, 0}, {0, -1, 0}, true, 3, 4},
        {"widening tube, steep from below", 2, {1.5, -3, 0}, {0, 1, 0}, true, 4, 5},
        {"widening tube, across its middle", 2, {4, 1, 0}, {-1, 0, 0}, true, 2.5, 5.5},
        {"tube with slope 1, along a generator inside", 3, {0.5 - 1.5, -1.5, 0}, {root, root, 0}, true, 0, 0},
    };
    for (const Special& row : rows) {
        const auto plan = plan_of(tube(1, 2, row.taper));
        RayList rays;
        rays.add(row.o, row.d);
        rays.pad();
        const SpanList spans = spans_of_rays(*plan, rays);
        EXPECT_EQ(spans.entry[0] < spans.exit[0], row.hit)
            << row.what << ": " << spans.entry[0] << ".." << spans.exit[0];
        if (row.exit == 0) continue;
        EXPECT_EQ(spans.entry[0], row.entry) << row.what;
        EXPECT_EQ(spans.exit[0], row.exit) << row.what;
    }
}

// A = 0 or nearly so: the direction runs along a generator of the cone, through the solid or beside it.
TEST_P(Tube, RaysParallelToAGeneratorAreTheClosedForm) {
    Random random(24);
    Outcome outcome;
    for (const double taper : {0.0, 0.5, 2.0}) {
        const auto plan = plan_of(tube(1, 2, taper));
        const Real80 slope = plan->solids[0].tube.slope;
        RayList rays;
        while (rays.size() < kLawRays / 8) {
            const Real80 around = random.uniform(0, 6.3), tilt = std::exp2(random.uniform(-40, -4)) * random.below(2);
            const Exact3 d = unit({(slope + tilt) * std::cos(around), 1, (slope + tilt) * std::sin(around)});
            const Exact3 through = centre_of(*plan) + random.direction() * random.uniform(0, 1.2);
            rays.add(through - d * random.uniform(1, 8), random.below(2) == 0 ? d : -d);
        }
        rays.pad();
        expect_exact_spans(shapes(), *plan, rays, kTubeRoundings, outcome);
    }
    EXPECT_GT(outcome.hits, kLawRays / 16);
}

TEST_P(Tube, RaysThroughTheApexHit) {
    Random random(25);
    const auto plan = plan_of(tube(1, 2, 0));
    RayList rays;
    while (rays.size() < kLawRays) {
        // Down through the apex, inside the cone afterwards: at most half the opening angle off its axis.
        const Real80 around = random.uniform(0, 6.3), across = random.uniform(0, 0.45);
        const Exact3 d = unit({across * std::cos(around), -1, across * std::sin(around)});
        const Exact3 o = exact(rounded_to_float(Exact3{0, 2, 0} - d * random.uniform(0.5, 8)));
        rays.add(o, unit(Exact3{0, 2, 0} - o));
    }
    Outcome outcome;
    expect_exact_spans(shapes(), *plan, rays, kTubeRoundings, outcome);
    EXPECT_EQ(outcome.hits, kLawRays);
}

// The textbook b^2 - a c in float from where the ray starts, without recentring.
bool naive_lateral_hit(const TubeData& data, const Vec3<float>& from, const Vec3<float>& d) {
    const float m = data.mid_radius + data.slope * (from.y - data.centre.y), n = data.slope * d.y;
    const float x = from.x - data.centre.x, z = from.z - data.centre.z;
    const float a = d.x * d.x + d.z * d.z - n * n, b = x * d.x + z * d.z - m * n, c = x * x + z * z - m * m;
    return b * b - a * c >= 0;
}

TEST_P(Tube, FarOriginLosesNoHitWhereTheNaiveFormulaDoes) {
    Random random(26);
    for (const double taper : {1.0, 0.0}) {
        const auto plan = plan_of(tube(1, 2, taper));
        RayList rays;
        while (rays.size() < kLawRays / 2) add_ray_towards(rays, *plan, random, 1e3);
        rays.pad();
        Outcome outcome;
        expect_exact_spans(shapes(), *plan, rays, kTubeRoundings, outcome);
        std::size_t naive_losses = 0;
        for (std::size_t k = 0; k < rays.size(); ++k) {
            const Real80 room = kTubeRoundings * kU * 1e3L * size_of(*plan);
            const bool certain = !exact_span(*plan, rays.o[k], rays.d[k], -room).empty();
            naive_losses += certain && !naive_lateral_hit(plan->solids[0].tube, rounded_to_float(rays.o[k]),
                                                          rounded_to_float(rays.d[k]));
        }
        EXPECT_GT(naive_losses, outcome.hits / 1000) << "the naive twin must fail, or this case shows nothing";
    }
}

TEST_P(Tube, NormalsAreThoseOfTheClosedForm) {
    Random random(27);
    constexpr Real80 kNormalRoundings = 32;
    for (const double taper : {1.0, 0.5, 2.0}) {
        Solid solid = placed(SolidKind::cone, random);
        solid.taper = taper;
        const auto plan = plan_of(solid);
        const TubeData& data = plan->solids[0].tube;
        const Exact3 axis = exact(data.axis_y), across = exact(data.axis_x), beside = exact(data.axis_z);
        PointList p, n(kLawRays / 2);
        std::vector<float> face;
        std::vector<Exact3> wanted;
        while (p.size() < kLawRays / 2) {
            const Real80 y = random.uniform(-0.5, 0.5), around = random.uniform(0, 6.3);
            const Exact3 out = across * std::cos(around) + beside * std::sin(around);
            p.add(exact(data.centre) + axis * y + out * (data.mid_radius + data.slope * y));
            face.push_back(static_cast<float>(random.below(2)));
            wanted.push_back(face.back() == 1 ? axis : unit(out - axis * Real80(data.slope)));
        }
        shapes().tube_normal(data, p, face.data(), n.out(), p.count());
        for (std::size_t k = 0; k < p.size(); ++k) {
            ASSERT_LE(length(n[k] - wanted[k]), kNormalRoundings * kU / std::min(1.0, taper)) << text(p[k]);
        }
    }
}

TEST_P(Tube, NormalAtTheApexIsTheAxis) {
    const auto plan = plan_of(tube(1, 2, 0));
    PointList p, n(probes::kWidest);
    while (p.size() < probes::kWidest) p.add({0, 2, 0});
    const std::vector<float> lateral(p.size(), 0);
    shapes().tube_normal(plan->solids[0].tube, p, lateral.data(), n.out(), p.count());
    EXPECT_EQ(text(n[0]), text(Exact3{0, 1, 0}));
}

TEST_P(Tube, EveryWidthGivesTheSameBits) {
    Random random(28);
    for (const double taper : kTapers) {
        Solid solid = placed(SolidKind::cone, random);
        solid.taper = taper;
        const auto plan = plan_of(solid);
        RayList rays;
        while (rays.size() < kLawRays / 8) add_ray_towards(rays, *plan, random, random.uniform(0, 4));
        rays.pad();
        const SpanList here = spans_of(shapes(), *plan, rays), there = spans_of(scalar().shapes, *plan, rays);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            // Beyond a miss nothing is promised, so the ends of an empty span may differ.
            const bool hit = there.entry[k] < there.exit[k];
            ASSERT_EQ(here.entry[k] < here.exit[k], hit) << text(rays, k);
            if (!hit) continue;
            ASSERT_EQ(bits_of_float(here.entry[k]), bits_of_float(there.entry[k])) << text(rays, k);
            ASSERT_EQ(bits_of_float(here.exit[k]), bits_of_float(there.exit[k])) << text(rays, k);
            ASSERT_EQ(here.face_in[k], there.face_in[k]) << text(rays, k);
            ASSERT_EQ(here.face_out[k], there.face_out[k]) << text(rays, k);
        }
    }
}

ZERKALO_OVER_ALL_WIDTHS(Tube);

}  // namespace
}  // namespace zerkalo::test
