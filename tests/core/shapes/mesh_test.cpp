// A triangulated prism answers like the prism of half-spaces; sides and faces of triangles are named right.
#include "tests/core/support/meshes.hpp"
#include "tests/core/support/solids.hpp"
#include "tests/core/support/widths.hpp"

namespace zerkalo::test {
namespace {

// Two cross products, dot products and a quotient. A plane that is told by two edges at a sharp angle loses the sine of
// that angle: in the fan of an n-gon it is sin(pi / n), so the bound is multiplied by n.
constexpr Real80 kMeshRoundings = 4;

class Mesh : public Widths {};

struct Twins {
    std::unique_ptr<Plan> mesh, half_spaces;
    std::vector<Triangle> triangles;
};

Twins twins(SolidKind kind, int sides, Random& random) {
    Solid solid = placed(kind, random);
    solid.sides = sides;
    Twins twin;
    twin.triangles = triangles_of(solid);
    twin.half_spaces = plan_of(solid);
    twin.mesh = plan_of(meshed(solid, twin.triangles), twin.triangles);
    return twin;
}

TEST_P(Mesh, TriangulatedPrismIsThePrism) {
    Random random(41);
    Outcome outcome;
    for (const SolidKind kind : {SolidKind::prism, SolidKind::pyramid}) {
        for (const int sides : {3, 4, 5, 8, 17, 64}) {
            const Twins twin = twins(kind, sides, random);
            RayList rays;
            while (rays.size() < kLawRays / 16) add_ray_towards(rays, *twin.mesh, random, random.uniform(2, 8));
            rays.pad();
            const Plan& exactly = *twin.half_spaces;
            expect_nested(
                rays, spans_of(shapes(), *twin.mesh, rays),
                [&](std::size_t k, Real80 grow) { return exact_span(exactly, rays.o[k], rays.d[k], grow); },
                [&](std::size_t k) {
                    return sides * kMeshRoundings * kU * (length(rays.o[k] - centre_of(exactly)) + size_of(exactly));
                },
                outcome);
        }
    }
    EXPECT_GT(outcome.hits, kLawRays / 8);
    EXPECT_GT(outcome.misses, kLawRays / 8);
}

struct Answers {
    std::vector<float> hit, back, t, face;
    explicit Answers(std::size_t count) : hit(count), back(count), t(count), face(count) {}
    operator probes::MeshHitsOut() { return {hit.data(), back.data(), t.data(), face.data()}; }
};

TEST_P(Mesh, FirstHitFromOutsideIsAFrontAndFromInsideABack) {
    Random random(42);
    const Twins twin = twins(SolidKind::prism, 6, random);
    const MeshData& mesh = twin.mesh->solids[0].mesh;
    RayList rays;
    while (rays.size() < kLawRays / 2) {
        const Exact3 target = centre_of(*twin.half_spaces) + random.direction() * random.uniform(0, 0.3);
        const Exact3 from = target + random.direction() * (random.below(2) == 0 ? 5 : 0);
        rays.add(from, length(from - target) > 0 ? unit(target - from) : random.direction());
    }
    Answers both(rays.size()), front(rays.size()), back(rays.size());
    shapes().mesh(twin.mesh->triangles, mesh.count, Faces::both, rays, both);
    shapes().mesh(twin.mesh->triangles, mesh.count, Faces::entry, rays, front);
    shapes().mesh(twin.mesh->triangles, mesh.count, Faces::none, rays, back);
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const bool outside = length(rays.o[k] - centre_of(*twin.mesh)) > 2;
        ASSERT_EQ(both.hit[k], 1) << text(rays, k);
        ASSERT_EQ(both.back[k], outside ? 0 : 1) << text(rays, k);
        ASSERT_EQ(front.hit[k], outside ? 1 : 0) << text(rays, k);
        ASSERT_EQ(back.hit[k], 1) << text(rays, k);
        const Answers& named = outside ? front : back;
        ASSERT_EQ(both.t[k], named.t[k]) << text(rays, k);
        ASSERT_EQ(both.face[k], named.face[k]) << text(rays, k);
        const TriangleData& triangle = twin.mesh->triangles[static_cast<int>(both.face[k])];
        const Exact3 p = rays.o[k] + rays.d[k] * both.t[k];
        ASSERT_LE(std::abs(dot(exact(triangle.normal), p - exact(triangle.a))), 6 * kMeshRoundings * kU * 8)
            << text(rays, k);
        ASSERT_EQ(dot(exact(triangle.normal), rays.d[k]) < 0, outside) << text(rays, k);
    }
}

TEST_P(Mesh, EveryWidthGivesTheSameBits) {
    Random random(43);
    const Twins twin = twins(SolidKind::pyramid, 7, random);
    const MeshData& mesh = twin.mesh->solids[0].mesh;
    RayList rays;
    while (rays.size() < kLawRays / 2) add_ray_towards(rays, *twin.mesh, random, random.uniform(0, 4));
    Answers here(rays.size()), there(rays.size());
    shapes().mesh(twin.mesh->triangles, mesh.count, Faces::both, rays, here);
    scalar().shapes.mesh(twin.mesh->triangles, mesh.count, Faces::both, rays, there);
    expect_same_bits(here.hit, there.hit, "hit");
    expect_same_bits(here.back, there.back, "back");
    expect_same_bits(here.t, there.t, "t");
    expect_same_bits(here.face, there.face, "face");
}

ZERKALO_OVER_ALL_WIDTHS(Mesh);

}  // namespace
}  // namespace zerkalo::test
