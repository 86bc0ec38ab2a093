// The mirror's templates over fixed point: planes, both signs of curvature, and chords within the own mirror.
#include "core/shapes/mirror_surface.hpp"
#include "tests/fixed/exact_mirror.hpp"

namespace zerkalo::test {
namespace {

constexpr int kGroups = 3000;

enum class Formula { plane, curved };

template <int W>
MirrorHit<FixedNumbers<W>> hit_of(Formula formula, const FixedMirror& m, const RayGroup& rays, int first) {
    using N = FixedNumbers<W>;
    const auto from = mirror_seen_from<N>(m, packed<W>(rays.o, first));
    const auto d = packed<W>(rays.d, first);
    if (formula == Formula::plane) return plane_mirror_hit<N>(m, from, d, Length<N>(0));
    return curved_mirror_hit<N>(m, from, in_mirror_axes(m, d), Length<N>(0));
}

/// Rays from anywhere to points on the surface, a third of them beyond the boundary.
RayGroup rays_to(const MirrorCase& m, Random& random) {
    RayGroup rays;
    for (int k = 0; k < kGroup; ++k) {
        const Exact3 from = point_in_box(random);
        const Real80 reach = 1.1L * m.size;
        const Real80 x = reach * random.uniform(-1, 1), y = reach * random.uniform(-1, 1);
        rays.aim(k, from, surface_point(m, x, y));
    }
    return rays;
}

void expect_closed_form(Formula formula, std::uint64_t seed) {
    Random random(seed);
    int met = 0, missed = 0;
    for (int g = 0; g < kGroups; ++g) {
        const MirrorCase m = random_mirror(random, formula == Formula::plane);
        const RayGroup rays = rays_to(m, random);
        for (int k = 0; k < kGroup; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const Exact3 o = in_frame(m.frame, real(rays.o[i]) - real(m.fixed.vertex));
            const ExactHit exact = exact_hit(m.fixed, o, in_frame(m.frame, rays.exact_d[i]));
            if (!exact.certain) continue;
            const auto hit = hit_of<1>(formula, m.fixed, rays, k);
            ASSERT_EQ(hit.hit, exact.hit) << "group " << g << " ray " << k;
            ++(exact.hit ? met : missed);
            if (!exact.hit) continue;
            ASSERT_NEAR(double(real(hit.t)), double(exact.t), double(kTolerance)) << "group " << g << " ray " << k;
            ASSERT_NEAR(double(real(hit.x)), double(exact.p.x), double(kTolerance)) << "group " << g << " ray " << k;
            ASSERT_NEAR(double(real(hit.y)), double(exact.p.y), double(kTolerance)) << "group " << g << " ray " << k;
            ASSERT_NEAR(double(real(hit.z)), double(exact.p.z), double(kTolerance)) << "group " << g << " ray " << k;
        }
    }
    EXPECT_GT(met, kGroups);
    EXPECT_GT(missed, kGroups);
}

TEST(FixedPlaneMirror, IsMetWhereTheClosedFormSays) { expect_closed_form(Formula::plane, 41); }
TEST(FixedCurvedMirror, IsMetWhereTheClosedFormSays) { expect_closed_form(Formula::curved, 42); }

template <class A, class B>
void expect_same_lane(const A& one, const B& wide, int k) {
    ASSERT_EQ(one.hit, lane_of(wide.hit, k));
    // Without a hit the rest is meaningless, and lanes that are all without one may stop early.
    if (!one.hit) return;
    ASSERT_EQ(one.t.raw, lane(wide.t, k).raw);
    ASSERT_EQ(one.x.raw, lane(wide.x, k).raw);
    ASSERT_EQ(one.y.raw, lane(wide.y, k).raw);
    ASSERT_EQ(one.z.raw, lane(wide.z, k).raw);
}

void expect_same_bits(Formula formula, std::uint64_t seed) {
    Random random(seed);
    for (int g = 0; g < kGroups; ++g) {
        SCOPED_TRACE(g);
        const MirrorCase m = random_mirror(random, formula == Formula::plane);
        const RayGroup rays = rays_to(m, random);
        const auto eight = hit_of<8>(formula, m.fixed, rays, 0);
        for (int k = 0; k < kGroup; ++k) {
            const auto one = hit_of<1>(formula, m.fixed, rays, k);
            expect_same_lane(one, eight, k);
            expect_same_lane(one, hit_of<4>(formula, m.fixed, rays, k / 4 * 4), k % 4);
        }
    }
}

TEST(FixedPlaneMirror, EveryWidthGivesTheSameBits) { expect_same_bits(Formula::plane, 43); }
TEST(FixedCurvedMirror, EveryWidthGivesTheSameBits) { expect_same_bits(Formula::curved, 44); }

TEST(FixedCurvedMirror, InALookingGlassIsMetAtTheSamePlace) {
    Random random(45);
    for (int g = 0; g < kGroups; ++g) {
        const MirrorCase m = random_mirror(random, false);
        const RayGroup rays = rays_to(m, random);
        RayGroup back = rays;
        for (std::size_t k = 0; k < kGroup; ++k) {
            back.o[k] = flipped(rays.o[k]);
            back.d[k] = flipped(rays.d[k]);
        }
        // Turned about its own axis by half a turn as well, both coordinates change sign.
        FixedMirror turned = m.fixed;
        turned.right = -m.fixed.right;
        turned.v = -m.fixed.v;
        for (FixedHalfPlane& edge : turned.boundary.edges) edge = {-edge.nx, -edge.ny, edge.c};
        for (int k = 0; k < kGroup; ++k) {
            const auto hit = hit_of<1>(Formula::curved, m.fixed, rays, k);
            const auto image = hit_of<1>(Formula::curved, flipped(m.fixed), back, k);
            const auto half = hit_of<1>(Formula::curved, turned, rays, k);
            SCOPED_TRACE(testing::Message() << "group " << g << " ray " << k);
            expect_same_lane(hit, image, 0);
            ASSERT_EQ(hit.hit, half.hit);
            if (!hit.hit) continue;
            ASSERT_EQ(hit.t.raw, half.t.raw);
            ASSERT_EQ(hit.x.raw, (-half.x).raw);
            ASSERT_EQ(hit.y.raw, (-half.y).raw);
        }
    }
}

TEST(FixedCurvedMirror, OwnChordEndsAtTheSecondPointOfTheSurface) {
    using N = FixedNumbers<1>;
    Random random(46);
    int compared = 0;
    for (int i = 0; i < 40000; ++i) {
        MirrorCase m = random_mirror(random, false);
        if (m.fixed.kappa < Curvature<One>(0)) m.fixed.kappa = -m.fixed.kappa;
        const Real80 reach = 0.35L * m.size;  // every boundary holds the square of this reach
        const Exact3 from = surface_point(m, reach * random.uniform(-1, 1), reach * random.uniform(-1, 1));
        const Exact3 to = surface_point(m, reach * random.uniform(-1, 1), reach * random.uniform(-1, 1));
        const Exact3 local = in_frame(m.frame, to - from), d = unit(local);
        const Exact3 p = in_frame(m.frame, from - real(m.fixed.vertex));
        const Real80 kappa = real(m.fixed.kappa);
        if (std::abs(kappa * dot(p, d) - d.z) < kLeastCosine) continue;
        const auto hit = own_chord_hit<N>(m.fixed, nearest<Len>(p), nearest<Dir>(d), Len(0));
        ASSERT_TRUE(hit.hit) << i;
        ASSERT_NEAR(double(real(hit.t)), double(length(local)), double(kTolerance)) << i;
        ++compared;
    }
    EXPECT_GT(compared, 2000);
}

TEST(FixedCurvedMirror, OfAThousandMillionTimesItsSizeStillBendsByItsSteps) {
    using N = FixedNumbers<1>;
    const ExactFrame axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Real80 kappa : {1e-9L, -1e-9L, 2e-8L}) {
        const FixedMirror mirror = fixed_mirror({0, 0, 0}, axes, kappa, fixed_rectangle(15, 15));
        for (int k = 0; k <= 64; ++k) {
            const Real80 x = k / 8.0L;
            const Vec3<Len> o = nearest<Len>(Exact3{x, 0, 1});
            const auto hit = curved_mirror_hit<N>(mirror, o, nearest<Dir>(Exact3{0, 0, -1}), Len(0));
            ASSERT_TRUE(hit.hit) << double(x);
            // 1 - kappa x^2 / 2: 4 steps of 7.5e-9 at the far end of 1e-9.
            const Real80 steps = std::ldexp(1 - kappa * x * x / 2, Len::kFraction);
            EXPECT_NEAR(double(hit.t.raw), double(steps), 1) << double(kappa) << " at " << double(x);
        }
    }
}

TEST(FixedCurvedMirror, APlaneNeverMeetsItself) {
    using N = FixedNumbers<1>;
    const ExactFrame axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const FixedMirror plane = fixed_mirror({0, 0, 0}, axes, 0, fixed_rectangle(15, 15));
    Random random(47);
    for (int i = 0; i < 10000; ++i) {
        const auto p = nearest<Len>(Exact3{random.uniform(-4, 4), random.uniform(-4, 4), 0});
        ASSERT_FALSE(own_chord_hit<N>(plane, p, nearest<Dir>(random.direction()), Len(0)).hit) << i;
    }
}

TEST(FixedPlaneMirror, IsNotMetAlongItsPlaneOrBeyondTheRange) {
    using N = FixedNumbers<1>;
    const ExactFrame axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const FixedMirror plane = fixed_mirror({0, 0, 0}, axes, 0, fixed_rectangle(15, 15));
    const Vec3<Len> o = {Len(-8), Len(0), Len(1)};
    // At the end of the range the first ray is above x = 8 and the second above x = 7.9: inside the boundary.
    for (const Exact3& d : {Exact3{1, 0, 0}, unit(Exact3{1, 0, -0.01L})}) {
        const auto flat = nearest<Dir>(d);
        EXPECT_FALSE(plane_mirror_hit<N>(plane, o, flat, Len(0)).hit) << double(d.z);
        EXPECT_FALSE(curved_mirror_hit<N>(plane, o, flat, Len(0)).hit) << double(d.z);
    }
    EXPECT_TRUE(plane_mirror_hit<N>(plane, o, nearest<Dir>(unit(Exact3{1, 0, -0.1L})), Len(0)).hit);
}

}  // namespace
}  // namespace zerkalo::test
