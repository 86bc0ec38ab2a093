// A closed surface of triangles by the seed's method (its figure 2.4): Moeller, Trumbore, "Fast, Minimum Storage
// Ray/Triangle Intersection", Journal of Graphics Tools 2(1), 1997, with an exact zero test instead of an epsilon.
//
// It is not a span: a mesh need not be convex. A ray that leaves one of its triangles on the outside can only meet a
// front face next, on the inside only a back face: the sides exclude self-hits, together with the triangle's identity.
#pragma once

#include "core/geometry/ray.hpp"
#include "core/shapes/shape_data.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Which faces a ray can meet: both when it starts anywhere, one side when it starts on the mesh itself.
template <class R>
struct MeshSides {
    Mask<R> front, back;
    Index<R> own_face;  // the triangle on which the ray starts, or -1
};

template <class R>
struct MeshHit {
    Mask<R> hit, back;  // back: met from inside
    Length<R> t;
    Index<R> face;
};

/// The nearest triangle with t_min < t < t_max. `triangles` points to the mesh's first one.
template <class R, class T, class O>
ZERKALO_INLINE MeshHit<R> mesh_hit(const T* triangles, int count, Vec3<O> o, Vec3<Direction<R>> d, Length<R> t_min,
                                   Length<R> t_max, const MeshSides<R>& sides) {
    using L = Length<R>;
    using A = Area<R>;
    const A zero = A(0);
    MeshHit<R> best{t_max < t_max, t_max < t_max, t_max, Index<R>(0)};
    for (int k = 0; k < count; ++k) {
        const T& tri = triangles[k];
        const Vec3<L> across = as<L>(cross(d, tri.edge_ac));
        const A det = dot(tri.edge_ab, across);
        const auto from_a = o - tri.a;
        const A u = dot(from_a, across);
        const auto turned = cross(from_a, tri.edge_ab);
        const A v = dot_as<A>(turned, d);
        // Compare with det's sign taken out: 0 <= u, 0 <= v, u + v <= |det|, without the division.
        const A size = absolute(det);
        const A us = flip_sign(u, det);
        const A vs = flip_sign(v, det);
        auto hit = (us >= zero) & (vs >= zero) & (us + vs <= size) & (size > zero);
        if (none(hit)) continue;
        // det > 0: the ray runs against the outward normal.
        const auto face = index_of<R>(k);
        hit = hit & ((sides.front & (det > zero)) | (sides.back & (det < zero))) & (sides.own_face != face);
        const L t = quotient<L>(dot_as<Volume<R>>(turned, tri.edge_ac), det);
        hit = hit & (t > t_min) & (t < best.t);
        best.t = select(hit, t, best.t);
        best.face = select(hit, face, best.face);
        best.hit = best.hit | hit;
        best.back = select(hit, Mask<R>(det < zero), best.back);
    }
    return best;
}

}  // namespace zerkalo::inline ZERKALO_ISA
