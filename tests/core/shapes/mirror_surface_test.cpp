// The mirror's surface from R = 0.1 to the plane: nearest root inside the outline, both roots, own chord, normals.
#include "tests/core/support/solids.hpp"
#include "tests/core/support/widths.hpp"

namespace zerkalo::test {
namespace {

using probes::MirrorWay;

// Frame change, shift to the vertex, the quadratic's coefficients and root; over the incidence cosine.
constexpr Real80 kMirrorRoundings = 24;
constexpr Real80 kLeastCosine = 0.1L;

constexpr double kRadii[] = {0.1, -0.1, 0.6, -0.6, 2, -2, 30, -30, 1e3, -1e3, 1e6, -1e6, 1e9, -1e9, kInfinity};

struct Hits {
    std::vector<float> hit, t;
    PointList p;
    explicit Hits(std::size_t count) : hit(count), t(count), p(count) {}
    operator probes::MirrorHitsOut() { return {hit.data(), t.data(), p.x.data(), p.y.data(), p.z.data()}; }
};

class MirrorSurface : public Widths {
protected:
    static Hits hits_of(const probes::ShapeProbes& shapes, const MirrorShape& mirror, MirrorWay way,
                        const RayList& rays) {
        Hits hits(rays.size());
        shapes.mirror(mirror, way, rays, hits);
        return hits;
    }
};

/// A mirror in a random frame whose disc reaches 0.9 R, at most 1.
struct MirrorSubject {
    MirrorShape shape;
    Real80 aperture;
};
MirrorSubject mirror_of(double radius, Random& random) {
    const auto scene = std::make_unique<Scene>();
    const auto plan = std::make_unique<Plan>();
    Mirror& mirror = scene->mirrors[0];
    scene->mirror_count = 1;
    mirror.position = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    mirror.normal = rounded_to_double(random.direction());
    mirror.boundary = {.shape = BoundaryShape::disc, .radius = std::min(1.0, 0.9 * std::abs(radius))};
    mirror.curvature_radius = radius;
    const Status status = prepare(*scene, Settings{}, *plan);
    EXPECT_TRUE(status.ok()) << status.field << " " << status.reason;
    return {plan->mirrors[0].shape, Real80(mirror.boundary.radius)};
}

Exact3 in_frame(const MirrorShape& m, const Exact3& v) {
    return {dot(exact(m.right), v), dot(exact(m.v), v), dot(exact(m.n), v)};
}
Exact3 to_world(const MirrorShape& m, const Exact3& v) {
    return exact(m.right) * v.x + exact(m.v) * v.y + exact(m.n) * v.z;
}

/// One crossing of a ray (given in the mirror's frame) with the whole surface kappa |p|^2 = 2 z.
struct Crossing {
    Real80 t = kFar80, cosine = 0, rim = 0;  // rim: how far inside the disc, scene units
    Exact3 p;
};
struct Crossings {
    int count = 0;
    Crossing at[2];
    Real80 disc = 0;  // the squared cosine; negative where the ray passes by
};
Crossings crossings_of(const MirrorShape& m, Real80 aperture, const Exact3& o, const Exact3& d) {
    const Real80 kappa = m.kappa;
    const Real80 a = kappa * dot(d, d), b = kappa * dot(o, d) - d.z, c = kappa * dot(o, o) - 2 * o.z;
    const Real80 disc = b * b - a * c;
    Crossings found;
    found.disc = disc;
    if (disc < 0) return found;
    const Real80 q = -(b + std::copysign(std::sqrt(disc), b));
    for (const Real80 t : {c / q, q / a}) {
        if (!std::isfinite(t)) continue;
        const Exact3 p = o + d * t;
        if (kappa * p.z >= 1) continue;
        const Exact3 n{-kappa * p.x, -kappa * p.y, 1 - kappa * p.z};
        found.at[found.count++] = {t, std::abs(dot(n, d)) / length(d), aperture - std::hypot(p.x, p.y), p};
    }
    return found;
}

/// What the ray must find; `certain` where no rounding can change which crossing counts.
struct Wanted {
    bool certain = true, hit = false, second = false;
    Crossing at;
};
Wanted wanted_hit(const Crossings& crossings, Real80 kappa, Real80 room) {
    Wanted wanted;
    // A ray that passes by so closely that a shift by a few `room` would make it touch.
    wanted.certain = crossings.disc >= 0 || crossings.disc < -40 * room * std::abs(kappa);
    for (int k = 0; k < crossings.count; ++k) {
        const Crossing& at = crossings.at[k];
        if (at.cosine < kLeastCosine || std::abs(at.rim) < 10 * room || std::abs(at.t) < 10 * room)
            wanted.certain = false;
        if (at.t <= 0 || at.rim < 0 || at.t >= wanted.at.t) continue;
        // The nearest crossing inside the disc is the farther one of both.
        wanted.second = crossings.count == 2 && crossings.at[1 - k].t < at.t && crossings.at[1 - k].t > 0;
        wanted.hit = true;
        wanted.at = at;
    }
    return wanted;
}

struct Tally {
    std::size_t hits = 0, misses = 0, second_roots = 0;
};

void expect_crossings(const MirrorSubject& mirror, const RayList& rays, const Hits& hits, Tally& tally) {
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const Exact3 o = in_frame(mirror.shape, rays.o[k] - exact(mirror.shape.vertex));
        const Exact3 d = in_frame(mirror.shape, rays.d[k]);
        const Real80 room = kMirrorRoundings * kU * (length(o) + mirror.aperture);
        const Wanted wanted = wanted_hit(crossings_of(mirror.shape, mirror.aperture, o, d), mirror.shape.kappa, room);
        if (!wanted.certain) continue;
        ASSERT_EQ(hits.hit[k], wanted.hit ? 1 : 0) << text(rays, k) << " kappa " << mirror.shape.kappa;
        (wanted.hit ? tally.hits : tally.misses) += 1;
        if (!wanted.hit) continue;
        tally.second_roots += wanted.second;
        const Real80 bound = room / wanted.at.cosine;
        ASSERT_LE(std::abs(hits.t[k] - wanted.at.t), bound) << text(rays, k) << " kappa " << mirror.shape.kappa;
        ASSERT_LE(length(hits.p[k] - wanted.at.p), bound) << text(rays, k) << " kappa " << mirror.shape.kappa;
    }
}

RayList rays_towards(const MirrorSubject& mirror, std::size_t count, Random& random) {
    RayList rays;
    while (rays.size() < count) {
        const Exact3 foot{random.uniform(-1, 1), random.uniform(-1, 1), 0};
        const Exact3 target = exact(mirror.shape.vertex) + to_world(mirror.shape, foot * (1.3L * mirror.aperture));
        const Real80 distance = mirror.aperture * std::exp2(random.uniform(-2, 5));
        const Exact3 from = exact(rounded_to_float(target + random.direction() * distance));
        rays.add(from, unit(target - from));
    }
    rays.pad();
    return rays;
}

TEST_P(MirrorSurface, NearestCrossingInsideTheOutlineIsTheClosedForm) {
    Random random(61);
    Tally tally;
    for (const double radius : kRadii) {
        const MirrorSubject mirror = mirror_of(radius, random);
        const RayList rays = rays_towards(mirror, kLawRays / 10, random);
        expect_crossings(mirror, rays, hits_of(shapes(), mirror.shape, MirrorWay::curved, rays), tally);
    }
    EXPECT_GT(tally.hits, kLawRays / 4);
    EXPECT_GT(tally.misses, kLawRays / 8);
    EXPECT_GT(tally.second_roots, kLawRays / 1000) << "rays that pass the first crossing outside the outline";
}

TEST_P(MirrorSurface, PlaneFormAndCurvedFormOfAPlaneAgree) {
    Random random(62);
    const MirrorSubject mirror = mirror_of(kInfinity, random);
    const RayList rays = rays_towards(mirror, kLawRays, random);
    Tally plane, curved;
    expect_crossings(mirror, rays, hits_of(shapes(), mirror.shape, MirrorWay::plane, rays), plane);
    expect_crossings(mirror, rays, hits_of(shapes(), mirror.shape, MirrorWay::curved, rays), curved);
    EXPECT_GT(plane.hits, kLawRays / 4);
    EXPECT_EQ(plane.hits, curved.hits);
    const Hits flat = hits_of(shapes(), mirror.shape, MirrorWay::plane, rays);
    expect_same_bits(flat.p.z, Floats(rays.size(), 0), "height above a plane");
}

TEST_P(MirrorSurface, FarOriginKeepsTheSurfaceInReach) {
    Random random(63);
    Tally tally;
    for (const double radius : {0.6, -2.0, 1e3, kInfinity}) {
        const MirrorSubject mirror = mirror_of(radius, random);
        RayList rays;
        while (rays.size() < kLawRays / 4) {
            const Exact3 foot = to_world(mirror.shape, {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 0});
            const Exact3 target = exact(mirror.shape.vertex) + foot * mirror.aperture;
            const Exact3 from = exact(rounded_to_float(target + random.direction() * 1e3L));
            rays.add(from, unit(target - from));
        }
        rays.pad();
        expect_crossings(mirror, rays, hits_of(shapes(), mirror.shape, MirrorWay::curved, rays), tally);
    }
    EXPECT_GT(tally.hits, kLawRays / 2);
}

// A ray that starts on a hollow mirror meets it again at the end of a chord; the start itself is never met.
TEST_P(MirrorSurface, OwnChordOfAHollowMirrorIsTheClosedForm) {
    Random random(64);
    std::size_t hits_seen = 0, misses_seen = 0;
    for (const double radius : {0.1, 0.6, 2.0, -0.6}) {
        const MirrorSubject mirror = mirror_of(radius, random);
        const Real80 kappa = mirror.shape.kappa;
        RayList rays;
        while (rays.size() < kLawRays / 4) {
            const Real80 rho = mirror.aperture * std::sqrt(random.uniform(0, 1)), around = random.uniform(0, 6.3);
            const Real80 z = kappa * rho * rho / (1 + std::sqrt(1 - kappa * kappa * rho * rho));
            const Exact3 p{rho * std::cos(around), rho * std::sin(around), z};
            const Exact3 n{-kappa * p.x, -kappa * p.y, 1 - kappa * p.z};
            Exact3 d = random.direction();
            if (dot(d, n) < 0) d = d - n * (2 * dot(d, n));
            rays.add(p, d);
        }
        rays.pad();
        const Hits hits = hits_of(shapes(), mirror.shape, MirrorWay::own_chord, rays);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            const Exact3 o = rays.o[k], d = rays.d[k];
            const Exact3 n{-kappa * o.x, -kappa * o.y, 1 - kappa * o.z};
            const Real80 cosine = dot(n, d) / length(d), chord = 2 * cosine / kappa;
            const Exact3 p = o + d * chord;
            const Real80 room = kMirrorRoundings * kU * mirror.aperture, rim = mirror.aperture - std::hypot(p.x, p.y);
            if (cosine < kLeastCosine || std::abs(rim) < 10 * room || std::abs(kappa * p.z - 1) < 1e-4L) continue;
            const bool wanted = chord > 0 && rim > 0 && kappa * p.z < 1;
            ASSERT_EQ(hits.hit[k], wanted ? 1 : 0) << text(rays, k) << " R " << radius;
            (wanted ? hits_seen : misses_seen) += 1;
            if (!wanted) continue;
            ASSERT_LE(std::abs(hits.t[k] - chord), room / cosine) << text(rays, k) << " R " << radius;
            ASSERT_LE(length(hits.p[k] - p), room / cosine) << text(rays, k) << " R " << radius;
        }
    }
    EXPECT_GT(hits_seen, kLawRays / 10);
    EXPECT_GT(misses_seen, kLawRays / 10);
}

TEST_P(MirrorSurface, NormalPointsToTheCentreOfCurvature) {
    Random random(65);
    constexpr Real80 kNormalRoundings = 12;
    for (const double radius : kRadii) {
        const MirrorSubject mirror = mirror_of(radius, random);
        const Real80 kappa = mirror.shape.kappa;
        PointList p, n(1008);
        while (p.size() < n.size()) {
            const Real80 rho = mirror.aperture * std::sqrt(random.uniform(0, 1)), around = random.uniform(0, 6.3);
            p.add({rho * std::cos(around), rho * std::sin(around),
                   kappa * rho * rho / (1 + std::sqrt(1 - kappa * kappa * rho * rho))});
        }
        shapes().mirror_normal(mirror.shape, p, n.out(), p.count());
        for (std::size_t k = 0; k < p.size(); ++k) {
            const Exact3 inwards{-kappa * p[k].x, -kappa * p[k].y, 1 - kappa * p[k].z};
            const Exact3 wanted = to_world(mirror.shape, unit(inwards));
            ASSERT_LE(length(n[k] - wanted), kNormalRoundings * kU) << text(p[k]) << " R " << radius;
        }
    }
}

TEST_P(MirrorSurface, EveryWidthGivesTheSameBits) {
    Random random(66);
    for (const double radius : {0.6, -2.0, kInfinity}) {
        const MirrorSubject mirror = mirror_of(radius, random);
        const RayList rays = rays_towards(mirror, kLawRays / 4, random);
        for (const MirrorWay way : {MirrorWay::plane, MirrorWay::curved, MirrorWay::own_chord}) {
            const Hits here = hits_of(shapes(), mirror.shape, way, rays);
            const Hits there = hits_of(scalar().shapes, mirror.shape, way, rays);
            expect_same_bits(here.hit, there.hit, "hit");
            for (std::size_t k = 0; k < rays.size(); ++k) {
                if (there.hit[k] == 0) continue;
                ASSERT_EQ(bits_of_float(here.t[k]), bits_of_float(there.t[k])) << text(rays, k);
                ASSERT_EQ(text(here.p[k]), text(there.p[k])) << text(rays, k);
            }
        }
    }
}

ZERKALO_OVER_ALL_WIDTHS(MirrorSurface);

}  // namespace
}  // namespace zerkalo::test
