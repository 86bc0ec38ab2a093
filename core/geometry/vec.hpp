// Three components of one type: a uniform number, a lane of numbers, or a fixed-point format.
// The types are plain aggregates; the operations on them are in geometry/algebra.hpp.
#pragma once

namespace zerkalo {

template <class T>
struct Vec3 {
    T x, y, z;
};

template <class T>
struct Vec2 {
    T x, y;
};

/// Linear RGB, never encoded. Scene colours are 0..1; radiance is any value >= 0.
template <class T>
struct Rgb {
    T r, g, b;
};

}  // namespace zerkalo
