// Three long doubles and their algebra: what the closed forms of these tests are computed in.
#pragma once

#include "core/geometry/vec.hpp"

#include <cmath>

namespace zerkalo::test {

using Real80 = long double;
constexpr Real80 kPi80 = 3.14159265358979323846264338327950288L, kRightAngle = kPi80 / 2;

struct Exact3 {
    Real80 x = 0, y = 0, z = 0;
};

template <class T>
Exact3 exact(const Vec3<T>& v) {
    return {v.x, v.y, v.z};
}
inline Vec3<float> rounded_to_float(const Exact3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
inline Vec3<double> rounded_to_double(const Exact3& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline Exact3 operator+(const Exact3& a, const Exact3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Exact3 operator-(const Exact3& a, const Exact3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Exact3 operator-(const Exact3& a) { return {-a.x, -a.y, -a.z}; }
inline Exact3 operator*(const Exact3& a, Real80 s) { return {a.x * s, a.y * s, a.z * s}; }
inline Real80 dot(const Exact3& a, const Exact3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Exact3 cross(const Exact3& a, const Exact3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real80 length(const Exact3& a) { return std::sqrt(dot(a, a)); }
inline Exact3 unit(const Exact3& a) { return a * (1 / length(a)); }

/// Unit roundoff of float: the measure of every rounding in the lanes.
constexpr Real80 kU = 0x1p-24L;

}  // namespace zerkalo::test
