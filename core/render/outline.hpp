// The outlines of solids as the coverage of lobes needs them (render/cover_solids.hpp): corners and edges of a
// polyhedron. Balls and tubes need nothing but themselves.
#pragma once

#include "core/geometry/vec.hpp"
#include "core/scene/scene.hpp"

#include <cstdint>

namespace zerkalo {

constexpr int kMaxOutlineSides = 12;  // polyhedra with more sides are not covered: see render/README.md
constexpr int kMaxOutlineFaces = kMaxOutlineSides + 2;

/// From one corner to another. The lobe's axis lies in face `left` only where `turning` (optics/coverage.hpp) is >= 0,
/// and in face `right` only where it is < 0.
struct OutlineEdge {
    std::uint8_t from, to, left, right;
};

/// One face: at `hi` of its slab, or at `lo`.
struct OutlineFace {
    std::uint8_t slab, low;
};

/// A convex polyhedron of at most kMaxOutlineSides sides; all counts are 0 for every other solid.
struct Outline {
    float x[2 * kMaxOutlineSides], y[2 * kMaxOutlineSides], z[2 * kMaxOutlineSides];
    Vec3<float> middle[kMaxOutlineFaces];  // a point inside of each face
    OutlineEdge edges[3 * kMaxOutlineSides];
    OutlineFace faces[kMaxOutlineFaces];
    std::uint8_t corner_count, edge_count, face_count;
};

}  // namespace zerkalo
