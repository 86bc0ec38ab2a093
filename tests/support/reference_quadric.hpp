// Sphere and tapered tube for the reference tracer, and the quadratic equation they share.
#pragma once

#include "tests/support/reference_shapes.hpp"

namespace zerkalo::reference {

/// Real roots of a t^2 + 2 b t + c = 0, each written without subtracting nearly equal numbers.
struct Roots {
    int count = 0;
    long double t[2] = {0, 0};
};
Roots roots_of(long double a, long double b, long double c);

/// |P - centre| = radius.
std::unique_ptr<Shape> make_sphere(const Solid& solid);

/// Local x^2 + z^2 = (r (1 + (taper - 1) y / height))^2 for 0 <= y <= height, closed by a disc at each end.
std::unique_ptr<Shape> make_tube(const Solid& solid);

}  // namespace zerkalo::reference
