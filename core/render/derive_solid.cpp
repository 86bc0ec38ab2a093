#include "core/render/derive.hpp"

namespace zerkalo {
namespace {

constexpr double kReachRoom = 0x1p-10;

bool is_tube(const Solid& solid) { return solid.kind == SolidKind::cylinder || solid.kind == SolidKind::cone; }

Point mesh_corner(const Solid& solid, const Point& p) {
    return rotated(p * solid.scale, solid.rotation) + solid.position;
}

/// Cosine and sine at half-step h of n sides: the angle pi h / n.
SetupSineCosine corner_angle(std::int32_t half_steps, std::int32_t sides) {
    return sine_cosine(kPi * half_steps / sides);
}

Point around(const Placement& at, SetupSineCosine angle, double radius, double y) {
    return at.middle + at.axis_x * (radius * angle.cosine) + at.axis_z * (radius * angle.sine) + at.axis_y * y;
}

struct FaceWriter {
    FacePair* next;
    std::int32_t count = 0;

    void add(const Point& n, double lo, double hi) {
        next[count] = {n, lo, hi, count};
        ++count;
    }
};

/// The side faces of a pyramid, in its own axes: n = (outward cos a, upward, outward sin a), n.p = offset from the
/// middle.
struct SideFaces {
    double outward, upward, offset;
};

SideFaces side_faces(const Solid& pyramid) {
    const double apothem = pyramid.radius * corner_angle(1, pyramid.sides).cosine;
    const double slant = length({apothem, pyramid.height, 0});
    return {pyramid.height / slant, apothem / slant, pyramid.height / slant * apothem / 2};
}

// A normal's components are rounded to 2^-25, a point's product with it to some more: a face that leans outward by less
// than kFlat has lost its slope, one that leans upward by less than kSteep does not meet its neighbours at the apex.
constexpr double kFaceRounding = 0x1p-22;
constexpr double kFlat = 0x1p-11, kLow = 0x1p-5, kSteep = 0x1p-5;

/// A pyramid this flat is drawn as the prism of its height: off by less than 2^-11 of its radius.
bool is_flat(const Solid& solid) { return solid.kind == SolidKind::pyramid && side_faces(solid).outward < kFlat; }

/// How far rounding may carry the side faces of a low pyramid outwards, as a share of its radius.
double overhang(const Solid& solid) {
    if (solid.kind != SolidKind::pyramid || is_flat(solid)) return 0;
    const double outward = side_faces(solid).outward;
    return outward < kLow ? kFaceRounding / outward : 0;
}

double top_radius(const Solid& solid) {
    if (solid.kind == SolidKind::pyramid) return is_flat(solid) ? solid.radius : 0;
    return is_tube(solid) ? solid.radius * solid.taper : solid.radius;
}

/// Even prisms pair their opposite sides into slabs; odd ones have single half-spaces.
void write_prism(const Solid& solid, const Placement& at, FaceWriter& out) {
    const double apothem = solid.radius * corner_angle(1, solid.sides).cosine;
    const bool even = solid.sides % 2 == 0;
    for (std::int32_t k = 0; k < (even ? solid.sides / 2 : solid.sides); ++k) {
        const SetupSineCosine angle = corner_angle(2 * k + 1, solid.sides);
        out.add(at.axis_x * angle.cosine + at.axis_z * angle.sine, even ? -apothem : -kInfinity, apothem);
    }
    out.add(at.axis_y, -solid.height / 2, solid.height / 2);
}

void write_pyramid(const Solid& solid, const Placement& at, FaceWriter& out) {
    const SideFaces sides = side_faces(solid);
    for (std::int32_t k = 0; k < solid.sides; ++k) {
        const SetupSineCosine angle = corner_angle(2 * k + 1, solid.sides);
        const Point n = at.axis_x * (sides.outward * angle.cosine) + at.axis_z * (sides.outward * angle.sine) +
                        at.axis_y * sides.upward;
        out.add(n, -kInfinity, sides.offset);
    }
    // Above the apex, where rounding may have opened it.
    const double lid = sides.upward < kSteep ? solid.height / 2 * (1 + 0x1p-17) : kInfinity;
    out.add(at.axis_y, -solid.height / 2, lid);
}

template <class F>
void write_half_spaces(const Solid& solid, const Placement& at, const Constants<F>& to, std::int32_t first,
                       PlanOf<F>& plan, HalfSpacesDataOf<F>& out) {
    FacePair faces[kMaxSides + 1];
    const std::int32_t count = faces_of(solid, faces);
    out = {to.point(at.middle), first, count, {}};
    for (std::int32_t s = 0; s < count; ++s) {
        const auto n = to.direction(faces[s].n);
        plan.slabs[first + s] = {n, to.length(faces[s].lo), to.length(faces[s].hi), typename F::Index(faces[s].index)};
        if (s < kListedFaces) out.normals.x[s] = n.x, out.normals.y[s] = n.y, out.normals.z[s] = n.z;
    }
}

template <class F>
TubeDataOf<F> tube_of(const Solid& solid, const Placement& at, const Constants<F>& to) {
    const double slope = slope_of(solid);
    TubeDataOf<F> tube{};
    tube.centre = to.point(at.middle);
    // Around its own axis a tube looks the same from all sides: an upright one needs no rotation, and has none.
    tube.upright = at.axis_y.x == 0 && at.axis_y.z == 0 && at.axis_y.y == 1;
    tube.axis_x = to.direction(tube.upright ? Point{1, 0, 0} : at.axis_x), tube.axis_y = to.direction(at.axis_y);
    tube.axis_z = to.direction(tube.upright ? Point{0, 0, 1} : at.axis_z);
    tube.mid_radius = to.length((solid.radius + top_radius(solid)) / 2);
    tube.slope = to.ratio(slope);
    tube.half_height = to.length(solid.height / 2);
    tube.normal_scale = to.component(1 / length({1, slope, 0}));
    tube.tapered = tube.slope != typename F::Ratio(0);
    if constexpr (F::kFixed) {
        const double widest = solid.radius > top_radius(solid) ? solid.radius : top_radius(solid);
        const double reach = length({widest, solid.height / 2, 0}) * (1 + kReachRoom);
        tube.reach2 = to.area(reach * reach);
    }
    return tube;
}

template <class F>
MeshData write_mesh(const Scene& scene, const Solid& solid, const Constants<F>& to, std::int32_t first,
                    TriangleDataOf<F>* out) {
    for (std::int32_t k = 0; k < solid.triangle_count; ++k) {
        const Triangle& t = scene.triangles[solid.first_triangle + k];
        const Point a = mesh_corner(solid, t.a), b = mesh_corner(solid, t.b), c = mesh_corner(solid, t.c);
        out[first + k] = {to.point(a), to.way(b - a), to.way(c - a), to.direction(unit(cross(b - a, c - a)))};
    }
    return {first, solid.triangle_count};
}

}  // namespace

double slope_of(const Solid& solid) { return (top_radius(solid) - solid.radius) / solid.height; }

Placement placement_of(const Solid& solid) {
    Placement at;
    at.axis_x = rotated({1, 0, 0}, solid.rotation);
    at.axis_y = rotated({0, 1, 0}, solid.rotation);
    at.axis_z = rotated({0, 0, 1}, solid.rotation);
    const bool has_base = solid.kind != SolidKind::sphere && solid.kind != SolidKind::mesh;
    at.middle = has_base ? solid.position + at.axis_y * (solid.height / 2) : solid.position;
    return at;
}

std::int32_t faces_of(const Solid& solid, FacePair* faces) {
    const Placement at = placement_of(solid);
    FaceWriter writer{faces};
    if (solid.kind == SolidKind::prism || is_flat(solid)) {
        write_prism(solid, at, writer);
    } else if (solid.kind == SolidKind::pyramid) {
        write_pyramid(solid, at, writer);
    }
    if (is_tube(solid)) {
        faces[0] = {at.axis_y, -solid.height / 2, solid.height / 2, kCapFace};
        writer.count = 1;
    }
    return writer.count;
}

void hull_of(const Scene& scene, const Solid& solid, Hull& hull) {
    hull.count = 0;
    if (solid.kind == SolidKind::mesh) {
        for (std::int32_t k = 0; k < solid.triangle_count; ++k) {
            const Triangle& t = scene.triangles[solid.first_triangle + k];
            for (const Point& p : {t.a, t.b, t.c}) hull.points[hull.count++] = mesh_corner(solid, p);
        }
        return;
    }
    const Placement at = placement_of(solid);
    const double half = solid.kind == SolidKind::sphere ? solid.radius : solid.height / 2;
    // Round outlines lie inside the octagon around them.
    const bool is_round = solid.kind == SolidKind::sphere || is_tube(solid);
    const std::int32_t corners = is_round ? 8 : solid.sides;
    const double widen = is_round ? 1 / corner_angle(1, 8).cosine : 1 + overhang(solid);
    for (std::int32_t k = 0; k < corners; ++k) {
        const SetupSineCosine angle = corner_angle(2 * k, corners);
        hull.points[hull.count++] = around(at, angle, solid.radius * widen, -half);
        hull.points[hull.count++] = around(at, angle, top_radius(solid) * widen, half);
    }
}

Ball ball_of(const Scene& scene, const Solid& solid) {
    const Placement at = placement_of(solid);
    if (solid.kind == SolidKind::sphere) return {solid.position, solid.radius};
    if (solid.kind == SolidKind::mesh) {
        Point low = mesh_corner(solid, scene.triangles[solid.first_triangle].a), high = low;
        const auto each_corner = [&](auto visit) {
            for (std::int32_t k = 0; k < solid.triangle_count; ++k) {
                const Triangle& t = scene.triangles[solid.first_triangle + k];
                for (const Point& p : {t.a, t.b, t.c}) visit(mesh_corner(solid, p));
            }
        };
        each_corner([&](const Point& p) {
            low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z};
            high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y, p.z > high.z ? p.z : high.z};
        });
        Ball ball{(low + high) * 0.5, 0};
        each_corner([&](const Point& p) {
            const double r = length(p - ball.centre);
            if (r > ball.radius) ball.radius = r;
        });
        return ball;
    }
    // The smallest ball around two coaxial circles: its centre on the axis, as far from both rims as it can be.
    const double r0 = solid.radius * (1 + overhang(solid)), r1 = top_radius(solid), h = solid.height;
    double y = (h + (r1 - r0) * ((r1 + r0) / h)) / 2;
    y = y < 0 ? 0 : y > h ? h : y;
    const double to_base = length({r0, y, 0}), to_top = length({r1, h - y, 0});
    return {at.middle + at.axis_y * (y - h / 2), to_base > to_top ? to_base : to_top};
}

template <class F>
void derive_solid(const Scene& scene, std::int32_t k, const Constants<F>& to, std::int32_t& slabs,
                  std::int32_t& triangles, PlanOf<F>& plan) {
    const Solid& solid = scene.solids[k];
    const Placement at = placement_of(solid);
    SolidPlanOf<F>& out = plan.solids[k];
    out = SolidPlanOf<F>{};
    out.id = typename F::Index(k);
    if (solid.kind == SolidKind::sphere) {
        out.shape = ShapeKind::sphere;
        out.sphere = {to.point(solid.position), to.area(solid.radius * solid.radius), to.inverse(1 / solid.radius)};
    } else if (is_tube(solid)) {
        out.shape = ShapeKind::tube;
        out.tube = tube_of(solid, at, to);
    } else if (solid.kind == SolidKind::mesh) {
        out.shape = ShapeKind::mesh;
        out.mesh = write_mesh(scene, solid, to, triangles, plan.triangles);
        triangles += solid.triangle_count;
    } else {
        out.shape = ShapeKind::half_spaces;
        write_half_spaces(solid, at, to, slabs, plan, out.half_spaces);
        slabs += out.half_spaces.slab_count;
    }
    const Material& m = solid.material;
    out.surface = derive_surface(m, scene.ambient, to);
    out.transport = {to.weight(m.reflection), to.weight(m.transmission), to.ratio(1 / m.refractive_index),
                     to.ratio(m.refractive_index), m.fresnel};
}

template void derive_solid(const Scene&, std::int32_t, const Constants<FloatFormats>&, std::int32_t&, std::int32_t&,
                           Plan&);
template void derive_solid(const Scene&, std::int32_t, const Constants<DoubleFormats>&, std::int32_t&, std::int32_t&,
                           DoublePlan&);
template void derive_solid(const Scene&, std::int32_t, const Constants<FixedFormats>&, std::int32_t&, std::int32_t&,
                           FixedPlan&);

}  // namespace zerkalo
