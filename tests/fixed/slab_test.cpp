// Slabs over fixed point: boxes in any position, and rays parallel to their faces.
#include "core/shapes/half_spaces.hpp"
#include "tests/fixed/fixed_shapes.hpp"

namespace zerkalo::test {
namespace {

constexpr int kGroups = 3000;
constexpr int kSlabs = 3;

/// A parallelepiped: its slabs as the templates read them, and before rounding.
struct Box {
    Exact3 centre;
    std::array<FixedSlab, kSlabs> slabs;
    std::array<Exact3, kSlabs> normals;
};

Box random_box(Random& random) {
    Box box;
    box.centre = real(nearest<Len>(random.direction() * random.uniform(0, 2)));
    for (std::size_t s = 0; s < kSlabs; ++s) {
        box.normals[s] = random.direction();
        box.slabs[s] = {nearest<Dir>(box.normals[s]), nearest<Len>(-random.uniform(0.1, 1.5)),
                        nearest<Len>(random.uniform(0.1, 1.5)), One::Index(static_cast<int>(s))};
    }
    return box;
}

template <int W>
Span<FixedNumbers<W>> span_of(const Box& box, const RayGroup& rays, int first) {
    using N = FixedNumbers<W>;
    const auto o = packed<W>(rays.o, first) - nearest<Len>(box.centre);
    const auto d = packed<W>(rays.d, first);
    Span<N> span = whole_span<N>();
    for (const FixedSlab& slab : box.slabs) clip<Faces::both, N>(span, slab, slab_seen_from<N>(slab, o), d);
    return span;
}

RayGroup rays_to(const Box& box, Random& random) {
    RayGroup rays;
    for (int k = 0; k < kGroup; ++k) {
        const Exact3 from = point_in_box(random);
        rays.aim(k, from, box.centre + random.direction() * random.uniform(0, 1));
    }
    return rays;
}

/// The span in long double, and the least cosine and closest decision that it met on its way.
struct ExactSpan {
    Real80 entry = -16, exit = 16, least_cosine = 1, margin = 16;
    int face_in = 0, face_out = 0;
};
ExactSpan exact_span(const Box& box, const Exact3& o, const Exact3& d) {
    ExactSpan span;
    for (std::size_t s = 0; s < kSlabs; ++s) {
        const Real80 along = dot(box.normals[s], d), height = dot(box.normals[s], o - box.centre);
        const Real80 one = (real(box.slabs[s].lo) - height) / along, two = (real(box.slabs[s].hi) - height) / along;
        const Real80 enter = std::min(one, two), leave = std::max(one, two);
        span.least_cosine = std::min(span.least_cosine, std::abs(along));
        span.margin = std::min({span.margin, std::abs(enter - span.entry), std::abs(leave - span.exit)});
        if (enter > span.entry) {
            span.entry = enter;
            span.face_in = static_cast<int>(s);
        }
        if (leave < span.exit) {
            span.exit = leave;
            span.face_out = static_cast<int>(s);
        }
    }
    return span;
}

TEST(FixedBox, HitsWhereTheClosedFormSays) {
    Random random(31);
    int compared = 0;
    for (int g = 0; g < kGroups; ++g) {
        const Box box = random_box(random);
        const RayGroup rays = rays_to(box, random);
        for (int k = 0; k < kGroup; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const ExactSpan exact = exact_span(box, real(rays.o[i]), rays.exact_d[i]);
            if (exact.least_cosine < kLeastCosine) continue;
            const auto span = span_of<1>(box, rays, k);
            ASSERT_NEAR(double(real(span.entry)), double(exact.entry), double(kTolerance)) << g << ' ' << k;
            ASSERT_NEAR(double(real(span.exit)), double(exact.exit), double(kTolerance)) << g << ' ' << k;
            if (exact.margin < kTolerance) continue;
            ASSERT_EQ(span.face_in.raw, exact.face_in) << g << ' ' << k;
            ASSERT_EQ(span.face_out.raw, exact.face_out) << g << ' ' << k;
            ++compared;
        }
    }
    EXPECT_GT(compared, kGroups);
}

TEST(FixedBox, EveryWidthGivesTheSameBits) {
    Random random(32);
    for (int g = 0; g < kGroups; ++g) {
        const Box box = random_box(random);
        const RayGroup rays = rays_to(box, random);
        const auto eight = span_of<8>(box, rays, 0);
        for (int k = 0; k < kGroup; ++k) {
            const auto one = span_of<1>(box, rays, k);
            const auto four = span_of<4>(box, rays, k / 4 * 4);
            ASSERT_EQ(one.entry.raw, lane(eight.entry, k).raw) << g << ' ' << k;
            ASSERT_EQ(one.exit.raw, lane(eight.exit, k).raw) << g << ' ' << k;
            ASSERT_EQ(one.face_in.raw, lane(eight.face_in, k).raw) << g << ' ' << k;
            ASSERT_EQ(one.entry.raw, lane(four.entry, k % 4).raw) << g << ' ' << k;
            ASSERT_EQ(one.face_out.raw, lane(four.face_out, k % 4).raw) << g << ' ' << k;
        }
    }
}

TEST(FixedBox, InALookingGlassHasTheSameSpan) {
    Random random(33);
    for (int g = 0; g < kGroups; ++g) {
        const Box box = random_box(random);
        const RayGroup rays = rays_to(box, random);
        Box image = box;
        image.centre.x = -box.centre.x;
        for (FixedSlab& slab : image.slabs) slab.n = flipped(slab.n);
        RayGroup back = rays;
        for (std::size_t k = 0; k < kGroup; ++k) {
            back.o[k] = flipped(rays.o[k]);
            back.d[k] = flipped(rays.d[k]);
        }
        for (int k = 0; k < kGroup; ++k) {
            const auto span = span_of<1>(box, rays, k), other = span_of<1>(image, back, k);
            ASSERT_EQ(span.entry.raw, other.entry.raw) << g << ' ' << k;
            ASSERT_EQ(span.exit.raw, other.exit.raw) << g << ' ' << k;
        }
    }
}

/// A ray along z at height x, and the slab -1 <= x <= 1.
template <int W>
Span<FixedNumbers<W>> parallel_span(Real80 x) {
    using N = FixedNumbers<W>;
    const FixedSlab slab = {{Dir(1), Dir(0), Dir(0)}, Len(-1), Len(1), One::Index(1)};
    const Vec3<Length<N>> o = {Length<N>(nearest<Len>(x)), Length<N>(0), Length<N>(0)};
    const Vec3<Direction<N>> d = {Direction<N>(0), Direction<N>(0), Direction<N>(1)};
    Span<N> span = whole_span<N>();
    clip<Faces::both, N>(span, slab, slab_seen_from<N>(slab, o), d);
    return span;
}

template <int W>
void expect_parallel_laws() {
    const auto far = far_away<Len>().raw;
    for (const Real80 x : {0.0L, 0.5L, -0.999L, 1 - 0x1p-27L, -1 + 0x1p-27L, 1.0L}) {
        const auto span = parallel_span<W>(x);
        EXPECT_EQ(lane(span.entry, 0).raw, -far) << "inside at " << x;
        EXPECT_EQ(lane(span.exit, 0).raw, far) << "inside at " << x;
    }
    for (const Real80 x : {1 + 0x1p-27L, 2.0L, 4.0L, -1.0L, -1 - 0x1p-27L, -4.0L}) {
        const auto span = parallel_span<W>(x);
        EXPECT_GE(lane(span.entry, 0).raw, lane(span.exit, 0).raw) << "outside at " << x;
    }
}

TEST(FixedSlab, IgnoresAParallelRayInsideAndMissesOneOutside) {
    expect_parallel_laws<1>();
    expect_parallel_laws<4>();
    expect_parallel_laws<8>();
}

TEST(FixedSlab, ACrossingBeyondTheRangeIsNeverNearer) {
    // The face would be met at t = 4 / 0.01 = 400; the format ends at 16.
    using N = FixedNumbers<1>;
    const FixedSlab slab = {{Dir(1), Dir(0), Dir(0)}, Len(-1), Len(1), One::Index(1)};
    const Vec3<Len> o = {Len(-5), Len(0), Len(0)};
    const Vec3<Dir> d = nearest<Dir>(unit(Exact3{0.01L, 0, 1}));
    Span<N> span = whole_span<N>();
    clip<Faces::both, N>(span, slab, slab_seen_from<N>(slab, o), d);
    EXPECT_GE(span.entry.raw, span.exit.raw);
}

}  // namespace
}  // namespace zerkalo::test
