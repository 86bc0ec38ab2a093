// From what a person writes to what a kernel reads: one solid, one mirror, one light at a time, in double. `to` rounds.
#pragma once

#include "core/render/constants.hpp"
#include "core/status.hpp"

namespace zerkalo {

/// A ball around an object, in world coordinates, exact to rounding.
struct Ball {
    Vec3<double> centre;
    double radius;
};

/// Corners whose convex hull contains a solid (a mesh: all its corners). At most 3 * kMaxTriangles.
struct Hull {
    std::int32_t count = 0;
    Vec3<double> points[3 * kMaxTriangles];
};

/// Unit axes and middle of a solid in world coordinates; the middle is half its height above the base.
struct Placement {
    Vec3<double> axis_x, axis_y, axis_z, middle;
};

Placement placement_of(const Solid& solid);

/// Two parallel planes that bound a solid, seen from its middle: lo <= n.p <= hi; lo = -infinity for a single one.
struct FacePair {
    Vec3<double> n;
    double lo, hi;
    std::int32_t index;  // of the face
};

/// The flat faces of a convex solid, at most kMaxSides + 1; returns how many. Not for meshes: none.
std::int32_t faces_of(const Solid& solid, FacePair* faces);

Ball ball_of(const Scene& scene, const Solid& solid);
void hull_of(const Scene& scene, const Solid& solid, Hull& hull);

/// Fills plan.solids[k] and the solid's share of the pools; `slabs`, `triangles`: pool entries in use, advanced.
template <class F>
void derive_solid(const Scene& scene, std::int32_t k, const Constants<F>& to, std::int32_t& slabs,
                  std::int32_t& triangles, PlanOf<F>& plan);

/// The corners and edges of a polyhedron, for the coverage of lobes.
void derive_outline(const Scene& scene, const Solid& solid, const Constants<FloatFormats>& to, Outline& out);

/// A lower bound of the distance from p to the solid's surface from outside, negative inside, and the outward normal of
/// the face that sets it. Not for meshes.
struct Clearance {
    double distance;
    Vec3<double> normal;
};
template <class F>
Clearance clearance_of(const PlanOf<F>& plan, const SolidPlanOf<F>& solid, const Constants<F>& to,
                       const Vec3<double>& p);

/// Is p inside of a convex solid, or nearer to it than a small share of its size?
template <class F>
bool near_or_inside(const PlanOf<F>& plan, const Constants<F>& to, const Vec3<double>& p);

/// The surface that the camera stands on, if any; needs the plan's solids and mirrors.
template <class F>
void derive_standing(const Scene& scene, const Constants<F>& to, PlanOf<F>& plan);

/// For a camera inside or close to solids: what spheres are from there, from double instead of float.
void derive_close_spheres(const Scene& scene, Plan& plan);

/// Right, v, n of a mirror.
struct MirrorFrame {
    Vec3<double> right, v, n;
};
MirrorFrame frame_of(const Mirror& mirror);
Ball ball_of(const Mirror& mirror);
void hull_of(const Mirror& mirror, Hull& hull);
template <class F>
void derive_mirror(const Mirror& mirror, const Rgb<double>& ambient, const PlanHead& plan, const Constants<F>& to,
                   MirrorPlanOf<F>& out);

/// The cone that holds the lobe rays of one pass, of a lobe cos^n; in a survey, those of any number of samples.
template <class F>
void derive_cone(double n, const PlanHead& plan, bool survey, const Constants<F>& to, LobeDataOf<F>& lobe);

/// Samples and rotation, and what depends on them: cones and first lattice points of the unpolished mirrors.
template <class F>
void place_lobe_rays(PlanOf<F>& plan, const Pass& pass);

/// Are they numbers of lobe rays and of a rotation?
Status check_pass(const Pass& pass);

template <class F>
LightDataOf<F> derive_light(const Light& light, const Constants<F>& to);
template <class F>
SurfaceDataOf<F> derive_surface(const Material& material, const Rgb<double>& ambient, const Constants<F>& to);

/// Slope of a tube's side: what its radius gains per unit of height.
double slope_of(const Solid& solid);

}  // namespace zerkalo
