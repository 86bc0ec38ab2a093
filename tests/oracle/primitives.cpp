#include "tests/oracle/primitives.hpp"

#include "tests/core/support/widths.hpp"

namespace zerkalo::test {
namespace {

double power_of_two(Random& random, double low, double high) { return std::exp2(random.uniform(low, high)); }

/// Judges by the closed form of one kind of solid: `data`, then the ray. Pointers in `data` must outlive the judge.
template <class... Data>
auto judge_of_solid(Real80 size, const Data&... data) {
    return [=](Tally& tally, const RayList& rays, const Answers& got, std::size_t k, Real80 rounding) {
        const Exact3 o = rays.o[k], d = rays.d[k];
        judge_span(
            tally, rays, got, k, size, rounding, [&](Real80 grow) { return exact_span(data..., o, d, grow); },
            [&](Real80 t, Real80 near) { return crossing_at(data..., o, d, t, near); });
    };
}

Instance instance_of(const Solid& solid) {
    const std::shared_ptr<Plan> plan = plan_of(solid);
    const SolidPlan& made = plan->solids[0];
    Instance instance;
    instance.centre = centre_of(*plan), instance.size = size_of(*plan);
    instance.ask = [plan](const probes::ShapeProbes& shapes, const RayList& rays) {
        return spans_of(shapes, *plan, rays);
    };
    if (made.shape == ShapeKind::sphere) instance.judge = judge_of_solid(instance.size, made.sphere);
    if (made.shape == ShapeKind::tube) instance.judge = judge_of_solid(instance.size, made.tube);
    if (made.shape == ShapeKind::half_spaces) {
        const Slab* slabs = plan->slabs;
        instance.judge = judge_of_solid(instance.size, slabs, made.half_spaces);
    }
    return instance;
}

Instance next_solid(Random& random, SolidKind kind) {
    Solid solid = placed(kind, random);
    if (random.below(4) == 0) solid.rotation = {0, 0, 0};
    solid.radius = power_of_two(random, -3, 3);
    solid.height = solid.radius * power_of_two(random, -3, 3);
    solid.sides = kMinSides + random.below(kMaxSides - kMinSides + 1);
    return instance_of(solid);
}

/// The middle of a tube's top, from the centre, in sizes.
Exact3 tip_of(const Solid& solid, const Instance& instance) {
    const TubeData tube = plan_of(solid)->solids[0].tube;
    const Exact3 tip = exact(tube.centre) + exact(tube.axis_y) * Real80(tube.half_height);
    return (tip - instance.centre) * (1 / instance.size);
}

/// A quarter of the rays pass its top, where a cone has its tip, from an eighth down to 1/4096 of its size away.
Instance next_tube(Random& random, double taper) {
    Solid solid = placed(SolidKind::cylinder, random);
    if (random.below(4) == 0) solid.rotation = {0, 0, 0};
    solid.radius = power_of_two(random, -3, 3);
    solid.height = solid.radius * power_of_two(random, -3, 3);
    solid.taper = taper;
    Instance instance = instance_of(solid);
    const Exact3 tip = tip_of(solid, instance);
    instance.aim = [tip](Random& r) {
        return r.below(4) == 0 ? tip + r.direction() * power_of_two(r, -12, -3) : ball_aim(r);
    };
    return instance;
}

Answers as_answers(const std::vector<float>& hit, const std::vector<float>& t) {
    Answers answers(hit.size());
    for (std::size_t k = 0; k < hit.size(); ++k) {
        answers.entry[k] = hit[k] != 0 ? t[k] : 1;
        answers.exit[k] = hit[k] != 0 ? t[k] : 0;
    }
    return answers;
}

SurfaceAnswer surface_answer(const Answers& answers, std::size_t k) {
    return {answers.entry[k] <= answers.exit[k], answers.entry[k]};
}

Answers ask_mirror(const MirrorShape& shape, probes::MirrorWay way, const probes::ShapeProbes& shapes,
                   const RayList& rays) {
    std::vector<float> hit(rays.size()), t(rays.size());
    PointList p(rays.size());
    shapes.mirror(shape, way, rays, {hit.data(), t.data(), p.x.data(), p.y.data(), p.z.data()});
    return as_answers(hit, t);
}

/// How far inside a rectangle or a disc a point of the tangent plane lies.
Real80 inside_by(const BoundaryData& boundary, Real80 x, Real80 y) {
    if (boundary.shape == BoundaryShape::disc) return 1 / Real80(boundary.inverse_a) - std::hypot(x, y);
    return std::min(boundary.half_width - std::abs(x), boundary.half_height - std::abs(y));
}

Instance instance_of(const Mirror& mirror, Real80 size) {
    const auto scene = std::make_unique<Scene>();
    const auto plan = std::make_unique<Plan>();
    scene->mirror_count = 1;
    scene->mirrors[0] = mirror;
    const Status status = prepare(*scene, Settings{}, *plan);
    EXPECT_TRUE(status.ok()) << status.field << " " << status.reason;
    const MirrorShape shape = plan->mirrors[0].shape;
    const auto way = shape.kappa == 0 ? probes::MirrorWay::plane : probes::MirrorWay::curved;
    Instance instance;
    instance.centre = exact(shape.vertex), instance.size = size;
    instance.ask = [=](const probes::ShapeProbes& shapes, const RayList& rays) {
        return ask_mirror(shape, way, shapes, rays);
    };
    instance.judge = [=](Tally& tally, const RayList& rays, const Answers& got, std::size_t k, Real80 rounding) {
        const auto outline = [&](Real80 x, Real80 y) { return inside_by(shape.boundary, x, y); };
        judge_surface(tally, rays, k, surface_answer(got, k),
                      mirror_crossings(shape, rays.o[k], rays.d[k], outline), size, rounding);
    };
    return instance;
}

Mirror next_mirror(Random& random) {
    Mirror mirror;
    mirror.position = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    mirror.normal = rounded_to_double(random.direction());
    return mirror;
}

Instance next_plane_mirror(Random& random) {
    Mirror mirror = next_mirror(random);
    const double width = power_of_two(random, -3, 3), height = width * power_of_two(random, -2, 2);
    mirror.boundary = {.shape = BoundaryShape::rectangle, .width = width, .height = height};
    return instance_of(mirror, std::hypot(width, height) / 2);
}

/// Hollow and bulging, R from 1/8 to 2^20, with a disc of up to 0.9 R but at most 1.
Instance next_curved_mirror(Random& random) {
    Mirror mirror = next_mirror(random);
    const double radius = power_of_two(random, -3, random.below(2) == 0 ? 2 : 20);
    mirror.curvature_radius = random.below(2) == 0 ? radius : -radius;
    mirror.boundary = {.shape = BoundaryShape::disc, .radius = std::min(1.0, random.uniform(0.1, 0.9) * radius)};
    return instance_of(mirror, mirror.boundary.radius * std::sqrt(2.0L));
}

/// No triangle is flatter than one fifth of its longest edge: the error of the method grows as that share falls.
Instance next_triangle(Random& random) {
    const Real80 scale = power_of_two(random, -3, 3);
    Exact3 a, ab, ac;
    Real80 longest = 0;
    do {
        a = random.direction() * scale;
        ab = random.direction() * scale - a, ac = random.direction() * scale - a;
        longest = std::max({length(ab), length(ac), length(ac - ab)});
    } while (length(cross(ab, ac)) < longest * longest / 5);
    const Vec3<float> edge_ab = rounded_to_float(ab), edge_ac = rounded_to_float(ac);
    const TriangleData triangle{rounded_to_float(a), edge_ab, edge_ac, {}};
    Instance instance;
    instance.centre = exact(triangle.a) + (exact(edge_ab) + exact(edge_ac)) * (1 / 3.0L);
    instance.size = longest;
    instance.aim = [=](Random& r) {
        return (ab * r.uniform(-0.6, 0.9) + ac * r.uniform(-0.6, 0.9)) * (1 / longest);
    };
    instance.ask = [=](const probes::ShapeProbes& shapes, const RayList& rays) {
        std::vector<float> hit(rays.size()), back(rays.size()), t(rays.size()), face(rays.size());
        shapes.mesh(&triangle, 1, Faces::both, rays, {hit.data(), back.data(), t.data(), face.data()});
        return as_answers(hit, t);
    };
    instance.judge = [=](Tally& tally, const RayList& rays, const Answers& got, std::size_t k, Real80 rounding) {
        judge_surface(tally, rays, k, surface_answer(got, k), triangle_crossings(triangle, rays.o[k], rays.d[k]),
                      longest, rounding);
    };
    return instance;
}

}  // namespace

const std::vector<Primitive>& primitives() {
    static const std::vector<Primitive> all = {
        {"sphere", [](Random& r) { return next_solid(r, SolidKind::sphere); }},
        {"cylinder", [](Random& r) { return next_tube(r, 1); }, 5},
        {"cone", [](Random& r) { return next_tube(r, 0); }, 5},
        {"frustum", [](Random& r) { return next_tube(r, power_of_two(r, -3, 2)); }, 5},
        {"prism", [](Random& r) { return next_solid(r, SolidKind::prism); }},
        {"pyramid", [](Random& r) { return next_solid(r, SolidKind::pyramid); }},
        {"plane_mirror", next_plane_mirror},
        {"curved_mirror", next_curved_mirror},
        {"triangle", next_triangle},
    };
    return all;
}

void fill_rays(RayList& rays, const Instance& instance, std::size_t count, Random& random) {
    rays = {};
    while (rays.size() < count) {
        const Exact3 aim = instance.aim(random) * instance.size;
        if (is_recentred(rays.size())) {
            const Exact3 d = random.direction();
            rays.add(instance.centre + aim - d * dot(aim, d), d);
            continue;
        }
        const Real80 distance = instance.size * std::exp2(random.uniform(0, 10));
        // The origin that counts is the rounded one.
        const Exact3 o = exact(rounded_to_float(instance.centre + random.direction() * distance));
        rays.add(o, unit(instance.centre + aim - o));
    }
}

}  // namespace zerkalo::test
