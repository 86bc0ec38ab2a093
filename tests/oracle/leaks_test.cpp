// Rays aimed from outside at edges and vertices of prisms and pyramids: none passes the solid where it is thick.
#include "tests/core/support/meshes.hpp"
#include "tests/core/support/solids.hpp"
#include "tests/core/support/widths.hpp"
#include "tests/oracle/ray_count.hpp"

#include <iostream>

namespace zerkalo::test {
namespace {

constexpr std::size_t kBatch = 4096;
// Roundings of the way by which the solid is shrunk before a miss counts as a leak (as kBand of primitives_test.cpp).
constexpr Real80 kThick = 4;

/// Corners of base and top, in double, as the scene's own words place them.
struct Corners {
    std::vector<Vec3<double>> base, top;
};

Vec3<double> turned(const Vec3<double>& p, const Vec3<double>& angle) {
    const double cx = std::cos(angle.x), sx = std::sin(angle.x), cy = std::cos(angle.y), sy = std::sin(angle.y);
    const double cz = std::cos(angle.z), sz = std::sin(angle.z);
    const Vec3<double> a{p.x, cx * p.y - sx * p.z, sx * p.y + cx * p.z};
    const Vec3<double> b{cy * a.x + sy * a.z, a.y, cy * a.z - sy * a.x};
    return {cz * b.x - sz * b.y, sz * b.x + cz * b.y, b.z};
}

Corners corners_of(const Solid& solid) {
    Corners corners;
    const double top_radius = solid.kind == SolidKind::prism ? solid.radius : 0;
    for (int k = 0; k < solid.sides; ++k) {
        const double angle = 2 * 3.14159265358979323846 * k / solid.sides;
        const auto at = [&](double radius, double y) {
            const Vec3<double> p = turned({radius * std::cos(angle), y, radius * std::sin(angle)}, solid.rotation);
            return Vec3<double>{p.x + solid.position.x, p.y + solid.position.y, p.z + solid.position.z};
        };
        corners.base.push_back(at(solid.radius, 0));
        corners.top.push_back(at(top_radius, solid.height));
    }
    return corners;
}

/// A point of an edge of base, top or side, or of a side's diagonal, where a mesh has an edge; one in four is a corner.
Vec3<double> point_to_aim_at(const Corners& corners, Random& random) {
    const auto k = static_cast<std::size_t>(random.below(static_cast<int>(corners.base.size())));
    const std::size_t next = (k + 1) % corners.base.size();
    const Vec3<double> ends[][2] = {{corners.base[k], corners.base[next]},
                                    {corners.top[k], corners.top[next]},
                                    {corners.base[k], corners.top[k]},
                                    {corners.base[next], corners.top[k]}};
    const auto& [a, b] = ends[random.below(4)];
    const double s = random.below(4) == 0 ? random.below(2) : random.uniform(0, 1);
    return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)};
}

/// Rays from outside the bounding ball, up to 2^6 sizes away; the direction is rounded from double.
void aim(RayList& rays, const Plan& plan, const Corners& corners, Random& random) {
    rays = {};
    while (rays.size() < kBatch) {
        const Real80 distance = size_of(plan) * std::exp2(random.uniform(0.1, 6));
        const Vec3<float> o = rounded_to_float(centre_of(plan) + random.direction() * distance);
        const Vec3<double> to = point_to_aim_at(corners, random);
        const Vec3<double>& origin = plan.origin;
        const double x = to.x - origin.x - o.x, y = to.y - origin.y - o.y, z = to.z - origin.z - o.z;
        const double norm = std::sqrt(x * x + y * y + z * z);
        rays.add(exact(o), {x / norm, y / norm, z / norm});
    }
}

Solid polyhedron(SolidKind kind, int sides, Random& random) {
    Solid solid = placed(kind, random);
    solid.sides = sides;
    solid.radius = std::exp2(random.uniform(-3, 3));
    solid.height = solid.radius * std::exp2(random.uniform(-3, 3));
    return solid;
}

struct Aimed {
    std::uint64_t rays = 0, missed = 0, sampled = 0, thick = 0;
};

/// Does the ray pass through where the solid is thick? Then it must not miss.
bool is_thick(const Plan& plan, const RayList& rays, std::size_t k) {
    const Real80 way = length(rays.o[k] - centre_of(plan)) + size_of(plan);
    return !exact_span(plan, rays.o[k], rays.d[k], -kThick * kU * way).empty();
}

void expect_no_leak(const Plan& plan, const RayList& rays, const SpanList& spans, Aimed& aimed, int sides) {
    for (std::size_t k = 0; k < rays.size(); ++k) {
        ++aimed.rays;
        // A share of the rays shows how many of them count.
        constexpr std::size_t kSample = 64;
        if (k % kSample == 0) ++aimed.sampled, aimed.thick += is_thick(plan, rays, k);
        if (spans.entry[k] <= spans.exit[k]) continue;
        ++aimed.missed;
        ASSERT_FALSE(is_thick(plan, rays, k)) << text(rays, k) << " leaks, sides " << sides;
    }
}

const probes::ShapeProbes& widest_shapes() {
    const Width* widest = nullptr;
    static const std::vector<Width> widths = all_widths();
    for (const Width& width : widths) {
        if (available(width.isa) && (!widest || width.probes->width >= widest->probes->width)) widest = &width;
    }
    return widest->probes->shapes;
}

// All widths give the same bits (half_spaces_test.cpp), so the widest speaks for all.
TEST(Leaks, NoRayAtAnEdgeOrVertexPassesThroughAPrismOrPyramid) {
    const std::uint64_t wanted = count_from("ZERKALO_LEAK_RAYS");
    Random random(91);
    RayList rays;
    Aimed aimed;
    // Every number of sides of both kinds in turn.
    for (int turn = 0; aimed.rays < wanted; ++turn) {
        const int sides = kMinSides + turn / 2 % (kMaxSides - kMinSides + 1);
        const Solid solid = polyhedron(turn % 2 == 0 ? SolidKind::prism : SolidKind::pyramid, sides, random);
        const auto plan = plan_of(solid);
        aim(rays, *plan, corners_of(solid), random);
        expect_no_leak(*plan, rays, spans_of(widest_shapes(), *plan, rays), aimed, sides);
        if (HasFatalFailure()) return;
    }
    std::cout << aimed.rays << " rays aimed, " << aimed.missed << " passed by" << std::endl;
    EXPECT_GT(aimed.thick, aimed.sampled / 2) << "so few would say little";
    EXPECT_GT(aimed.missed, aimed.rays / 50) << "so few along the silhouette would say little";
}

// The naive twin: the same solid as triangles, each with a test of its own, leaks where two of them meet.
TEST(Leaks, TheSameRaysLeakThroughTriangles) {
    Random random(92);
    RayList rays;
    std::size_t leaks = 0;
    for (const int sides : {4, 6, 17}) {
        const Solid solid = polyhedron(SolidKind::prism, sides, random);
        Solid whole = solid;
        whole.position = {0, 0, 0}, whole.rotation = {0, 0, 0};
        const std::vector<Triangle> triangles = triangles_of(whole);
        const auto plan = plan_of(solid), mesh = plan_of(meshed(solid, triangles), triangles);
        aim(rays, *plan, corners_of(solid), random);
        const SpanList spans = spans_of(widest_shapes(), *mesh, rays);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            leaks += !(spans.entry[k] < spans.exit[k]) && is_thick(*plan, rays, k);
        }
    }
    std::cout << leaks << " leaks of " << 3 * kBatch << " rays" << std::endl;
    EXPECT_GT(leaks, 0u) << "the twin must fail, or the rays above show nothing";
}

}  // namespace
}  // namespace zerkalo::test
