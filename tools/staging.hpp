// Parts of small scenes, for the stiff cases and the tests: surfaces of which one term of Whitted's sum is left, solids,
// lights, mirrors and cameras of few words.
#pragma once

#include "core/scene/scene.hpp"

namespace zerkalo::staging {

/// A surface that shows its colour whatever the light: C = color, K_a = 1, all else 0.
Material glowing(const Rgb<double>& color);

/// A surface of which only the matte share is left: K_d = 1, white.
Material chalk();

/// K_t = 1 and nothing else.
Material clear_glass(double refractive_index);

Solid ball(const Vec3<double>& centre, double radius, const Material& material);

/// A pyramid, prism, cylinder or cone on its base.
Solid upright(SolidKind kind, const Vec3<double>& base, double radius, double height, const Material& material);

Light lamp(const Vec3<double>& position);

/// A polished square that only reflects, all of it, and faces along `normal`.
Mirror ideal_mirror(const Vec3<double>& position, const Vec3<double>& normal, double side);

/// A camera at `position` that looks along `view`, `fov` radians across.
Camera camera_at(const Vec3<double>& position, const Vec3<double>& view, double fov);

void add(Scene& scene, const Solid& solid);
void add(Scene& scene, const Light& light);
void add(Scene& scene, const Mirror& mirror);

}  // namespace zerkalo::staging
