// What the kernels read of each solid: plain uniform data, derived once by prepare(). F: the formats of its numbers.
#pragma once

#include "core/geometry/vec.hpp"
#include "core/numeric/formats.hpp"

#include <cstdint>

namespace zerkalo {

/// Which of a span's ends must say which face set them.
enum class Faces : std::uint8_t { none, entry, both };

template <class F>
struct SphereDataOf {
    Vec3<typename F::Length> centre;
    typename F::Area radius2;
    typename F::Inverse inverse_radius;
};
using SphereData = SphereDataOf<FloatFormats>;

/// All points with lo <= n.(p - centre) <= hi; lo is -infinity for a single half-space.
template <class F>
struct SlabOf {
    Vec3<typename F::Direction> n;
    typename F::Length lo, hi;
    typename F::Index index;  // within its solid: the number of its face
};
using Slab = SlabOf<FloatFormats>;

constexpr int kListedFaces = 16;

/// The normals of a solid's first faces, one a lane.
template <class F>
struct FaceNormalsOf {
    typename F::Direction x[kListedFaces], y[kListedFaces], z[kListedFaces];
};
using FaceNormals = FaceNormalsOf<FloatFormats>;

/// An intersection of slabs, `first_slab` into the plan's pool. Faces are numbered like their slabs.
template <class F>
struct HalfSpacesDataOf {
    Vec3<typename F::Length> centre;
    std::int32_t first_slab, slab_count;
    FaceNormalsOf<F> normals;
};
using HalfSpacesData = HalfSpacesDataOf<FloatFormats>;

/// The faces of a tube; both caps are one, as the two planes of a slab are.
constexpr int kLateralFace = 0;
constexpr int kCapFace = 1;

/// Radius at the centre's height + slope * y, for |y| <= half_height, y measured from `centre` along `axis_y`.
/// Beyond this distance from its centre, squared, no ray meets the tube: what is farther out may leave a fixed format.
template <class F>
struct TubeReach {};
template <>
struct TubeReach<FixedFormats> {
    FixedFormats::Area reach2;
};

template <class F>
struct TubeDataOf : TubeReach<F> {
    Vec3<typename F::Length> centre;
    Vec3<typename F::Direction> axis_x, axis_y, axis_z;  // object axes in world coordinates
    typename F::Length mid_radius;
    typename F::Ratio slope;
    typename F::Length half_height;
    typename F::Direction normal_scale;  // 1 / sqrt(1 + slope^2)
    std::uint8_t upright;  // the axes are those of the world: no rotation needed
    std::uint8_t tapered;
};
using TubeData = TubeDataOf<FloatFormats>;

template <class F>
struct TriangleDataOf {
    Vec3<typename F::Length> a, edge_ab, edge_ac;
    Vec3<typename F::Direction> normal;  // unit, outward
};
using TriangleData = TriangleDataOf<FloatFormats>;

/// A closed surface of triangles, `first` into the plan's pool.
struct MeshData {
    std::int32_t first, count;
};

}  // namespace zerkalo
