// Three small pictures as constants, rendered into static memory: the same program with and without an operating system.
#pragma once

#include "core/scene/scene.hpp"

namespace zerkalo::pictures {

/// sharp: a ball before a polished plane mirror, the smallest kernel.
/// glossy: a prism before an unpolished hollow mirror.
/// everything: every kind of solid, refraction, both mirrors, two lights, both falloffs.
enum class Picture { sharp, glossy, everything };
constexpr int kPictureCount = 3;

/// "sharp", "glossy", "everything".
const char* name_of(Picture picture);

/// Renders every picture with every instruction set of this CPU, in fixed point too, and in double, and gives write() one
/// line for each: "<picture> <isa> <hash as 16 hex digits>", "<picture>.fixed <isa> <hash>" or "<picture>.double scalar
/// <hash>". False when prepare() refuses a picture or two hashes of one differ.
bool render_all(void (*write)(const char* line));

}  // namespace zerkalo::pictures
