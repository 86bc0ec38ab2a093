// A convex polyhedron as an intersection of slabs: the solid itself, not its triangles, so no edge can leak.
//
// Along a ray each slab lo <= n.p <= hi is an interval of t; the polyhedron's span is their intersection, and the face
// that set its entry is the face that is hit; ties go to the lowest slab. IEEE infinities carry the parallel rays:
// outside the slab the interval is empty, inside it is everything. 0/0, a ray in a face plane, is inside at `hi` and
// outside at `lo`: half-open, so that solids stacked on each other share no ray.
// Source: Kay, Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986; Haines, Graphics Gems II, 1991.
#pragma once

#include "core/geometry/ray.hpp"
#include "core/numeric/shuffle.hpp"
#include "core/shapes/shape_data.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The slab's two offsets as seen from an origin: lo - n.o and hi - n.o.
template <class N>
struct SlabOrigin {
    Length<N> lo, hi;
};

template <class N, class S, class O>
ZERKALO_INLINE SlabOrigin<N> slab_seen_from(const S& slab, Vec3<O> o_from_centre) {
    const auto s = rounded<Length<N>>(dot(slab.n, o_from_centre));
    return {slab.lo - s, slab.hi - s};
}

/// A ray that is inside everything: where the intersection starts.
template <class N>
ZERKALO_INLINE Span<N> whole_span() {
    const auto far = far_away<Length<N>>();
    return {-far, far, typename N::Index(0), typename N::Index(0)};
}

/// Narrows the span by one slab.
template <Faces F, class N, class S, class M>
ZERKALO_INLINE void clip(Span<N>& span, const S& slab, const SlabOrigin<M>& from, Vec3<Direction<N>> d) {
    const auto along = rounded<Direction<N>>(dot(slab.n, d));
    const auto at = quotients<Length<N>>(from.lo, from.hi, along);
    const auto enter = min(at.first, at.second);
    const auto leave = max(at.first, at.second);
    if constexpr (F == Faces::none) {
        span.entry = max(enter, span.entry);
    } else {
        const auto later = enter > span.entry;
        span.face_in = select(later, typename N::Index(slab.index), span.face_in);
        span.entry = select(later, enter, span.entry);
    }
    if constexpr (F == Faces::both) {
        const auto sooner = leave < span.exit;
        span.face_out = select(sooner, typename N::Index(slab.index), span.face_out);
        span.exit = select(sooner, leave, span.exit);
    } else {
        span.exit = min(leave, span.exit);
    }
}

/// Whether no lane's span holds anything.
template <class N>
ZERKALO_INLINE bool is_empty(const Span<N>& span) {
    return none(span.entry <= span.exit);
}

/// Clips by every slab, until nothing is left. `seen(s)`: the origin of slab s.
template <Faces F, class N, class S, class Seen>
ZERKALO_INLINE Span<N> clipped(const S* slabs, std::int32_t count, Vec3<Direction<N>> d, const Seen& seen) {
    Span<N> span = whole_span<N>();
    for (std::int32_t s = 0; s < count; ++s) {
        clip<F>(span, slabs[s], seen(s), d);
        if (is_empty(span)) break;
    }
    return span;
}
/// The same, called: seldom needed, and it takes registers.
template <Faces F, class N, class S, class Seen>
ZERKALO_ONCE Span<N> clipped_apart(const S* slabs, std::int32_t count, const Vec3<Direction<N>>& d, const Seen& seen) {
    return clipped<F, N>(slabs, count, d, seen);
}

/// Span of the polyhedron along unit directions d. The ends are rounded once where that gives the same.
template <Faces F, class N, class S, class Seen>
ZERKALO_INLINE Span<N> slabs_span(const S* slabs, std::int32_t count, Vec3<Direction<N>> d, const Seen& seen) {
    using Late = typename UnroundedOf<N>::type;
    if constexpr (std::same_as<Late, N>) {
        return clipped<F, N>(slabs, count, d, seen);
    } else {
        Span<N> span;
        if (!settle(clipped<F, Late>(slabs, count, d, seen), span)) span = clipped_apart<F, N>(slabs, count, d, seen);
        return span;
    }
}

/// Outward normal of the face at hi of each lane's slab, in the lanes of `here`.
template <class R, class B, class S>
ZERKALO_INLINE Vec3<Direction<R>> half_spaces_normal(const B& body, const S* slabs, Index<R> face, Mask<R> here) {
    using D = Direction<R>;
    if constexpr (kPickable<R> > 0) {
        const auto& normals = body.normals;
        if (body.slab_count <= kPickable<R>) {
            return {pick(normals.x, face), pick(normals.y, face), pick(normals.z, face)};
        }
    }
    Vec3<D> n = spread<D>(slabs[0].n);
    for (std::int32_t s = 1; s < body.slab_count; ++s) {
        const auto on_face = here & (face == Index<R>(slabs[s].index));
        if (any(on_face)) n = select(on_face, spread<D>(slabs[s].n), n);
    }
    return n;
}

}  // namespace zerkalo::inline ZERKALO_ISA
