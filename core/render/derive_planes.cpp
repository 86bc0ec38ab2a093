#include "core/render/derive_planes.hpp"

namespace zerkalo {
namespace {

// What the rounding of set-up can make of two planes that are the same, as a share of the coordinates.
constexpr double kSetUpRounding = 0x1p-46;

bool is_plane(const Mirror& mirror) { return !(magnitude(mirror.curvature_radius) < kInfinity); }

struct Height {
    double value;  // over the mirror's plane, along its normal
    bool none;     // but for rounding
};

Height height_over(const Mirror& mirror, const Point& p) {
    const double value = dot(unit(mirror.normal), p - mirror.position);
    return {value, magnitude(value) <= kSetUpRounding * (length(p) + length(mirror.position))};
}

/// A light in the plane lights neither side, and the mirror does not stand between it and anything.
template <class F>
void derive_lights(const Scene& scene, std::int32_t m, PlanOf<F>& plan) {
    const std::uint64_t mirror_bit = std::uint64_t{1} << (kMaxSolids + m);
    for (std::int32_t j = 0; j < scene.light_count; ++j) {
        const Height height = height_over(scene.mirrors[m], scene.lights[j].position);
        const std::uint32_t bit = 1u << j;
        if (height.none || height.value < 0) plan.mirrors[m].front.unlit_by |= bit;
        if (height.none || height.value > 0) plan.mirrors[m].back.unlit_by |= bit;
        if (!height.none) continue;
        for (std::int32_t k = 0; k < scene.solid_count; ++k) plan.solids[k].blockers.of_light[j] &= ~mirror_bit;
        for (std::int32_t k = 0; k < scene.mirror_count; ++k) plan.mirrors[k].blockers.of_light[j] &= ~mirror_bit;
    }
}

/// The face of solid k in the plane of mirror m, if it has one; whether it looks to the camera's side of the mirror.
template <class F>
bool derive_flush_face(const Scene& scene, std::int32_t m, std::int32_t k, MirrorPlanOf<F>& out) {
    const Mirror& mirror = scene.mirrors[m];
    const Point n = unit(mirror.normal), middle = placement_of(scene.solids[k]).middle;
    FacePair faces[kMaxSides + 1];
    const std::int32_t count = faces_of(scene.solids[k], faces);
    const double camera = dot(n, scene.camera.position - mirror.position);
    for (std::int32_t f = 0; f < count; ++f) {
        if (length(cross(faces[f].n, n)) > kSetUpRounding) continue;
        for (const double side : {faces[f].lo, faces[f].hi}) {
            if (!(magnitude(side) < kInfinity)) continue;
            if (!height_over(mirror, middle + faces[f].n * side).none) continue;
            out.flush |= 1u << k;
            out.flush_face[k] = typename F::Index(faces[f].index);
            const bool outward_is_front = (dot(faces[f].n, n) > 0) == (side == faces[f].hi);
            return outward_is_front == (camera > 0);
        }
    }
    return false;
}

}  // namespace

template <class F>
void derive_planes(const Scene& scene, PlanOf<F>& plan) {
    for (std::int32_t m = 0; m < scene.mirror_count; ++m) {
        if (!is_plane(scene.mirrors[m])) continue;
        derive_lights(scene, m, plan);
        for (std::int32_t k = 0; k < scene.solid_count; ++k) {
            if (derive_flush_face(scene, m, k, plan.mirrors[m])) plan.features |= kFeatureFlush;
        }
    }
}

template void derive_planes(const Scene&, Plan&);
template void derive_planes(const Scene&, DoublePlan&);
template void derive_planes(const Scene&, FixedPlan&);

}  // namespace zerkalo
