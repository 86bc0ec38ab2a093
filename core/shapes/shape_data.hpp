// What the kernels read of each solid: plain uniform data, derived once by prepare().
#pragma once

#include "core/geometry/vec.hpp"

#include <cstdint>

namespace zerkalo {

/// Which of a span's ends must say which face set them.
enum class Faces : std::uint8_t { none, entry, both };

struct SphereData {
    Vec3<float> centre;
    float radius2;
    float inverse_radius;
};

/// All points with lo <= n.(p - centre) <= hi; lo is -infinity for a single half-space.
struct Slab {
    Vec3<float> n;
    float lo, hi;
    float index;  // within its solid: the number of its face
};

constexpr int kListedFaces = 16;

/// The normals of a solid's first faces, one a lane.
struct FaceNormals {
    float x[kListedFaces], y[kListedFaces], z[kListedFaces];
};

/// An intersection of slabs, `first_slab` into the plan's pool. Faces are numbered like their slabs.
struct HalfSpacesData {
    Vec3<float> centre;
    std::int32_t first_slab, slab_count;
    FaceNormals normals;
};

/// The faces of a tube; both caps are one, as the two planes of a slab are.
constexpr float kLateralFace = 0;
constexpr float kCapFace = 1;

/// Radius at the centre's height + slope * y, for |y| <= half_height, y measured from `centre` along `axis_y`.
struct TubeData {
    Vec3<float> centre;
    Vec3<float> axis_x, axis_y, axis_z;  // object axes in world coordinates
    float mid_radius, slope, half_height;
    float normal_scale;    // 1 / sqrt(1 + slope^2)
    std::uint8_t upright;  // the axes are those of the world: no rotation needed
    std::uint8_t tapered;
};

struct TriangleData {
    Vec3<float> a, edge_ab, edge_ac, normal;  // normal: unit, outward
};

/// A closed surface of triangles, `first` into the plan's pool.
struct MeshData {
    std::int32_t first, count;
};

}  // namespace zerkalo
