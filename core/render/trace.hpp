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
#include "core/render/lobe_job.hpp"
#include "core/render/tile.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// A packet of rays on their way, or a lobe job: then d is the mirror direction.
template <class R>
struct PathPacket {
    Vec3<Length<R>> o;
    Vec3<Direction<R>> d;
    Rgb<Weight<R>> throughput;
    Departure<R> from;
    StoredMask<R> active;
    CandidateMask candidates;  // all that the rays can meet
    std::uint8_t aimed;        // some ray comes near each of them
    std::int32_t depth;
    std::uint8_t after_lobe;  // the path has met an unpolished mirror
    std::uint8_t is_job;
    std::int32_t sample;  // index of the lattice ray; of a job: its next one
};

constexpr int kStackCapacity = kMaxBranchDepth + 2;

template <class R>
struct PathStack {
    PathPacket<R> packets[kStackCapacity];
    LobeJob<R> lobe{};  // of the only job
    LobeRows<R> rows;
    int count = 0;

    ZERKALO_INLINE void push(const PathPacket<R>& packet) { packets[count++] = packet; }
};

/// Continuations of the packet that is being shaded, filled surface by surface.
template <class R>
struct Continuations {
    PathPacket<R> one, two, job;
    LobeStart<R> lobe;
};

template <class R>
using SurfaceFor = SurfaceDataOf<Formats<R>>;

template <class R>
ZERKALO_ONCE Rgb<Radiance<R>> local_light_anywhere(const PlanFor<R>& plan, const Vec3<Length<R>>& p,
                                                   const Vec3<Direction<R>>& n, const Vec3<Direction<R>>& d,
                                                   const Departure<R>& spot, const Mask<R>& active,
                                                   const SurfaceFor<R>& surface, const Blockers& blockers,
                                                   CandidateMask own, TileCounts& counts) {
    Rgb<Radiance<R>> sum = spread<Radiance<R>>(surface.ambient);
    for (std::int32_t j = 0; j < plan.light_count; ++j) {
        if (surface.unlit_by >> j & 1) continue;
        const LightPlanFor<R>& light = plan.lights[j];
        const ToLight<R> to = towards(light.data, p, n);
        const auto lit = active & (to.n_dot_l > Weight<R>(0));
        if (none(lit)) continue;
        counts.shadow += count_of(lit);
        const auto visible = visible_anywhere<R>(plan, light, blockers.of_light[j] | own, to, p, spot, Mask<R>(lit));
        if (none(visible)) continue;
        sum = plus_where(visible, sum, light_share(light.data, to, n, -d, surface, visible));
    }
    return sum;
}

/// Lanes of `mask` go on along d from p with the given weight.
template <class R>
ZERKALO_INLINE void go_on(PathPacket<R>& next, Mask<R> mask, Vec3<Length<R>> p, Vec3<Direction<R>> d,
                          Rgb<Weight<R>> throughput, const Departure<R>& from) {
    next.o = select(mask, p, next.o);
    next.d = select(mask, d, next.d);
    next.throughput = select(mask, throughput, next.throughput);
    next.from.id = select(mask, from.id, next.from.id);
    next.from.face = select(mask, from.face, next.from.face);
    next.from.inside = select(mask, from.inside, next.from.inside);
    next.active = next.active | mask;
}

template <class F>
ZERKALO_INLINE bool reflects(const TransportDataOf<F>& transport) {
    return transport.reflection > typename F::Weight(0);
}
template <class F>
ZERKALO_INLINE bool transmits(const TransportDataOf<F>& transport) {
    return transport.transmission > typename F::Weight(0);
}

/// Reflection and refraction at solid k: K_r + f K_t and (1 - f) K_t. f is Fresnel's reflectance where the solid asks
/// for it; else K_r and K_t are used as given, which is f = 0, and f = 1 at total internal reflection.
template <class R>
ZERKALO_INLINE void continue_at_solid(const PathPacket<R>& ray, const SolidPlanFor<R>& solid, Vec3<Length<R>> p,
                                      Vec3<Direction<R>> n, const Departure<R>& spot, Mask<R> here,
                                      Continuations<R>& next, TileCounts& counts) {
    using W = Weight<R>;
    const auto& transport = solid.transport;
    const bool is_round = solid.shape == ShapeKind::sphere || solid.shape == ShapeKind::tube;
    W reflection = W(transport.reflection);
    W transmission = W(transport.transmission);
    Vec3<Direction<R>> through = ray.d;
    if (transmits(transport)) {
        const auto eta = select(spot.inside, Ratio<R>(transport.eta_leaving), Ratio<R>(transport.eta_entering));
        const auto refraction = refract(ray.d, n, eta);
        through = is_round ? unit_again(refraction.d) : refraction.d;
        const W turned_back = transport.fresnel
                                  ? as<W>(transmission * unpolarised(fresnel_reflectance(ray.d, n, eta)))
                                  : select(refraction.total, transmission, W(0));
        reflection = reflection + turned_back;
        transmission = transmission - turned_back;
    }
    const auto reflected = here & (reflection > W(0));
    const auto refracted = here & (transmission > W(0));
    if (any(reflected)) {
        counts.reflected += count_of(reflected);
        const Vec3<Direction<R>> back = is_round ? unit_again(reflect(ray.d, n)) : reflect(ray.d, n);
        go_on<R>(next.one, Mask<R>(reflected), p, back, as<W>(scaled(ray.throughput, reflection)), spot);
    }
    if (any(refracted)) {
        counts.refracted += count_of(refracted);
        Departure<R> other_side = spot;
        other_side.inside = !spot.inside;
        const Rgb<W> throughput = as<W>(scaled(ray.throughput, transmission));
        go_on<R>(next.one, Mask<R>(refracted & (!reflected)), p, through, throughput, other_side);
        go_on<R>(next.two, Mask<R>(refracted & reflected), p, through, throughput, other_side);
    }
}

/// What rays from o along d have met: the solids' local light, times the throughput. `then` is told each solid, the
/// points, normals, surfaces and lanes.
template <class R, class Then>
ZERKALO_INLINE void light_solids(const PlanFor<R>& plan, CandidateMask candidates, const AnyHit<R>& hit,
                                 Vec3<Length<R>> o, Vec3<Direction<R>> d, Mask<R> active, Rgb<Weight<R>> throughput,
                                 Rgb<LightSum<R>>& sum, TileCounts& counts, const Then& then) {
    for (CandidateMask left = solids_in(candidates); left != 0; left &= left - 1) {
        const int k = first_of(left);
        const SolidPlanFor<R>& solid = plan.solids[k];
        const auto here = active & (hit.id == Index<R>(solid.id));
        if (none(here)) continue;
        const Vec3<Length<R>> p = point_at<R>(o, d, hit.t);
        const Vec3<Direction<R>> n = normal_towards<R>(plan, solid, p, hit.face, d, Mask<R>(here));
        const Departure<R> spot{Index<R>(solid.id), hit.face, hit.from_inside};
        const bool own_counts = solid.shape == ShapeKind::mesh || any(here & hit.from_inside);
        const CandidateMask own = own_counts ? CandidateMask{1} << k : 0;
        add<R>(sum, here, throughput,
               local_light_anywhere<R>(plan, p, n, d, spot, here, solid.surface, solid.blockers, own, counts));
        then(solid, p, n, spot, Mask<R>(here));
    }
}

/// Local light of every solid that the packet has met, and where its rays go on.
template <class R>
ZERKALO_ONCE void shade_solids(const PlanFor<R>& plan, const PathPacket<R>& ray, const AnyHit<R>& hit,
                                 Rgb<LightSum<R>>& sum, Continuations<R>& next, TileCounts& counts) {
    light_solids<R>(plan, ray.candidates, hit, ray.o, ray.d, ray.active, ray.throughput, sum, counts,
                    [&](const SolidPlanFor<R>& solid, const Vec3<Length<R>>& p, const Vec3<Direction<R>>& n,
                        const Departure<R>& spot, const Mask<R>& here) ZERKALO_INLINE_LAMBDA {
        const auto& transport = solid.transport;
        if (ray.depth < plan.depth_limit && (reflects(transport) || transmits(transport))) {
            continue_at_solid<R>(ray, solid, p, n, spot, here, next, counts);
        }
    });
}

/// A single random ray of a lobe, for unpolished mirrors behind the first: uniform in energy, from the path's key.
template <class R>
ZERKALO_INLINE SetPoint<R> random_place(const Sampling& sampling, const PathKey<R>& key, const PathPacket<R>& ray) {
    const std::uint32_t place =
        sampling.turn ^ hash_bits(key.camera_sample) ^
        hash_bits(static_cast<std::uint32_t>(ray.sample) + 0x10000000u * static_cast<std::uint32_t>(ray.depth));
    const Bits<R> one = hash_bits(key.pixel ^ Bits<R>(place));
    const Bits<R> two = hash_bits(one + Bits<R>(kGoldenTurn));
    return {fraction_of_bits<R>(one), phase_of<R>(two)};
}

/// Sends lobe rays on; those below the horizon see the background (phong) or nothing (the others: `dark`).
template <class R>
ZERKALO_INLINE void go_on_in_lobe(const PlanFor<R>& plan, const LobeRay<R>& lobe_ray, Mask<R> dark, Mask<R> mask,
                                  Vec3<Length<R>> p, Rgb<Weight<R>> throughput, Index<R> id,
                                  PathPacket<R>& next, Rgb<LightSum<R>>& sum, TileCounts& counts) {
    counts.lobe += count_of(mask);
    const auto below = mask & (!lobe_ray.above) & (!dark);
    if (any(below)) add<R>(sum, below, throughput, spread<Radiance<R>>(plan.background));
    // Else the weight is 1.
    if (any(dark)) throughput = as<Weight<R>>(scaled(throughput, lobe_ray.weight));
    go_on<R>(next, mask & lobe_ray.above, p, lobe_ray.d, throughput,
             Departure<R>{id, Index<R>(0), mask_of<R>(false)});
}

/// Reflection at the front of a mirror: one ray, one lobe ray, or a job for all lobe rays.
template <class R>
ZERKALO_INLINE void continue_at_mirror(const PlanFor<R>& plan, const PathPacket<R>& ray, const MirrorPlanFor<R>& mirror,
                                       Vec3<Length<R>> p, Vec3<Direction<R>> n, const Departure<R>& spot,
                                       Mask<R> front, const PathKey<R>& key, Rgb<LightSum<R>>& sum,
                                       Continuations<R>& next, TileCounts& counts) {
    using W = Weight<R>;
    const LobeFor<R>& lobe = mirror.lobe;
    const Rgb<W> throughput = as<W>(ray.throughput * spread<W>(mirror.reflectance));
    const Vec3<Direction<R>> d = mirror.curved ? unit_again(reflect(ray.d, n)) : reflect(ray.d, n);
    const Mask<R> max_phong = mask_of<R>(lobe.max_phong != 0), ggx = mask_of<R>(lobe.ggx != 0);
    if (!lobe.glossy) {
        counts.reflected += count_of(front);
        go_on<R>(next.one, front, p, d, throughput, spot);
    } else if (ray.after_lobe) {
        const SetPoint<R> at = random_place<R>(plan.sampling, key, ray);
        const LobePoint<R> point = lobe_point(at.u, at.turn, Share<R>(lobe.inverse_exponent));
        const LobeRay<R> one = lobe.ggx ? ggx_ray<R>(at, d, n, Direction<R>(lobe.alpha))
                                        : lobe_ray<R>(point, d, tangents_of(d), n, max_phong);
        go_on_in_lobe<R>(plan, one, max_phong | ggx, front, p, throughput, spot.id, next.one, sum, counts);
    } else {
        const Rgb<W> part = as<W>(scaled(throughput, full_weight<R>(plan.sampling.estimator, plan.samples)));
        CandidateMask candidates;
        const Mask<R> sending = lanes_with_rays<R>(
            plan, lobe, p, d, front, candidates, ~CandidateMask{0},
            [&](const auto& empty) ZERKALO_INLINE_LAMBDA { add_whole_lobe<R>(plan, empty, part, sum); });
        if (none(sending)) return;
        next.job.candidates |= candidates;
        go_on<R>(next.job, sending, p, d, part, spot);
        next.lobe.n = select(sending, n, next.lobe.n);
        next.lobe.inverse_exponent = select(sending, Share<R>(lobe.inverse_exponent), next.lobe.inverse_exponent);
        next.lobe.max_phong = select(sending, max_phong, next.lobe.max_phong);
        next.lobe.alpha = select(sending, Direction<R>(lobe.alpha), next.lobe.alpha);
        next.lobe.ggx = select(sending, ggx, next.lobe.ggx);
    }
}

/// Where rays from o along d have met mirror m, and the side that they see.
template <class R>
struct MirrorSpot {
    Vec3<Length<R>> p;
    Vec3<Direction<R>> n;  // towards the viewer
    Departure<R> spot;
    Mask<R> front;
};

/// Local light of both sides of a mirror, times the throughput.
template <class R>
ZERKALO_INLINE MirrorSpot<R> light_mirror(const PlanFor<R>& plan, int m, const Blockers& blockers,
                                          const AnyHit<R>& hit, Vec3<Length<R>> o, Vec3<Direction<R>> d, Mask<R> here,
                                          Rgb<Weight<R>> throughput, Rgb<LightSum<R>>& sum, TileCounts& counts) {
    const MirrorPlanFor<R>& mirror = plan.mirrors[m];
    const Vec3<Direction<R>> outward = front_normal<R>(mirror, hit.x, hit.y, hit.z);
    const auto front = here & (dot(outward, d) < Square<R>(0));
    const Departure<R> spot{index_of<R>(kMaxSolids + m), Index<R>(0), mask_of<R>(false)};
    const MirrorSpot<R> at{point_at<R>(o, d, hit.t), select(front, outward, -outward), spot, Mask<R>(front)};
    for (int side = 0; side < 2; ++side) {
        const Mask<R> seen = side == 0 ? Mask<R>(front) : Mask<R>(here & (!front));
        if (none(seen)) continue;
        const SurfaceFor<R>& surface = side == 0 ? mirror.front : mirror.back;
        add<R>(sum, seen, throughput,
               local_light_anywhere<R>(plan, at.p, at.n, d, at.spot, seen, surface, blockers, 0, counts));
    }
    return at;
}

/// Local light of every mirror that the packet has met; where its rays go on; the lobe job that it starts.
template <class R>
ZERKALO_ONCE void shade_mirrors(const PlanFor<R>& plan, const TileView& view, const PathPacket<R>& ray,
                                  const AnyHit<R>& hit, const PathKey<R>& key, Rgb<LightSum<R>>& sum,
                                  Continuations<R>& next, TileCounts& counts) {
    for (CandidateMask left = mirrors_in(ray.candidates); left != 0; left &= left - 1) {
        const int m = first_of(left);
        const MirrorPlanFor<R>& mirror = plan.mirrors[m];
        const auto here = ray.active & (hit.id == index_of<R>(kMaxSolids + m));
        if (none(here)) continue;
        const bool of_tile = Formats<R>::kFixed && ray.depth == 0 && plan.mirror_count == 1;
        const Blockers& blockers = of_tile ? view.mirror_blockers : mirror.blockers;
        const MirrorSpot<R> at =
            light_mirror<R>(plan, m, blockers, hit, ray.o, ray.d, here, ray.throughput, sum, counts);
        if (mirror.reflects && ray.depth < plan.depth_limit && any(at.front)) {
            continue_at_mirror<R>(plan, ray, mirror, at.p, at.n, at.spot, at.front, key, sum, next, counts);
        }
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
