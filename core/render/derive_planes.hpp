// What lies in the very plane of a mirror, where rounding alone would decide: lights, and faces of solids.
#pragma once

#include "core/render/derive.hpp"

namespace zerkalo {

/// After derive_blockers(). Fills `unlit_by` of plane mirrors, `flush` and `flush_face`; takes mirrors that a light
/// lies in out of its blockers; sets kFeatureFlush where the camera can see a face in a mirror's plane.
template <class F>
void derive_planes(const Scene& scene, PlanOf<F>& plan);

}  // namespace zerkalo
