// Probes of core/optics: directions, the lobe and its lattice, Whitted's local light.
#pragma once

#include "core/optics/directions.hpp"
#include "core/optics/fresnel.hpp"
#include "core/optics/ggx.hpp"
#include "core/optics/point_sets.hpp"
#include "core/optics/whitted.hpp"
#include "tests/core/probes/shape_probes.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class R>
void probe_reflect(probes::Points d, probes::Points n, const probes::PointsOut& out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        store_point<R>(out, k, reflect(load_point<R>(d, k), load_point<R>(n, k)));
    }
}

template <class R>
void probe_mirror_direction(probes::Points l, probes::Points n, const probes::PointsOut& out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        const Vec3<R> to = load_point<R>(l, k), normal = load_point<R>(n, k);
        store_point<R>(out, k, mirror_direction(to, normal, dot(to, normal)));
    }
}

template <class R>
void probe_refract(probes::Points d, probes::Points n, const float* eta, const probes::PointsOut& out, float* total,
                   int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        const Refraction<R> bent = refract(load_point<R>(d, k), load_point<R>(n, k), load<R>(eta + k));
        store_point<R>(out, k, bent.d);
        store(total + k, as_number<R>(bent.total));
    }
}

template <class R>
void probe_fresnel(probes::Points d, probes::Points n, const float* eta, float* across, float* within, float* both,
                   int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        const auto share = fresnel_reflectance(load_point<R>(d, k), load_point<R>(n, k), load<R>(eta + k));
        store(across + k, share.across);
        store(within + k, share.within);
        store(both + k, unpolarised(share));
    }
}

template <class R>
void probe_tangents(probes::Points m, const probes::PointsOut& t, const probes::PointsOut& b, int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        const Tangents<R> frame = tangents_of(load_point<R>(m, k));
        store_point<R>(t, k, frame.t);
        store_point<R>(b, k, frame.b);
    }
}

template <class R>
void probe_lobe(const float* u, const float* turn, float inverse_exponent, const probes::PointsOut& out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        const LobePoint<R> p = lobe_point(load<R>(u + k), load<R>(turn + k), R(inverse_exponent));
        store_point<R>(out, k, {p.side, p.up, p.forward});
    }
}

template <class R>
void probe_lattice(std::int32_t points, float inverse_exponent, const probes::PointsOut& out, int count) {
    std::uint32_t index[probes::kWidest];
    for (int k = 0; k < count; k += kWidth<R>) {
        for (int lane = 0; lane < kWidth<R>; ++lane) index[lane] = static_cast<std::uint32_t>(k + lane);
        const LatticePart whole = lattice_part(sampling_of(Estimator::fibonacci, 0), 0, 1);
        const LobePoint<R> p = lattice_point<R>(whole, load_bits<R>(index), points, R(inverse_exponent));
        store_point<R>(out, k, {p.side, p.up, p.forward});
    }
}

template <class R>
void probe_set(Estimator rule, std::int32_t points, std::uint32_t key, std::uint32_t half, float* u, float* turn,
               int count) {
    std::uint32_t index[probes::kWidest];
    for (int k = 0; k < count; k += kWidth<R>) {
        for (int lane = 0; lane < kWidth<R>; ++lane) index[lane] = static_cast<std::uint32_t>(k + lane);
        const SetPoint<R> p =
            set_point<R>(rule, load_bits<R>(index), points, SetChoice<Bits<R>>{Bits<R>(key), Bits<R>(half)});
        store(u + k, p.u);
        store(turn + k, p.turn);
    }
}

template <class R>
void probe_ggx(const float* u, const float* turn, float alpha, const float* viewer, const probes::PointsOut& out,
               float* weight, int count) {
    const Vec3<R> v{R(viewer[0]), R(viewer[1]), R(viewer[2])};
    for (int k = 0; k < count; k += kWidth<R>) {
        const SetPoint<R> at{load<R>(u + k), load<R>(turn + k)};
        const Vec3<R> d = reflect(-v, visible_normal<R>(v, R(alpha), at));
        store_point<R>(out, k, d);
        store(weight + k, ggx_weight(d.z, v.z, R(alpha)));
    }
}

template <class R>
void probe_ggx_weight(const float* cosine, float cosine_out, float alpha, float* out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        store(out + k, ggx_weight(load<R>(cosine + k), R(cosine_out), R(alpha)));
    }
}

template <class R>
void probe_weight(const float* cosine, float inverse_cosine_out, float* out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) store(out + k, lobe_weight(load<R>(cosine + k), R(inverse_cosine_out)));
}

template <class R>
void probe_light(const LightData& light, const SurfaceData& surface, const probes::Rays& seen_from, probes::Points n,
                 const probes::PointsOut& rgb) {
    for (int k = 0; k < seen_from.count; k += kWidth<R>) {
        const Vec3<R> normal = load_point<R>(n, k);
        const ToLight<R> to = towards(light, load_point<R>(seen_from.o, k), normal);
        const Mask<R> lit = to.n_dot_l > R(0);
        const Rgb<R> share = light_share(light, to, normal, load_point<R>(seen_from.d, k), surface, lit);
        const Rgb<R> black{R(0), R(0), R(0)};
        const Rgb<R> seen = select(lit, share, black);
        store_point<R>(rgb, k, {seen.r, seen.g, seen.b});
    }
}

template <class R>
constexpr probes::OpticsProbes optics_probes() {
    return {&probe_reflect<R>, &probe_mirror_direction<R>, &probe_refract<R>, &probe_fresnel<R>, &probe_tangents<R>,
            &probe_lobe<R>,    &probe_lattice<R>,          &probe_set<R>,     &probe_ggx<R>,     &probe_ggx_weight<R>,
            &probe_weight<R>,  &probe_light<R>};
}

}  // namespace zerkalo::inline ZERKALO_ISA
