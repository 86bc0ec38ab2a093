// Culling data of a plan: which pixels an object can touch, and what can stand between a light and a surface.
// Everything here is conservative: it may keep what is not needed, it never drops what is.
#pragma once

#include "core/render/derive.hpp"

namespace zerkalo {

/// The camera of set-up: exact position and frame, in double.
struct Viewpoint {
    Vec3<double> position, view, right, up;
    double tan_half_width, tan_half_height;
    std::int32_t width, height;
};

/// Where everything is, for culling.
struct Surroundings {
    Ball solids[kMaxSolids];
    Ball mirrors[kMaxMirrors];
    Ball all;
};

PixelBounds whole_picture(const Viewpoint& eye);

/// Pixels on which a hull can appear; the whole picture where a corner is beside or behind the eye.
PixelBounds bounds_of_hull(const Viewpoint& eye, const Hull& hull);

/// Exact outline of a ball, rounded outwards to pixels.
PixelBounds bounds_of_ball(const Viewpoint& eye, const Ball& ball);

/// Fills plan.solid_bounds and mirror_bounds.
template <class F>
void derive_bounds(const Scene& scene, const Viewpoint& eye, PlanOf<F>& plan);

/// Fills plan.shadow_bounds.
template <class F>
void derive_shadow_bounds(const Scene& scene, const Viewpoint& eye, PlanOf<F>& plan);

/// Fills plan.image_bounds.
void derive_image_bounds(const Scene& scene, const Viewpoint& eye, Plan& plan);

/// Fills the blockers of solids and mirrors.
template <class F>
void derive_blockers(const Scene& scene, const Surroundings& around, PlanOf<F>& plan);

/// Fills the bounds that the lights see.
void derive_light_bounds(const Scene& scene, const Constants<FloatFormats>& to, Plan& plan);

}  // namespace zerkalo
