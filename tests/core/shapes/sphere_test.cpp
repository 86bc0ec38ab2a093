// The ball against its closed form: near, far, from inside, tangent; and what the naive formula would lose.
#include "tests/core/support/solids.hpp"
#include "tests/core/support/widths.hpp"

namespace zerkalo::test {
namespace {

// Subtraction of the centre, three-term dot products, square root, quotient; the direction's length is 1 to 3 u.
constexpr Real80 kSphereRoundings = 8;

class Sphere : public Widths {};

std::unique_ptr<Plan> random_ball(Random& random, double radius) {
    Solid solid = placed(SolidKind::sphere, random);
    solid.radius = radius;
    return plan_of(solid);
}

TEST_P(Sphere, SpanIsTheClosedFormToAFewRoundings) {
    Random random(11);
    Outcome outcome;
    for (const double radius : {1e-3, 0.3, 1.0, 50.0}) {
        const auto plan = random_ball(random, radius);
        RayList rays;
        while (rays.size() < kLawRays / 4) add_ray_towards(rays, *plan, random, std::exp2(random.uniform(0.2, 5)));
        rays.pad();
        expect_exact_spans(shapes(), *plan, rays, kSphereRoundings, outcome);
    }
    EXPECT_GT(outcome.hits, kLawRays / 4);
    EXPECT_GT(outcome.misses, kLawRays / 20);
}

TEST_P(Sphere, RaysFromInsideEnterBehindAndLeaveAhead) {
    Random random(12);
    const auto plan = random_ball(random, 1);
    RayList rays;
    while (rays.size() < kLawRays) {
        rays.add(centre_of(*plan) + random.direction() * (0.99 * std::cbrt(random.uniform(0, 1))), random.direction());
    }
    Outcome outcome;
    expect_exact_spans(shapes(), *plan, rays, kSphereRoundings, outcome);
    EXPECT_EQ(outcome.hits, kLawRays);
    const SpanList spans = spans_of(shapes(), *plan, rays);
    for (std::size_t k = 0; k < rays.size(); ++k) {
        ASSERT_LT(spans.entry[k], 0) << text(rays, k);
        ASSERT_GT(spans.exit[k], 0) << text(rays, k);
    }
}

/// The textbook discriminant b^2 - c in float, for a unit direction.
bool naive_hit(const SphereData& sphere, const Vec3<float>& o, const Vec3<float>& d) {
    const Vec3<float> f{o.x - sphere.centre.x, o.y - sphere.centre.y, o.z - sphere.centre.z};
    const float b = f.x * d.x + f.y * d.y + f.z * d.z;
    const float c = f.x * f.x + f.y * f.y + f.z * f.z - sphere.radius2;
    return b * b - c >= 0;
}

TEST_P(Sphere, FarOriginLosesNoHitWhereTheNaiveFormulaDoes) {
    Random random(13);
    const auto plan = random_ball(random, 1);
    RayList rays;
    while (rays.size() < kLawRays) add_ray_towards(rays, *plan, random, 1e3);
    Outcome outcome;
    expect_exact_spans(shapes(), *plan, rays, kSphereRoundings, outcome);
    std::size_t naive_losses = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const Real80 room = kSphereRoundings * kU * 1e3L;
        const bool certain = !exact_span(*plan, rays.o[k], rays.d[k], -room).empty();
        naive_losses +=
            certain && !naive_hit(plan->solids[0].sphere, rounded_to_float(rays.o[k]), rounded_to_float(rays.d[k]));
    }
    EXPECT_GT(naive_losses, outcome.hits / 1000) << "the naive twin must fail, or this case shows nothing";
}

TEST_P(Sphere, TangentRayTouchesForNoLength) {
    Solid solid;
    solid.kind = SolidKind::sphere;
    const auto plan = plan_of(solid);
    RayList rays;
    for (const Real80 side : {-1.0L, 1.0L}) {
        rays.add({side, 0, 4}, {0, 0, -1});
        rays.add({0, side, -2}, {0, 0, 1});
        rays.add({4, 0, side}, {-1, 0, 0});
        rays.add({std::nextafter(1.0f, 2.0f) * side, 0, 4}, {0, 0, -1});
    }
    rays.pad();
    const SpanList spans = spans_of(shapes(), *plan, rays);
    for (std::size_t k = 0; k < 8; ++k) {
        if (k % 4 == 3) {
            EXPECT_GT(spans.entry[k], spans.exit[k]) << text(rays, k) << " passes by one unit in the last place";
            continue;
        }
        EXPECT_EQ(spans.entry[k], k % 4 == 1 ? 2.0f : 4.0f) << text(rays, k);
        EXPECT_EQ(spans.exit[k], spans.entry[k]) << text(rays, k);
    }
}

TEST_P(Sphere, NormalIsTheRadiusDividedByItsLength) {
    Random random(14);
    constexpr Real80 kNormalRoundings = 8;
    for (const double radius : {0.25, 3.0}) {
        const auto plan = random_ball(random, radius);
        const SphereData& sphere = plan->solids[0].sphere;
        PointList p, n(kLawRays);
        while (p.size() < kLawRays) p.add(exact(sphere.centre) + random.direction() * radius);
        shapes().sphere_normal(sphere, p, n.out(), p.count());
        for (std::size_t k = 0; k < p.size(); ++k) {
            const Exact3 wanted = unit(p[k] - exact(sphere.centre));
            const Real80 size = 1 + length(p[k]) / radius;
            ASSERT_LE(length(n[k] - wanted), kNormalRoundings * kU * size) << text(p[k]);
        }
    }
}

TEST_P(Sphere, EveryWidthGivesTheSameBits) {
    Random random(15);
    const auto plan = random_ball(random, 0.7);
    RayList rays;
    while (rays.size() < kLawRays) add_ray_towards(rays, *plan, random, random.uniform(0, 4));
    const SpanList here = spans_of(shapes(), *plan, rays), there = spans_of(scalar().shapes, *plan, rays);
    expect_same_bits(here.entry, there.entry, "entry");
    expect_same_bits(here.exit, there.exit, "exit");
}

ZERKALO_OVER_ALL_WIDTHS(Sphere);

}  // namespace
}  // namespace zerkalo::test
