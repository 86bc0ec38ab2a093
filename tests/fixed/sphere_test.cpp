// The sphere's template over fixed point, and reflection, against closed forms in long double.
#include "core/optics/directions.hpp"
#include "core/shapes/sphere.hpp"
#include "tests/fixed/fixed_shapes.hpp"

namespace zerkalo::test {
namespace {

constexpr int kGroups = 4000;

template <int W>
Span<FixedNumbers<W>> span_of(const FixedSphere& sphere, const RayGroup& rays, int first) {
    using N = FixedNumbers<W>;
    const auto from = sphere_seen_from<N>(sphere, packed<W>(rays.o, first));
    return sphere_span<N>(sphere, from, packed<W>(rays.d, first));
}

struct Scene {
    FixedSphere sphere;
    Exact3 centre;
    Real80 radius;
    RayGroup rays;
};

/// A sphere somewhere in the box, and rays to points of a ball around it that is half as large again.
Scene random_scene(Random& random) {
    Scene s;
    s.radius = real(nearest<Len>(random.uniform(0.05, 1.5)));
    s.sphere = fixed_sphere(random.direction() * random.uniform(0, 2.4), s.radius);
    s.centre = real(s.sphere.centre);
    for (int k = 0; k < kGroup; ++k) {
        const Exact3 from = point_in_box(random);
        s.rays.aim(k, from, s.centre + random.direction() * (s.radius * random.uniform(0, 1.5)));
    }
    return s;
}

TEST(FixedSphere, HitsWhereTheClosedFormSays) {
    Random random(21);
    int met = 0, missed = 0;
    for (int g = 0; g < kGroups; ++g) {
        const Scene s = random_scene(random);
        for (int k = 0; k < kGroup; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const Exact3 f = real(s.rays.o[i]) - s.centre;
            const Real80 b = dot(f, s.rays.exact_d[i]);
            const Exact3 l = f - s.rays.exact_d[i] * b;
            const Real80 disc = s.radius * s.radius - dot(l, l);
            const auto span = span_of<1>(s.sphere, s.rays, k);
            if (disc < -kTolerance) {
                ASSERT_GE(span.entry.raw, span.exit.raw) << "group " << g << " ray " << k;
                ++missed;
            }
            const Real80 half = disc > 0 ? std::sqrt(disc) : 0;
            if (half < kLeastCosine * s.radius) continue;
            ASSERT_NEAR(double(real(span.entry)), double(-b - half), double(kTolerance)) << g << ' ' << k;
            ASSERT_NEAR(double(real(span.exit)), double(-b + half), double(kTolerance)) << g << ' ' << k;
            ++met;
        }
    }
    EXPECT_GT(met, kGroups);
    EXPECT_GT(missed, kGroups / 10);
}

TEST(FixedSphere, EveryWidthGivesTheSameBits) {
    Random random(22);
    for (int g = 0; g < kGroups; ++g) {
        const Scene s = random_scene(random);
        const auto eight = span_of<8>(s.sphere, s.rays, 0);
        for (int k = 0; k < kGroup; ++k) {
            const auto one = span_of<1>(s.sphere, s.rays, k);
            const auto four = span_of<4>(s.sphere, s.rays, k / 4 * 4);
            ASSERT_EQ(one.entry.raw, lane(four.entry, k % 4).raw) << "group " << g << " ray " << k;
            ASSERT_EQ(one.exit.raw, lane(four.exit, k % 4).raw) << "group " << g << " ray " << k;
            ASSERT_EQ(one.entry.raw, lane(eight.entry, k).raw) << "group " << g << " ray " << k;
            ASSERT_EQ(one.exit.raw, lane(eight.exit, k).raw) << "group " << g << " ray " << k;
        }
    }
}

TEST(FixedSphere, InALookingGlassHasTheSameSpan) {
    Random random(23);
    for (int g = 0; g < kGroups; ++g) {
        const Scene s = random_scene(random);
        Scene image = s;
        image.sphere.centre = flipped(s.sphere.centre);
        for (std::size_t k = 0; k < kGroup; ++k) {
            image.rays.o[k] = flipped(s.rays.o[k]);
            image.rays.d[k] = flipped(s.rays.d[k]);
        }
        for (int k = 0; k < kGroup; ++k) {
            const auto span = span_of<1>(s.sphere, s.rays, k), other = span_of<1>(image.sphere, image.rays, k);
            ASSERT_EQ(span.entry.raw, other.entry.raw) << "group " << g << " ray " << k;
            ASSERT_EQ(span.exit.raw, other.exit.raw) << "group " << g << " ray " << k;
        }
    }
}

TEST(FixedSphere, FartherThanTheRangeIsMissed) {
    // The difference of the points is 30, which would wrap to -2 and be met straight ahead.
    const FixedSphere sphere = fixed_sphere({-15, -15, -15}, 1);
    RayGroup rays{};
    rays.aim(0, {15, 15, 15}, {16, 16, 16});
    const auto span = span_of<1>(sphere, rays, 0);
    EXPECT_GE(span.entry.raw, span.exit.raw);
}

TEST(FixedReflection, IsThatOfTheFormulaAndKeepsItsSymmetries) {
    // The cosine is rounded by half a step and doubled; each component of its product with n by half a step.
    constexpr Real80 kTwoSteps = 2 * 0x1p-30L;
    Random random(24);
    for (int i = 0; i < 50000; ++i) {
        const auto d = nearest<Dir>(random.direction()), n = nearest<Dir>(random.direction());
        const Vec3<Dir> r = reflect(d, n);
        const Exact3 expected = real(d) - real(n) * (2 * dot(real(d), real(n)));
        ASSERT_LT(length(real(r) - expected), kTwoSteps) << i;
        const Vec3<Dir> back = reflect(-d, n), turned = reflect(d, -n), image = reflect(flipped(d), flipped(n));
        ASSERT_TRUE(back.x == -r.x && back.y == -r.y && back.z == -r.z) << i;
        ASSERT_TRUE(turned.x == r.x && turned.y == r.y && turned.z == r.z) << i;
        ASSERT_TRUE(image.x == -r.x && image.y == r.y && image.z == r.z) << i;
    }
}

TEST(FixedReflection, EveryWidthGivesTheSameBits) {
    Random random(25);
    for (int g = 0; g < kGroups; ++g) {
        std::array<Vec3<Dir>, kGroup> d, n;
        for (std::size_t k = 0; k < kGroup; ++k) {
            d[k] = nearest<Dir>(random.direction());
            n[k] = nearest<Dir>(random.direction());
        }
        const auto eight = reflect(packed<8>(d, 0), packed<8>(n, 0));
        for (int k = 0; k < kGroup; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const Vec3<Dir> one = reflect(d[i], n[i]);
            const auto four = reflect(packed<4>(d, k / 4 * 4), packed<4>(n, k / 4 * 4));
            ASSERT_EQ(one.x.raw, lane(eight.x, k).raw) << "group " << g << " ray " << k;
            ASSERT_EQ(one.z.raw, lane(eight.z, k).raw) << "group " << g << " ray " << k;
            ASSERT_EQ(one.y.raw, lane(four.y, k % 4).raw) << "group " << g << " ray " << k;
        }
    }
}

}  // namespace
}  // namespace zerkalo::test
