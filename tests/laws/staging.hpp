// Small scenes for the tests of whole pictures, and single rays out of the renderer: a picture of one pixel.
#pragma once

#include "tests/laws/rendering.hpp"
#include "tools/staging.hpp"

#include <numbers>

namespace zerkalo::laws {

using namespace staging;

constexpr double kPi = std::numbers::pi;
constexpr double kUlp = 0x1p-23;  // of a float from 1 on

/// A prism of four sides whose square base has that side, its axis upwards, its faces along the axes.
Solid box(const Vec3<double>& base_centre, double side, double height, const Material& material);

/// A sphere, a cone, a prism, a pyramid and a cylinder, turned every way, about the point (0, 1, z).
void add_five_solids(Scene& scene, double z);

/// The five solids under one lamp before a plane mirror.
Scene simple_scene();

/// The five solids under two lamps before a mirror of this curvature radius that faces aside and shines.
Scene five_solids_before_mirror_aslant(double curvature_radius);

/// What arrives at `origin` from the direction `view` (any length), by the renderer: with every instruction set that
/// this CPU has, to the same bits. Throws std::runtime_error where they are not.
Rgb<float> look(Scene scene, const Vec3<double>& origin, const Vec3<double>& view, const Settings& settings = {});

/// The place between `low` and `high` where `test` changes from true to false, to the last digit of a double.
template <class Test>
double where_it_ends(double low, double high, const Test& test) {
    constexpr int kBits = 53;
    for (int step = 0; step < kBits; ++step) {
        const double middle = (low + high) / 2;
        (test(middle) ? low : high) = middle;
    }
    return low;
}

}  // namespace zerkalo::laws
