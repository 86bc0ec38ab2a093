// Probes of core/shapes: each solid and mirror asked by arrays of rays, as a kernel asks it.
#pragma once

#include "core/shapes/half_spaces.hpp"
#include "core/shapes/mesh.hpp"
#include "core/shapes/mirror_surface.hpp"
#include "core/shapes/sphere.hpp"
#include "core/shapes/tube.hpp"
#include "tests/core/probes/probes.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class R>
Vec3<R> load_point(const probes::Points& p, int k) {
    return {load<R>(p.x + k), load<R>(p.y + k), load<R>(p.z + k)};
}

template <class R>
void store_point(const probes::PointsOut& out, int k, Vec3<R> p) {
    store(out.x + k, p.x);
    store(out.y + k, p.y);
    store(out.z + k, p.z);
}

template <class R>
R as_number(Mask<R> mask) {
    return select(mask, R(1), R(0));
}

template <class R>
void store_span(const probes::SpansOut& out, int k, const Span<FloatNumbers<R>>& span) {
    store(out.entry + k, span.entry);
    store(out.exit + k, span.exit);
    store(out.face_in + k, span.face_in);
    store(out.face_out + k, span.face_out);
}

template <class R>
void probe_sphere(const SphereData& sphere, const probes::Rays& rays, const probes::SpansOut& out) {
    using N = FloatNumbers<R>;
    for (int k = 0; k < rays.count; k += kWidth<R>) {
        const auto from = sphere_seen_from<N>(sphere, load_point<R>(rays.o, k));
        store_span<R>(out, k, sphere_span<N>(sphere, from, load_point<R>(rays.d, k)));
    }
}

template <class R, bool Tapered, Faces F>
void probe_tube_faces(const TubeData& tube, const probes::Rays& rays, const probes::SpansOut& out) {
    using N = FloatNumbers<R>;
    for (int k = 0; k < rays.count; k += kWidth<R>) {
        const auto from = tube_seen_from<N>(tube, load_point<R>(rays.o, k));
        store_span<R>(out, k, tube_span<Tapered, F, N>(tube, from, load_point<R>(rays.d, k)));
    }
}

template <class R, Faces F>
void probe_tube_any(const TubeData& tube, const probes::Rays& rays, const probes::SpansOut& out) {
    if (tube.tapered) return probe_tube_faces<R, true, F>(tube, rays, out);
    probe_tube_faces<R, false, F>(tube, rays, out);
}

template <class R>
void probe_tube(const TubeData& tube, Faces faces, const probes::Rays& rays, const probes::SpansOut& out) {
    if (faces == Faces::none) return probe_tube_any<R, Faces::none>(tube, rays, out);
    if (faces == Faces::entry) return probe_tube_any<R, Faces::entry>(tube, rays, out);
    probe_tube_any<R, Faces::both>(tube, rays, out);
}

template <class R, Faces F>
void probe_half_spaces_faces(const Slab* slabs, const HalfSpacesData& body, const probes::Rays& rays,
                             const probes::SpansOut& out) {
    using N = FloatNumbers<R>;
    for (int k = 0; k < rays.count; k += kWidth<R>) {
        const Vec3<R> o = load_point<R>(rays.o, k) - body.centre;
        const Vec3<R> d = load_point<R>(rays.d, k);
        Span<N> span = whole_span<N>();
        for (int s = body.first_slab; s < body.first_slab + body.slab_count; ++s) {
            clip<F, N>(span, slabs[s], slab_seen_from<N>(slabs[s], o), d);
        }
        store_span<R>(out, k, span);
    }
}

template <class R>
void probe_half_spaces(const Slab* slabs, const HalfSpacesData& body, Faces faces, const probes::Rays& rays,
                       const probes::SpansOut& out) {
    if (faces == Faces::none) return probe_half_spaces_faces<R, Faces::none>(slabs, body, rays, out);
    if (faces == Faces::entry) return probe_half_spaces_faces<R, Faces::entry>(slabs, body, rays, out);
    probe_half_spaces_faces<R, Faces::both>(slabs, body, rays, out);
}

/// `sides`: entry asks for front faces only, none for back faces only, both for either.
template <class R>
void probe_mesh(const TriangleData* triangles, int count, Faces sides, const probes::Rays& rays,
                const probes::MeshHitsOut& out) {
    const Mask<R> front(sides != Faces::none), back(sides != Faces::entry);
    for (int k = 0; k < rays.count; k += kWidth<R>) {
        const MeshHit<R> hit = mesh_hit<R>(triangles, count, load_point<R>(rays.o, k), load_point<R>(rays.d, k), R(0),
                                           far_away<R>(), MeshSides<R>{front, back, R(-1)});
        store(out.hit + k, as_number<R>(hit.hit));
        store(out.back + k, as_number<R>(hit.back));
        store(out.t + k, hit.t);
        store(out.face + k, hit.face);
    }
}

template <class R>
MirrorHit<FloatNumbers<R>> mirror_hit(const MirrorShape& mirror, probes::MirrorWay way, Vec3<R> o, Vec3<R> d) {
    using N = FloatNumbers<R>;
    if (way == probes::MirrorWay::own_chord) return own_chord_hit<N>(mirror, o, d, R(0));
    const Vec3<R> from = mirror_seen_from<N>(mirror, o);
    if (way == probes::MirrorWay::plane) return plane_mirror_hit<N>(mirror, from, d, R(0));
    return curved_mirror_hit<N>(mirror, from, in_mirror_axes(mirror, d), R(0));
}

template <class R>
void probe_mirror(const MirrorShape& mirror, probes::MirrorWay way, const probes::Rays& rays,
                  const probes::MirrorHitsOut& out) {
    for (int k = 0; k < rays.count; k += kWidth<R>) {
        const auto hit = mirror_hit<R>(mirror, way, load_point<R>(rays.o, k), load_point<R>(rays.d, k));
        store(out.hit + k, as_number<R>(hit.hit));
        store(out.t + k, hit.t);
        store_point<R>({out.x, out.y, out.z}, k, {hit.x, hit.y, hit.z});
    }
}

template <class R>
void probe_inside(const BoundaryData& boundary, const float* x, const float* y, float* out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        store(out + k, as_number<R>(inside_boundary(boundary, load<R>(x + k), load<R>(y + k))));
    }
}

template <class R>
void probe_sphere_normal(const SphereData& sphere, probes::Points p, const probes::PointsOut& out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) store_point<R>(out, k, sphere_normal(sphere, load_point<R>(p, k)));
}

template <class R>
void probe_tube_normal(const TubeData& tube, probes::Points p, const float* face, const probes::PointsOut& out,
                       int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        store_point<R>(out, k, tube_normal(tube, load_point<R>(p, k), load<R>(face + k)));
    }
}

template <class R>
void probe_mirror_normal(const MirrorShape& mirror, probes::Points p, const probes::PointsOut& out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        const Vec3<R> q = load_point<R>(p, k);
        store_point<R>(out, k, mirror_normal(mirror, q.x, q.y, q.z));
    }
}

template <class R>
constexpr probes::ShapeProbes shape_probes() {
    return {&probe_sphere<R>, &probe_tube<R>,          &probe_half_spaces<R>, &probe_mesh<R>,         &probe_mirror<R>,
            &probe_inside<R>, &probe_sphere_normal<R>, &probe_tube_normal<R>, &probe_mirror_normal<R>};
}

}  // namespace zerkalo::inline ZERKALO_ISA
