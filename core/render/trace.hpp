// The ray tree (seed section 1.3.1 and formula 1.5): from a surface to what it reflects (I_r K_r) and lets through
// (I_t K_t), as a bounded loop over a small stack, never a recursion.
//
//     a ray meets a surface  ->  its local light, times the ray's throughput, goes to the pixel
//                            ->  its continuation: the reflected or the refracted ray, in the same packet
//                            ->  a second continuation where a surface does both: waits on the stack
//                            ->  at the first unpolished mirror of a path: a lobe job, which is worked off at once,
//                                one lattice ray after the other; later unpolished mirrors send one random ray each
// All lanes of a packet have the same depth. Jobs lie on top of the stack, so it holds one waiting packet a level, one
// that goes on and one job at the most; without surfaces that do both, never more than two.
#pragma once

#include "core/optics/fresnel.hpp"
#include "core/render/anywhere.hpp"
#include "core/render/lobe_aim.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// A packet of rays on their way, or a lobe job: then d is the mirror direction and n the mirror's normal.
template <class R>
struct PathPacket {
    Vec3<R> o, d;
    Rgb<R> throughput;
    Departure<R> from;
    Mask<R> active;
    std::int32_t depth;
    std::uint8_t after_lobe;  // the path has met an unpolished mirror
    std::uint8_t is_job;
    std::int32_t sample;  // index of the lattice ray; of a job: its next one
    Vec3<R> n;            // jobs only, as the next two
    R inverse_exponent;
    Mask<R> max_phong;
};

constexpr int kStackCapacity = kMaxBranchDepth + 2;

template <class R>
struct PathStack {
    PathPacket<R> packets[kStackCapacity];
    int count = 0;

    ZERKALO_INLINE void push(const PathPacket<R>& packet) { packets[count++] = packet; }
};

/// What identifies a camera path: its pixel, the camera sample, the turns of its lattice.
template <class R>
struct PathKey {
    Bits<R> pixel;
    std::uint32_t camera_sample;
    R turn;
};

/// Continuations of the packet that is being shaded, filled surface by surface.
template <class R>
struct Continuations {
    PathPacket<R> one, two, job;
};

template <class R>
ZERKALO_ONCE Rgb<R> local_light_anywhere(const Plan& plan, Vec3<R> p, Vec3<R> n, Vec3<R> d, const Departure<R>& spot,
                                         Mask<R> active, const SurfaceData& surface, const Blockers& blockers,
                                         CandidateMask own, TileCounts& counts) {
    Rgb<R> sum = spread<R>(surface.ambient);
    for (std::int32_t j = 0; j < plan.light_count; ++j) {
        if (surface.unlit_by >> j & 1) continue;
        const LightPlan& light = plan.lights[j];
        const ToLight<R> to = towards(light.data, p, n);
        const auto lit = active & (to.n_dot_l > R(0));
        if (none(lit)) continue;
        counts.shadow += count_of(lit);
        const auto visible = visible_anywhere(plan, light, blockers.of_light[j] | own, to, p, spot, Mask<R>(lit));
        if (none(visible)) continue;
        const Rgb<R> share = light_share(light.data, to, n, -d, surface, visible);
        sum = select(visible, sum + share, sum);
    }
    return sum;
}

template <class R>
ZERKALO_INLINE void add(Rgb<R>& sum, Mask<R> mask, Rgb<R> throughput, Rgb<R> light) {
    const Rgb<R> share = throughput * light;
    sum = select(mask, sum + share, sum);
}

/// Lanes of `mask` go on along d from p with the given weight.
template <class R>
ZERKALO_INLINE void go_on(PathPacket<R>& next, Mask<R> mask, Vec3<R> p, Vec3<R> d, Rgb<R> throughput,
                          const Departure<R>& from) {
    next.o = select(mask, p, next.o);
    next.d = select(mask, d, next.d);
    next.throughput = select(mask, throughput, next.throughput);
    next.from.id = select(mask, from.id, next.from.id);
    next.from.face = select(mask, from.face, next.from.face);
    next.from.inside = select(mask, from.inside, next.from.inside);
    next.active = next.active | mask;
}

/// Reflection and refraction at solid k: K_r + f K_t and (1 - f) K_t. f is Fresnel's reflectance where the solid asks
/// for it; else K_r and K_t are used as given, which is f = 0, and f = 1 at total internal reflection.
template <class R>
ZERKALO_INLINE void continue_at_solid(const PathPacket<R>& ray, const SolidPlan& solid, Vec3<R> p, Vec3<R> n,
                                      const Departure<R>& spot, Mask<R> here, Continuations<R>& next,
                                      TileCounts& counts) {
    const TransportData& transport = solid.transport;
    const bool is_round = solid.shape == ShapeKind::sphere || solid.shape == ShapeKind::tube;
    R reflection = R(transport.reflection);
    R transmission = R(transport.transmission);
    Vec3<R> through = ray.d;
    if (transport.transmission > 0) {
        const R eta = select(spot.inside, R(transport.eta_leaving), R(transport.eta_entering));
        const Refraction<R> refraction = refract(ray.d, n, eta);
        through = is_round ? unit_again(refraction.d) : refraction.d;
        const R turned_back = transport.fresnel ? transmission * unpolarised(fresnel_reflectance(ray.d, n, eta))
                                                : select(refraction.total, transmission, R(0));
        reflection = reflection + turned_back;
        transmission = transmission - turned_back;
    }
    const auto reflects = here & (reflection > R(0));
    const auto refracts = here & (transmission > R(0));
    if (any(reflects)) {
        counts.reflected += count_of(reflects);
        const Vec3<R> back = is_round ? unit_again(reflect(ray.d, n)) : reflect(ray.d, n);
        go_on(next.one, Mask<R>(reflects), p, back, scaled(ray.throughput, reflection), spot);
    }
    if (any(refracts)) {
        counts.refracted += count_of(refracts);
        Departure<R> other_side = spot;
        other_side.inside = !spot.inside;
        const Rgb<R> throughput = scaled(ray.throughput, transmission);
        go_on(next.one, Mask<R>(refracts & (!reflects)), p, through, throughput, other_side);
        go_on(next.two, Mask<R>(refracts & reflects), p, through, throughput, other_side);
    }
}

/// Local light of every solid that the packet has met, and where its rays go on.
template <class R>
ZERKALO_INLINE void shade_solids(const Plan& plan, const PathPacket<R>& ray, const AnyHit<R>& hit,
                                 CandidateMask candidates, Rgb<R>& sum, Continuations<R>& next, TileCounts& counts) {
    for (CandidateMask left = solids_in(candidates); left != 0; left &= left - 1) {
        const int k = first_of(left);
        const SolidPlan& solid = plan.solids[k];
        const auto here = ray.active & (hit.id == R(solid.id));
        if (none(here)) continue;
        const Vec3<R> p = ray.o + ray.d * hit.t;
        const Vec3<R> n = normal_towards(plan, solid, p, hit.face, ray.d, Mask<R>(here));
        const Departure<R> spot{R(solid.id), hit.face, hit.from_inside};
        const bool own_counts = solid.shape == ShapeKind::mesh || any(here & hit.from_inside);
        const CandidateMask own = own_counts ? CandidateMask{1} << k : 0;
        add(sum, Mask<R>(here), ray.throughput,
            local_light_anywhere(plan, p, n, ray.d, spot, Mask<R>(here), solid.surface, solid.blockers, own,
                                 counts));
        const TransportData& transport = solid.transport;
        if (ray.depth < plan.depth_limit && (transport.reflection > 0 || transport.transmission > 0)) {
            continue_at_solid(ray, solid, p, n, spot, Mask<R>(here), next, counts);
        }
    }
}

/// One lobe ray: direction in the lobe's frame turned into the world; what it weighs; what goes below the horizon.
template <class R>
struct LobeRay {
    Vec3<R> d;
    R weight;
    Mask<R> above;
};

template <class R>
ZERKALO_INLINE LobeRay<R> lobe_ray(const LobePoint<R>& point, Vec3<R> m, Vec3<R> n, Mask<R> max_phong) {
    const Tangents<R> base = tangents_of(m);
    const Vec3<R> d = m * point.forward + base.t * point.side + base.b * point.up;
    const R cosine = dot(d, n);
    const R weight = select(max_phong, lobe_weight(cosine, R(R(1) / dot(m, n))), R(1));
    return {d, weight, Mask<R>(cosine > R(0))};
}

/// A single random ray of a lobe, for unpolished mirrors behind the first: uniform in energy, from the path's key.
template <class R>
ZERKALO_INLINE LobePoint<R> random_lobe_point(const LobeData& lobe, const PathKey<R>& key, const PathPacket<R>& ray) {
    const std::uint32_t place =
        hash_bits(key.camera_sample) ^
        hash_bits(static_cast<std::uint32_t>(ray.sample) + 0x10000000u * static_cast<std::uint32_t>(ray.depth));
    const Bits<R> one = hash_bits(key.pixel ^ Bits<R>(place));
    const Bits<R> two = hash_bits(one + Bits<R>(kGoldenTurn));
    // (k + 1/2) / 2^23 lies strictly between 0 and 1.
    const R u = turn_of_phase<R>(one) + R(0.5f + 0x1p-24f);
    return lobe_point(u, turn_of_phase<R>(two), R(lobe.inverse_exponent));
}

/// Sends lobe rays on; those below the horizon see the background (phong) or nothing (max-Phong).
template <class R>
ZERKALO_INLINE void go_on_in_lobe(const Plan& plan, const LobeRay<R>& lobe_ray, Mask<R> max_phong, Mask<R> mask,
                                  Vec3<R> p, Rgb<R> throughput, R id, PathPacket<R>& next, Rgb<R>& sum,
                                  TileCounts& counts) {
    counts.lobe += count_of(mask);
    add(sum, Mask<R>(mask & (!lobe_ray.above) & (!max_phong)), throughput, spread<R>(plan.background));
    go_on(next, Mask<R>(mask & lobe_ray.above), p, lobe_ray.d, scaled(throughput, lobe_ray.weight),
          Departure<R>{id, R(0), Mask<R>(false)});
}

/// Reflection at the front of a mirror: one ray, one lobe ray, or a job for all lobe rays.
template <class R>
ZERKALO_INLINE void continue_at_mirror(const Plan& plan, const PathPacket<R>& ray, const MirrorPlan& mirror, Vec3<R> p,
                                       Vec3<R> n, const Departure<R>& spot, Mask<R> front, const PathKey<R>& key,
                                       Rgb<R>& sum, Continuations<R>& next, TileCounts& counts) {
    const LobeData& lobe = mirror.lobe;
    const Rgb<R> throughput = ray.throughput * spread<R>(mirror.reflectance);
    const Vec3<R> d = mirror.curved ? unit_again(reflect(ray.d, n)) : reflect(ray.d, n);
    const Mask<R> max_phong = Mask<R>(lobe.max_phong != 0);
    if (!lobe.glossy) {
        counts.reflected += count_of(front);
        go_on(next.one, front, p, d, throughput, spot);
    } else if (ray.after_lobe) {
        const LobeRay<R> one = lobe_ray(random_lobe_point(lobe, key, ray), d, n, max_phong);
        go_on_in_lobe(plan, one, max_phong, front, p, throughput, spot.id, next.one, sum, counts);
    } else {
        go_on(next.job, front, p, d, scaled(throughput, R(1) / R(float(plan.samples))), spot);
        next.job.n = select(front, n, next.job.n);
        next.job.inverse_exponent = select(front, R(lobe.inverse_exponent), next.job.inverse_exponent);
        next.job.max_phong = select(front, max_phong, next.job.max_phong);
    }
}

/// Local light of every mirror that the packet has met; where its rays go on; the lobe job that it starts.
template <class R>
ZERKALO_INLINE void shade_mirrors(const Plan& plan, const PathPacket<R>& ray, const AnyHit<R>& hit,
                                  CandidateMask candidates, const PathKey<R>& key, Rgb<R>& sum, Continuations<R>& next,
                                  TileCounts& counts) {
    for (CandidateMask left = mirrors_in(candidates); left != 0; left &= left - 1) {
        const int m = first_of(left);
        const MirrorPlan& mirror = plan.mirrors[m];
        const R id = R(float(kMaxSolids + m));
        const auto here = ray.active & (hit.id == id);
        if (none(here)) continue;
        const Vec3<R> p = ray.o + ray.d * hit.t;
        const Vec3<R> outward = mirror_normal(mirror.shape, hit.x, hit.y, hit.z);
        const R along = dot(outward, ray.d);
        const auto front = here & (along < R(0));
        const Vec3<R> n = select(front, outward, -outward);
        const Departure<R> spot{id, R(0), Mask<R>(false)};
        for (int side = 0; side < 2; ++side) {
            const Mask<R> seen = side == 0 ? Mask<R>(front) : Mask<R>(here & (!front));
            if (none(seen)) continue;
            const SurfaceData& surface = side == 0 ? mirror.front : mirror.back;
            add(sum, seen, ray.throughput,
                local_light_anywhere(plan, p, n, ray.d, spot, seen, surface, plan.mirrors[m].blockers, 0, counts));
        }
        if (mirror.reflects && ray.depth < plan.depth_limit && any(front)) {
            continue_at_mirror(plan, ray, mirror, p, n, spot, Mask<R>(front), key, sum, next, counts);
        }
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
