// Whitted's local light against its plain formula, term by term.
#include "tests/core/support/random.hpp"
#include "tests/core/support/rays.hpp"
#include "tests/core/support/widths.hpp"

namespace zerkalo::test {
namespace {

class LocalLight : public Widths {};

struct Views {
    RayList seen;  // o: the surface point, d: the way to the viewer
    PointList n;
};

Views random_views(Random& random, const LightData& light) {
    Views views;
    while (views.n.size() < kLawRays / 4) {
        const Exact3 p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        const Exact3 n = random.direction(), l = unit(exact(light.position) - p);
        // Half of the viewers look near the mirrored light, where the highlight is.
        const Exact3 r = n * (2 * dot(n, l)) - l;
        views.seen.add(p, random.below(2) == 0 ? random.direction() : unit(r + random.direction() * 0.1L));
        views.n.add(n);
    }
    while (views.n.size() % probes::kWidest != 0) views.n.add(views.n[views.n.size() - 1]);
    views.seen.pad();
    return views;
}

/// E (C Kd (N.L) + F Ks max(0, R.V)^n) for one channel, and the highlight's part of it; n = 0 is the constant lobe.
struct Plain {
    Real80 share, highlight;
};
Plain plain_formula(Real80 power, Real80 falloff, Real80 diffuse, Real80 specular, Real80 n_dot_l, Real80 r_dot_v,
                    Real80 shininess) {
    const Real80 highlight = specular * std::pow(std::max<Real80>(0, r_dot_v), shininess);
    return {power * falloff * (diffuse * n_dot_l + highlight), power * falloff * highlight};
}

void expect_plain_formula(const LightData& light, const SurfaceData& surface, const Views& views,
                          const PointList& got) {
    for (std::size_t k = 0; k < views.n.size(); ++k) {
        const Exact3 way = exact(light.position) - views.seen.o[k], n = views.n[k], v = views.seen.d[k];
        const Exact3 l = unit(way), r = n * (2 * dot(n, l)) - l;
        const Real80 n_dot_l = dot(n, l);
        if (std::abs(n_dot_l) < 16 * kU) continue;  // on the terminator: lit or not, by a rounding
        const Real80 falloff = light.inverse_square ? 1 / dot(way, way) : 1;
        // What n and v lack of unit length enters R.V and is raised to the power n like an angle.
        const Real80 r_dot_v = dot(r, v) / (length(r) * length(v));
        const Plain plain = plain_formula(light.power.g, falloff, surface.diffuse.g, surface.specular.g, n_dot_l,
                                          r_dot_v, surface.shininess);
        const Real80 wanted = n_dot_l > 0 ? plain.share : 0;
        // The chord's rounding grows with 2 sqrt(n x); n x is at most 17 before the highlight vanishes below 2^-24.
        const Real80 of_highlight = (16 + 32 * std::sqrt(Real80(surface.shininess))) * kU * plain.highlight;
        const Real80 vanished = 0x1p-23L * light.power.g * surface.specular.g * falloff;
        const Real80 room =
            16 * kU * std::abs(plain.share) + 16 * kU * falloff * light.power.g + of_highlight + vanished;
        ASSERT_LE(std::abs(got[k].y - wanted), room)
            << text(views.seen, k) << " n " << text(n) << " R.V " << double(r_dot_v);
    }
}

LightData lamp(bool inverse_square) {
    LightData light{};
    light.position = {1.5f, 2.5f, -3};
    light.power = {0.5f, 2, 1};
    light.inverse_square = inverse_square;
    // As set-up derives them: no share is brighter than kBrightest; beyond this n x the highlight is below 2^-24.
    light.falloff_limit = kBrightest / 2;
    light.highlight_limit = inverse_square ? 0x1.fffffep+127f : float(std::log(2 * 0x1p24));
    return light;
}

SurfaceData matter(float shininess) { return {{0, 0, 0}, {0.25f, 0.5f, 0.75f}, {0.4f, 0.3f, 0.2f}, shininess}; }

TEST_P(LocalLight, ShareIsThePlainFormula) {
    Random random(95);
    for (const bool inverse_square : {false, true}) {
        for (const float shininess : {0.0f, 1.0f, 50.0f, 2000.0f}) {
            const LightData light = lamp(inverse_square);
            const SurfaceData surface = matter(shininess);
            const Views views = random_views(random, light);
            PointList got(views.n.size());
            optics().light(light, surface, views.seen, views.n, got.out());
            expect_plain_formula(light, surface, views, got);
        }
    }
}

TEST_P(LocalLight, ChannelsDifferByTheirCoefficientsAlone) {
    Random random(96);
    const LightData light = lamp(false);
    SurfaceData surface = matter(20);
    surface.specular = {0.5f, 0.5f, 0.5f}, surface.diffuse = {0.5f, 0.5f, 0.5f};
    const Views views = random_views(random, light);
    PointList got(views.n.size());
    optics().light(light, surface, views.seen, views.n, got.out());
    for (std::size_t k = 0; k < got.size(); ++k) {
        // The powers 1/2, 2 and 1 are powers of two, so the channels keep their digits.
        ASSERT_EQ(got[k].x * 4, got[k].y) << text(views.seen, k);
        ASSERT_EQ(got[k].x * 2, got[k].z) << text(views.seen, k);
    }
}

TEST_P(LocalLight, LightFromBehindAddsNothing) {
    Random random(97);
    const LightData light = lamp(true);
    RayList seen;
    PointList n, got(1024);
    while (n.size() < got.size()) {
        const Exact3 p = random.direction(), l = unit(exact(light.position) - p);
        Exact3 normal = random.direction();
        if (dot(normal, l) > 0) normal = -normal;
        seen.add(p, random.direction()), n.add(normal);
    }
    optics().light(light, matter(3), seen, n, got.out());
    for (std::size_t k = 0; k < got.size(); ++k) ASSERT_EQ(text(got[k]), text(Exact3{})) << text(seen, k);
}

// 1 / d^2 leaves the range of float long before d is zero; what the surface does not reflect must not become inf * 0.
TEST_P(LocalLight, ALightOnTheSurfaceItselfLeavesBlackBlack) {
    LightData light = lamp(true);
    light.position = {0, 0, 0};
    SurfaceData surface = matter(3);
    surface.diffuse.r = surface.specular.r = 0;
    const float tiny[] = {0, 0x1p-140f, 0x1p-100f, 0x1p-64f, 0x1p-60f, 1e-15f, 1e-10f, 1e-5f};
    RayList seen;
    PointList n, got(probes::kWidest);
    for (std::size_t k = 0; k < got.size(); ++k) {
        seen.add({0, 0, -Real80(tiny[k % 8])}, {0, 0, 1});
        n.add({0, 0, 1});
    }
    optics().light(light, surface, seen, n, got.out());
    for (std::size_t k = 0; k < got.size(); ++k) {
        ASSERT_EQ(got.x[k], 0) << "light at a distance of " << tiny[k % 8];
        ASSERT_GE(got.y[k], 0) << "light at a distance of " << tiny[k % 8];
    }
    EXPECT_EQ(text(got[0]), text(Exact3{})) << "N.L of no direction is nothing";
    EXPECT_LE(got.y[3], kBrightest);
    EXPECT_GT(got.y[3], kBrightest / 4) << "the case must reach the range's end, or it shows nothing";
}

TEST_P(LocalLight, EveryWidthGivesTheSameBits) {
    Random random(98);
    for (const bool inverse_square : {false, true}) {
        const LightData light = lamp(inverse_square);
        const Views views = random_views(random, light);
        PointList here(views.n.size()), there(views.n.size());
        optics().light(light, matter(50), views.seen, views.n, here.out());
        scalar().optics.light(light, matter(50), views.seen, views.n, there.out());
        expect_same_bits(here.x, there.x, "red");
        expect_same_bits(here.y, there.y, "green");
        expect_same_bits(here.z, there.z, "blue");
    }
}

ZERKALO_OVER_ALL_WIDTHS(LocalLight);

}  // namespace
}  // namespace zerkalo::test
