// Fixed-point numbers of the tests: made from and read as long doubles, packed into lanes and taken out of them.
#pragma once

#include "core/geometry/ray.hpp"
#include "core/numeric/fixed.hpp"
#include "core/shapes/boundary_shape.hpp"
#include "tests/core/support/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace zerkalo::test {

using One = FixedNumbers<1>;
using Len = Length<One>;
using Dir = Direction<One>;

/// The test scenes are boxes of this edge. The promise is a hit within 2e-7 of it; the largest error of these rays is
/// about 1.5e-8 of it (two steps of a length, divided by the least cosine), and the laws allow a fifth of the promise.
constexpr Real80 kExtent = 8;
constexpr Real80 kTolerance = 4e-8L * kExtent;
/// Rays that meet a surface at a flatter angle than this cosine are not asked for that accuracy.
constexpr Real80 kLeastCosine = 0.1L;

/// Every group of rays is traced at once at the widest width, and ray by ray.
constexpr int kGroup = 8;

/// The nearest number of the format F.
template <class F>
F nearest(Real80 x) {
    return F::from_raw(static_cast<typename F::Element>(std::llround(std::ldexp(x, F::kFraction))));
}
template <class F>
Vec3<F> nearest(const Exact3& v) {
    return {nearest<F>(v.x), nearest<F>(v.y), nearest<F>(v.z)};
}

/// The exact value.
template <class Rep, Format F>
Real80 real(Fixed<Rep, F> x) {
    return std::ldexp(static_cast<Real80>(x.raw), -F.fraction);
}
template <class F>
Exact3 real(const Vec3<F>& v) {
    return {real(v.x), real(v.y), real(v.z)};
}

/// W scalars as lanes of one number.
template <int W, class T, Format F>
Fixed<Ints<T, W>, F> packed(const std::array<Fixed<T, F>, kGroup>& from, int first) {
    if constexpr (W == 1) {
        return from[static_cast<std::size_t>(first)];
    } else {
        Fixed<Ints<T, W>, F> result{};
        for (int k = 0; k < W; ++k) result.raw.v[k] = from[static_cast<std::size_t>(first + k)].raw;
        return result;
    }
}
template <int W, class F>
auto packed(const std::array<Vec3<F>, kGroup>& from, int first) {
    std::array<F, kGroup> x, y, z;
    for (std::size_t k = 0; k < kGroup; ++k) {
        x[k] = from[k].x;
        y[k] = from[k].y;
        z[k] = from[k].z;
    }
    using P = decltype(packed<W>(x, first));
    return Vec3<P>{packed<W>(x, first), packed<W>(y, first), packed<W>(z, first)};
}

/// Lane k as a scalar.
template <class Rep, Format F>
Fixed<LaneElement<Rep>, F> lane(Fixed<Rep, F> x, int k) {
    return Fixed<LaneElement<Rep>, F>::from_raw(lane_of(x.raw, k));
}

/// Rays with origins in the box and unit directions, beside the directions before rounding.
struct RayGroup {
    std::array<Vec3<Len>, kGroup> o;
    std::array<Vec3<Dir>, kGroup> d;
    std::array<Exact3, kGroup> exact_d;

    void aim(int k, const Exact3& from, const Exact3& at) {
        const auto i = static_cast<std::size_t>(k);
        o[i] = nearest<Len>(from);
        exact_d[i] = unit(at - real(o[i]));
        d[i] = nearest<Dir>(exact_d[i]);
    }
};

inline Exact3 point_in_box(Random& random) {
    const double x = random.uniform(-4, 4), y = random.uniform(-4, 4), z = random.uniform(-4, 4);
    return {x, y, z};
}

/// The vector seen in a looking-glass across x = 0.
template <class F>
Vec3<F> flipped(const Vec3<F>& v) {
    return {-v.x, v.y, v.z};
}

}  // namespace zerkalo::test
