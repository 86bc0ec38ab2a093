#include "core/numeric/float_mode.hpp"
#include "core/optics/lobe_profile.hpp"
#include "core/render/cull.hpp"
#include "core/render/derive_planes.hpp"
#include "core/render/fit.hpp"
#include "core/render/lattice_chunk.hpp"
#include "core/render/meet.hpp"
#include "core/render/render.hpp"
#include "core/render/surroundings.hpp"
#include "core/scene/validate.hpp"

namespace zerkalo {
namespace {

Status check(const Settings& settings, const ImageSize& size) {
    const auto complain = [](const char* field, const char* why) { return Status{field, why, Part::settings, 0}; };
    if (size.width < 1 || size.width > kMaxImageSide) return complain("width", "must lie in 1..65536");
    if (size.height < 1 || size.height > kMaxImageSide) return complain("height", "must lie in 1..65536");
    if (std::int64_t{size.width} * size.height > kMaxPixels) {
        return complain("height", "times width must be at most 2^28 pixels");
    }
    if (const Status status = check_pass({settings.samples, settings.rotation}); !status.ok()) return status;
    const std::int32_t rays = settings.antialias, edge_rays = settings.edge_antialias, depth = settings.depth_limit;
    if (rays < 1 || rays > kMaxAntialias) return complain("antialias", "must lie in 1..4096");
    if (edge_rays < 0 || edge_rays > kMaxAntialias) return complain("edge_antialias", "must lie in 0..4096");
    if (edge_rays > 0 && rays > 1) return complain("edge_antialias", "needs antialias = 1 elsewhere");
    if (depth < 0 || depth > kMaxDepth) return complain("depth_limit", "must lie in 0..255");
    if (static_cast<int>(settings.estimator) >= kEstimatorCount) return complain("estimator", "is none of the list");
    return kOk;
}

/// Seed formulas 2.5-2.8 with the full angle; the angle that is not given follows from the picture's size.
Viewpoint viewpoint_of(const Camera& camera, const ImageSize& size) {
    Viewpoint eye;
    eye.position = camera.position;
    eye.view = unit(camera.view);
    eye.right = unit(cross(eye.view, usable_up(eye.view, camera.up)));
    eye.up = cross(eye.right, eye.view);
    eye.width = size.width, eye.height = size.height;
    const SetupSineCosine half = sine_cosine(camera.fov / 2);
    const double given = half.sine / half.cosine;
    const bool horizontal = camera.fov_axis == FovAxis::horizontal;
    eye.tan_half_width = horizontal ? given : given * size.width / size.height;
    eye.tan_half_height = horizontal ? given * size.height / size.width : given;
    return eye;
}

/// Seed formulas 2.9, 2.10. A far camera's rays start on the plane through the scene's centre: see CameraPlan.
template <class F>
void derive_camera(const Viewpoint& eye, const Surroundings& around, const Constants<F>& to, PlanOf<F>& plan) {
    const Point step_x = eye.right * (eye.tan_half_width / eye.width);
    const Point step_y = eye.up * (eye.tan_half_height / eye.height);
    const double pull = pull_of(eye, around);
    if (is_far(eye.position, around)) plan.features |= kFeatureFar;
    const double scale = to.view_scale(length({1, eye.tan_half_width, eye.tan_half_height}));
    CameraPlanOf<F>& camera = plan.camera;
    camera.view = to.view(eye.view * scale);
    camera.step_x = to.view(step_x * scale), camera.step_y = to.view(step_y * scale);
    camera.origin = to.point(eye.position + eye.view * pull);
    camera.origin_step_x = to.far_step(step_x * pull), camera.origin_step_y = to.far_step(step_y * pull);
    camera.pull = to.pull(pull / scale);
}

void derive_tile_corners(Plan& plan) {
    TileCorners& corners = plan.tile_corners;
    float reach2 = 0;
    for (std::int32_t lane = 0; lane < kWidestLane; ++lane) {
        const float right = lane & 1 ? kTileSide : -kTileSide, up = lane & 2 ? kTileSide : -kTileSide;
        const Vec3<float> off = plan.camera.step_x * right + plan.camera.step_y * up;
        corners.x[lane] = off.x, corners.y[lane] = off.y, corners.z[lane] = off.z;
        corners.fall[lane] = -dot(plan.mirrors[0].shape.n, off);
        reach2 = max(reach2, dot(off, off));
    }
    corners.reach = float(square_root(double(reach2)));
}

/// What all rays from one origin have in common, in the kernels' own arithmetic.
template <class F>
void derive_shared(const PlanOf<F>& plan, const Vec3<typename F::Length>& point, SharedOriginOf<F>& out) {
    using N = typename SetUpNumbers<F>::type;
    for (std::int32_t k = 0; k < plan.solid_count; ++k) {
        const SolidPlanOf<F>& solid = plan.solids[k];
        SharedSolidOf<F>& shared = out.solids[k];
        shared = {point, typename F::Area(0)};
        if (solid.shape == ShapeKind::sphere) {
            const auto from = sphere_seen_from<N>(solid.sphere, point);
            shared = {from.f, from.c};
        } else if (solid.shape == ShapeKind::tube) {
            shared.from = tube_seen_from<N>(solid.tube, point);
        } else if (solid.shape == ShapeKind::half_spaces) {
            const HalfSpacesDataOf<F>& body = solid.half_spaces;
            const auto o = point - body.centre;
            for (std::int32_t s = body.first_slab; s < body.first_slab + body.slab_count; ++s) {
                const auto from = slab_seen_from<N>(plan.slabs[s], o);
                out.slabs[s] = {from.lo, from.hi};
            }
        }
    }
    for (std::int32_t m = 0; m < plan.mirror_count; ++m) {
        out.mirrors[m] = mirror_seen_from<N>(plan.mirrors[m].shape, point);
    }
}

template <class F>
void derive_objects(const Scene& scene, const Surroundings& around, const Constants<F>& to, PlanOf<F>& plan) {
    std::int32_t slabs = 0, triangles = 0;
    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        derive_solid(scene, k, to, slabs, triangles, plan);
        SolidPlanOf<F>& solid = plan.solids[k];
        solid.bound_centre = to.point(around.solids[k].centre);
        // Room for the rounding of coordinates as large as the scene.
        const double size = around.all.radius + length(to.seen(around.all.centre));
        solid.bound_radius = to.length(around.solids[k].radius * (1 + 0x1p-16) + 0x1p-18 * size);
    }
    for (std::int32_t m = 0; m < scene.mirror_count; ++m) {
        derive_mirror(scene.mirrors[m], scene.ambient, plan, to, plan.mirrors[m]);
    }
    for (std::int32_t j = 0; j < scene.light_count; ++j) {
        plan.lights[j].data = derive_light(scene.lights[j], to);
        plan.lights[j].data.distant = is_far(scene.lights[j].position, around);
    }
}

template <class F>
std::uint32_t features_of_solids(const PlanOf<F>& plan) {
    std::uint32_t features = 0;
    for (std::int32_t k = 0; k < plan.solid_count; ++k) {
        const SolidPlanOf<F>& solid = plan.solids[k];
        const ShapeKind shape = solid.shape;
        features |= shape == ShapeKind::sphere        ? kFeatureSphere
                    : shape == ShapeKind::half_spaces ? kFeatureHalfSpaces
                    : shape == ShapeKind::tube        ? kFeatureTube
                                                      : kFeatureMesh;
        const typename F::Weight none(0);
        const auto& transport = solid.transport;
        const bool reflects = transport.reflection > none, transmits = transport.transmission > none;
        if (reflects || transmits) features |= kFeatureChain;
        if (transport.fresnel) features |= kFeatureFresnel;
        if (transmits && (reflects || transport.fresnel)) features |= kFeatureBranch;
    }
    return features;
}

/// Only the kernels for at most one bounce cover solids; elsewhere the estimator is the plain lattice.
template <class F>
bool has_coverage(const PlanOf<F>& plan) {
    return std::same_as<F, FloatFormats> && plan.sampling.estimator == Estimator::fibonacci_coverage &&
           (plan.features & kFeatureGlossy) &&
           !(plan.features & kNeedsGeneral);
}

template <class F>
void derive_features(const Scene& scene, const Constants<F>& to, PlanOf<F>& plan) {
    plan.features |= features_of_solids(plan);
    if (plan.mirror_count > 1) plan.features |= kFeatureChain;
    for (std::int32_t m = 0; m < plan.mirror_count; ++m) {
        const MirrorPlanOf<F>& mirror = plan.mirrors[m];
        if (mirror.curved) plan.features |= kFeatureCurved | kFeatureChain;
        if (!mirror.reflects) continue;
        plan.features |= kFeatureMirror;
        if (mirror.lobe.glossy) plan.features |= kFeatureGlossy;
        if (mirror.lobe.glossy && mirror.lobe.max_phong) plan.features |= kFeatureMaxPhong;
        if (mirror.lobe.glossy && mirror.lobe.ggx) plan.features |= kFeatureGgx;
    }
    if (plan.camera.stands_on >= 0 || near_or_inside(plan, to, scene.camera.position)) plan.features |= kFeatureInside;
    for (std::int32_t j = 0; j < plan.light_count; ++j) {
        if (plan.lights[j].data.inverse_square) plan.features |= kFeatureFalloff;
        if (plan.lights[j].data.distant) plan.features |= kFeatureFar;
        if (near_or_inside(plan, to, scene.lights[j].position)) plan.features |= kFeatureInside;
    }
    if (plan.light_count > 0 && plan.solid_count + plan.mirror_count > 1) plan.features |= kFeatureShadow;
    if (plan.antialias > 1 || plan.edge_antialias > 1) plan.features |= kFeatureAntialias;
    if (has_coverage(plan)) plan.features |= kFeatureCoverage;
}

void derive_coverage(double exponent, MirrorPlan& mirror) {
    mirror.profile = profile_of(exponent);
    fill_disc<float>(mirror.scouts, kScouts);
}

/// What only the kernels for at most one bounce read.
void derive_one_bounce(const Scene& scene, const Viewpoint& eye, const Constants<FloatFormats>& to, Plan& plan) {
    for (std::int32_t k = 0; k < plan.solid_count; ++k) {
        const SolidPlan& solid = plan.solids[k];
        plan.bounds.x[k] = solid.bound_centre.x, plan.bounds.y[k] = solid.bound_centre.y;
        plan.bounds.z[k] = solid.bound_centre.z, plan.bounds.radius[k] = solid.bound_radius;
    }
    if (plan.features & kFeatureCoverage) {
        for (std::int32_t m = 0; m < plan.mirror_count; ++m) {
            if (plan.mirrors[m].lobe.glossy) derive_coverage(scene.mirrors[m].lobe_exponent, plan.mirrors[m]);
        }
        for (std::int32_t k = 0; k < scene.solid_count; ++k) {
            derive_outline(scene, scene.solids[k], to, plan.outlines[k]);
        }
    }
    if (plan.mirror_count > 0) derive_tile_corners(plan);
    derive_image_bounds(scene, eye, plan);
    derive_light_bounds(scene, to, plan);
    if (plan.features & kFeatureInside) derive_close_spheres(scene, plan);
}

void derive_head(const Scene& scene, const Settings& settings, const ImageSize& size, PlanHead& plan) {
    plan.width = size.width, plan.height = size.height;
    plan.antialias = settings.antialias, plan.edge_antialias = settings.edge_antialias;
    plan.depth_limit = settings.depth_limit;
    plan.sampling.estimator = settings.estimator;
    plan.features = 0;
    plan.exact_plan = settings.exact_plan;
    plan.solid_count = scene.solid_count, plan.mirror_count = scene.mirror_count, plan.light_count = scene.light_count;
    plan.exposure = 0;
}

/// Everything that all kinds of plan have. `to` is chosen for a scene that fits.
template <class F>
Status derive_plan(const Scene& scene, const Settings& settings, const Surroundings& around, const Viewpoint& eye,
                   const Constants<F>& to, PlanOf<F>& plan) {
    const Rgb<double> white{1, 1, 1};
    plan.background = derive_surface(Material{.color = white, .ambient = 1}, scene.background, to).ambient;
    derive_objects(scene, around, to, plan);
    place_lobe_rays(plan, {settings.samples, settings.rotation});
    derive_camera(eye, around, to, plan);
    derive_standing(scene, to, plan);
    derive_bounds(scene, eye, plan);
    derive_blockers(scene, around, plan);
    derive_shadow_bounds(scene, eye, plan);
    derive_planes(scene, plan);
    derive_features(scene, to, plan);
    if ((plan.features & kFeatureBranch) && plan.depth_limit > kMaxBranchDepth) {
        return Status{"depth_limit", "must be at most 16 in a scene with a surface that both reflects and transmits",
                      Part::settings, 0};
    }
    derive_shared(plan, plan.camera.origin, plan.camera_origin);
    for (std::int32_t j = 0; j < scene.light_count; ++j) {
        derive_shared(plan, plan.lights[j].data.position, plan.lights[j].origin);
    }
    return kOk;
}

/// The scene and the size of its picture, checked.
Status check(const Scene& scene, const Settings& settings, ImageSize& size) {
    if (const Status status = validate(scene); !status.ok()) return status;
    size = {settings.width > 0 ? settings.width : scene.image.width,
            settings.height > 0 ? settings.height : scene.image.height};
    for (std::int32_t m = 0; m < scene.mirror_count; ++m) {
        const bool rough = scene.mirrors[m].lobe == Lobe::ggx && scene.mirrors[m].lobe_exponent < kInfinity;
        if (rough && settings.estimator == Estimator::fibonacci_coverage) {
            constexpr const char* kReason = "must not be fibonacci+coverage where a mirror's lobe is ggx";
            return Status{"estimator", kReason, Part::settings, 0};
        }
    }
    return check(settings, size);
}

/// What all kinds of plan begin with: the checks, the head, and where everything is.
Status begin(const Scene& scene, const Settings& settings, PlanHead& plan, Surroundings& around, Viewpoint& eye) {
    ImageSize size;
    if (const Status status = check(scene, settings, size); !status.ok()) return status;
    derive_head(scene, settings, size, plan);
    derive_surroundings(scene, around);
    plan.origin = origin_for(around.all);
    eye = viewpoint_of(scene.camera, size);
    return kOk;
}

}  // namespace

Status prepare(const Scene& scene, const Settings& settings, Plan& plan) {
    const IeeeMode ieee;
    Surroundings around;
    Viewpoint eye;
    if (const Status status = begin(scene, settings, plan, around, eye); !status.ok()) return status;
    const Constants<FloatFormats> to(plan.origin);
    const Status status = derive_plan(scene, settings, around, eye, to, plan);
    if (status.ok()) derive_one_bounce(scene, eye, to, plan);
    return status;
}

Status prepare(const Scene& scene, const Settings& settings, DoublePlan& plan) {
    const IeeeMode ieee;
    Surroundings around;
    Viewpoint eye;
    if (const Status status = begin(scene, settings, plan, around, eye); !status.ok()) return status;
    return derive_plan(scene, settings, around, eye, Constants<DoubleFormats>(plan.origin), plan);
}

Status prepare(const Scene& scene, const Settings& settings, FixedPlan& plan) {
    const IeeeMode ieee;
    Surroundings around;
    Viewpoint eye;
    if (const Status status = begin(scene, settings, plan, around, eye); !status.ok()) return status;
    Constants<FixedFormats> to;
    const Point start = eye.position + eye.view * pull_of(eye, around);
    if (const Status status = fit(scene, around, plan.origin, start, to); !status.ok()) return status;
    plan.exposure = to.exposure();
    return derive_plan(scene, settings, around, eye, to, plan);
}

}  // namespace zerkalo
