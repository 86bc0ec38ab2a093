// The one gate between what a person writes and the kernels: a scene that passes cannot make a kernel fail.
#pragma once

#include "core/scene/scene.hpp"
#include "core/status.hpp"

namespace zerkalo {

/// Checks every range of every field, the capacities, the mirrors' frames and outlines, and that meshes are closed.
/// Returns the first field that is wrong, in the order of the scene file. Cannot fail otherwise.
Status validate(const Scene& scene);

}  // namespace zerkalo
