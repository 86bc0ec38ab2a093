// The scenes of `zerkalo bench`: each keeps one kernel busy with nothing else in the way.
#pragma once

#include "core/scene/scene.hpp"

#include <memory>

namespace zerkalo {

/// One solid that covers the whole view, no light: a camera ray costs one intersection, a normal and the ambient term.
std::unique_ptr<Scene> solid_scene(SolidKind kind);

/// The same ball under one light: one shadow ray a camera ray.
std::unique_ptr<Scene> shadow_scene();

/// A mirror that covers the whole view and shows a ball; `lobe_exponent` infinity is the sharp mirror. No light.
std::unique_ptr<Scene> mirror_scene(double lobe_exponent);

/// Five solids on a row before an unpolished gold mirror, one light, 640x480: an ordinary frame.
std::unique_ptr<Scene> ordinary_scene();

}  // namespace zerkalo
