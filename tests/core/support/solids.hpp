// One solid of a scene as the kernels see it, and rays towards it.
#pragma once

#include "core/render/render.hpp"
#include "tests/core/support/nested.hpp"
#include "tests/core/support/random.hpp"

#include <memory>

namespace zerkalo::test {

/// A plan with this one solid (and the triangles it refers to); fails the test where prepare() refuses.
inline std::unique_ptr<Plan> plan_of(const Solid& solid, const std::vector<Triangle>& triangles = {}) {
    const auto scene = std::make_unique<Scene>();
    auto plan = std::make_unique<Plan>();
    scene->solid_count = 1;
    scene->solids[0] = solid;
    scene->triangle_count = static_cast<std::int32_t>(triangles.size());
    std::copy(triangles.begin(), triangles.end(), scene->triangles);
    const Status status = prepare(*scene, Settings{}, *plan);
    EXPECT_TRUE(status.ok()) << status.field << " " << status.reason;
    return plan;
}

/// A random placement near the origin.
inline Solid placed(SolidKind kind, Random& random) {
    Solid solid;
    solid.kind = kind;
    solid.position = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    solid.rotation = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
    if (kind == SolidKind::cone) solid.taper = 0;
    return solid;
}

inline Exact3 centre_of(const Plan& plan) { return exact(plan.solids[0].bound_centre); }
inline Real80 size_of(const Plan& plan) { return plan.solids[0].bound_radius; }

/// A ray from `distance` sizes away (in a random direction) to a random point of a ball somewhat larger than the solid.
inline void add_ray_towards(RayList& rays, const Plan& plan, Random& random, Real80 distance) {
    const Exact3 from = centre_of(plan) + random.direction() * (distance * size_of(plan));
    const Exact3 to = centre_of(plan) + random.direction() * (1.3L * size_of(plan) * std::cbrt(random.uniform(0, 1)));
    // The origin that counts is the rounded one.
    const Exact3 o = exact(rounded_to_float(from));
    rays.add(o, unit(to - o));
}

/// The spans of the plan's only solid, whatever its kind; meshes by their front and their back.
inline SpanList spans_of(const probes::ShapeProbes& shapes, const Plan& plan, const RayList& rays) {
    SpanList spans(rays.size());
    const SolidPlan& solid = plan.solids[0];
    if (solid.shape == ShapeKind::sphere) shapes.sphere(solid.sphere, rays, spans);
    if (solid.shape == ShapeKind::tube) shapes.tube(solid.tube, Faces::both, rays, spans);
    if (solid.shape == ShapeKind::half_spaces) {
        shapes.half_spaces(plan.slabs, solid.half_spaces, Faces::both, rays, spans);
    }
    if (solid.shape == ShapeKind::mesh) {
        std::vector<float> front(rays.size()), back(rays.size()), unused(rays.size());
        const TriangleData* first = plan.triangles + solid.mesh.first;
        const int count = solid.mesh.count;
        shapes.mesh(first, count, Faces::entry, rays,
                    {front.data(), unused.data(), spans.entry.data(), spans.face_in.data()});
        shapes.mesh(first, count, Faces::none, rays,
                    {back.data(), unused.data(), spans.exit.data(), spans.face_out.data()});
        for (std::size_t k = 0; k < rays.size(); ++k) {
            if (front[k] == 0 || back[k] == 0) spans.entry[k] = 0, spans.exit[k] = 0;
        }
    }
    return spans;
}

inline ExactSpan exact_span(const Plan& plan, const Exact3& o, const Exact3& d, Real80 grow) {
    const SolidPlan& solid = plan.solids[0];
    if (solid.shape == ShapeKind::sphere) return exact_span(solid.sphere, o, d, grow);
    if (solid.shape == ShapeKind::tube) return exact_span(solid.tube, o, d, grow);
    return exact_span(plan.slabs, solid.half_spaces, o, d, grow);
}

/// The nested-span law for the plan's only solid, with `roundings` of the way from the origin to its far end.
inline void expect_exact_spans(const probes::ShapeProbes& shapes, const Plan& plan, const RayList& rays,
                               Real80 roundings, Outcome& outcome) {
    expect_nested(
        rays, spans_of(shapes, plan, rays),
        [&](std::size_t k, Real80 grow) { return exact_span(plan, rays.o[k], rays.d[k], grow); },
        [&](std::size_t k) { return roundings * kU * (length(rays.o[k] - centre_of(plan)) + size_of(plan)); }, outcome);
}

}  // namespace zerkalo::test
