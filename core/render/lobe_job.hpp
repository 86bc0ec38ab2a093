// The lobe of the first unpolished mirror of a path: which pixels of a packet send rays at all, where each ray goes.
//
// In fixed point sums are exact, so a pixel whose whole lobe passes every surface has its closed form to the last bit:
// as many times the background as there are rays. And a lattice ray depends on the pixel by its class alone, so a tile
// makes each ray once for the four classes.
#pragma once

#include "core/optics/ggx.hpp"
#include "core/optics/lattice.hpp"
#include "core/optics/point_sets.hpp"
#include "core/render/anywhere.hpp"
#include "core/render/path_light.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class R>
using LobeFor = LobeDataOf<Formats<R>>;

/// A solid's bounding ball as a packet's lobes see it: its centre, and |centre|^2 - radius^2.
template <class R>
struct LobeTarget {
    Vec3<Length<R>> centre;  // side, up, forward
    Area<R> beyond;
    std::int32_t solid;
};
constexpr int kMostTargets = 4;

/// The mirror's normal and lobe, of each lane.
template <class R>
struct LobeStart {
    Vec3<Direction<R>> n;
    Share<R> inverse_exponent;
    Direction<R> alpha;
    Mask<R> max_phong, ggx;
};

/// What the lobe rays of a packet share.
template <class R>
struct LobeJob : LobeStart<R> {
    Tangents<Direction<R>> base;  // across the mirror direction
    LobeTarget<R> targets[kMostTargets];
    std::int32_t target_count;  // of all that the rays can meet; 0 where this is not known
    std::int32_t missed;        // rays, without those at the rim, that passed all of them
};

/// One lobe ray: direction in the lobe's frame turned into the world; what it weighs; what goes below the horizon.
template <class R>
struct LobeRay {
    Vec3<Direction<R>> d;
    Weight<R> weight;
    Mask<R> above;
};

/// `base`: tangents_of(m).
template <class R>
ZERKALO_INLINE LobeRay<R> lobe_ray(const LobePoint<R>& point, Vec3<Direction<R>> m,
                                   const Tangents<Direction<R>>& base, Vec3<Direction<R>> n, Mask<R> max_phong) {
    using D = Direction<R>;
    using W = Weight<R>;
    const Vec3<D> in_frame{point.forward, point.side, point.up};
    const Vec3<D> d{rounded<D>(dot(Vec3<D>{m.x, base.t.x, base.b.x}, in_frame)),
                    rounded<D>(dot(Vec3<D>{m.y, base.t.y, base.b.y}, in_frame)),
                    rounded<D>(dot(Vec3<D>{m.z, base.t.z, base.b.z}, in_frame))};
    const W cosine = rounded<W>(dot(d, n));
    W weight = W(1);
    if (any(max_phong)) weight = select(max_phong, lobe_weight_of(cosine, as<W>(dot(m, n))), W(1));
    return {d, weight, Mask<R>(cosine > W(0))};
}

/// The same of a ggx lobe, from the place of its ray: that lobe is not one shape turned about m.
template <class R>
ZERKALO_ONCE LobeRay<R> ggx_ray(const SetPoint<R>& at, Vec3<Direction<R>> m, Vec3<Direction<R>> n,
                                Direction<R> alpha) {
    using D = Direction<R>;
    const Tangents<D> base = tangents_of(n);
    const Vec3<D> viewer{as<D>(-dot(m, base.t)), as<D>(-dot(m, base.b)), as<D>(dot(m, n))};
    const Vec3<D> local = reflect(-viewer, visible_normal<R>(viewer, alpha, at));
    const Vec3<D> d = as<D>(base.t * local.x + base.b * local.y + n * local.z);
    return {d, ggx_weight(local.z, viewer.z, alpha), Mask<R>(local.z > D(0))};
}

template <class R>
ZERKALO_INLINE LobeRay<R> select(Mask<R> mask, const LobeRay<R>& a, const LobeRay<R>& b) {
    return {select(mask, a.d, b.d), select(mask, a.weight, b.weight), select(mask, a.above, b.above)};
}

/// What identifies a camera path: its pixel, the camera sample and its part of the lattice, its lattice's turn and, in
/// fixed point, the two bits of its class, or its keyed set.
template <class R>
struct PathKey {
    Bits<R> pixel;
    std::uint32_t camera_sample;
    LatticePart part;
    Phase<R> turn;
    Mask<R> class_low, class_high;
    SetChoice<Bits<R>> set;
};

/// Lattice rays of a tile in fixed point, each for all classes; made when they are first needed.
template <class R>
struct LobeRows {};
template <class R>
    requires(Formats<R>::kFixed)
struct LobeRows<R> {
    using One = Uniform<R>;
    struct Row {
        std::int32_t sample = -1;
        std::uint32_t camera_sample = 0;
        Share<One> inverse_exponent{};
        Direction<One> forward{}, side[kLatticeClasses]{}, up[kLatticeClasses]{};
    };
    static constexpr std::int32_t kRows = 16;
    Row rows[kRows];
};

/// Phase of ray s of a part of the lattice before the turn of its pixel.
template <class R>
ZERKALO_INLINE Phase<Uniform<R>> phase_of_sample(const LatticePart& part, std::int32_t s) {
    return phase_of<Uniform<R>>(phase_in_part(part, static_cast<std::uint32_t>(s)));
}

template <class R>
ZERKALO_ONCE void fill_row(typename LobeRows<R>::Row& row, const PlanHead& plan, std::int32_t s, const PathKey<R>& key,
                           Share<Uniform<R>> inverse_exponent) {
    using One = Uniform<R>;
    row.sample = s;
    row.camera_sample = key.camera_sample;
    row.inverse_exponent = inverse_exponent;
    const LobePolar<One> polar = lobe_polar(share_point<One>(key.part, s, plan.samples), inverse_exponent);
    for (int c = 0; c < kLatticeClasses; ++c) {
        const auto turn = phase_of_sample<One>(key.part, s) + phase_of<One>(phase_of_class(plan.sampling, c));
        const LobePoint<One> point = at_azimuth(polar, turn);
        row.forward = point.forward, row.side[c] = point.side, row.up[c] = point.up;
    }
}

/// The inverse exponent of the first active lane.
template <class R>
ZERKALO_INLINE Share<Uniform<R>> first_exponent(const LobeJob<R>& job, Mask<R> active) {
    int lane = 0;
    while (!(bits_of(active) >> lane & 1)) ++lane;
    return with_format<Share<R>::kFormat>(lane_of(job.inverse_exponent.raw, lane));
}

/// Where in the lobe ray s of a path goes.
template <class R>
ZERKALO_INLINE SetPoint<R> place_of_ray(const PlanHead& plan, const PathKey<R>& key, std::int32_t s) {
    SetPoint<R> at;
    if (is_keyed(plan.sampling.estimator)) {
        const auto index = Bits<R>(static_cast<std::uint32_t>(s));
        at = set_point<R>(plan.sampling.estimator, index, plan.samples, key.set);
    } else {
        at = {share_point<R>(key.part, s, plan.samples), Phase<R>(phase_of_sample<R>(key.part, s))};
    }
    at.turn = at.turn + key.turn;
    return at;
}

/// Ray s of the job, in the lobe's frame.
template <class R>
ZERKALO_INLINE LobePoint<R> point_of_job(const PlanFor<R>& plan, LobeRows<R>& rows, const LobeJob<R>& job,
                                         const PathKey<R>& key, std::int32_t s, Mask<R> active) {
    if constexpr (Formats<R>::kFixed) {
        const auto exponent = first_exponent<R>(job, active);
        if (!is_keyed(plan.sampling.estimator) && none(active & (job.inverse_exponent != exponent))) {
            auto& row = rows.rows[s % LobeRows<R>::kRows];
            if (row.sample != s || row.camera_sample != key.camera_sample || row.inverse_exponent != exponent) {
                fill_row<R>(row, plan, s, key, exponent);
            }
            const auto of_class = [&key](const Direction<Uniform<R>>* value) ZERKALO_INLINE_LAMBDA {
                const auto lower = select(key.class_low, Direction<R>(value[1]), Direction<R>(value[0]));
                const auto upper = select(key.class_low, Direction<R>(value[3]), Direction<R>(value[2]));
                return select(key.class_high, upper, lower);
            };
            return {of_class(row.side), of_class(row.up), row.forward};
        }
    }
    const SetPoint<R> at = place_of_ray<R>(plan, key, s);
    return lobe_point(at.u, at.turn, job.inverse_exponent);
}

/// Lanes whose lobe, the cone about m that holds all its rays, can come near the solid's bounding ball: the ball's
/// signed distance to the cone's side is  across cos - along sin. Compared squared and divided by the cosine. `stray`:
/// by how much along and across may be wrong.
template <class R>
ZERKALO_INLINE Mask<R> cone_may_meet(const SolidPlanFor<R>& solid, const LobeFor<R>& lobe, Vec3<Length<R>> p,
                                     Vec3<Direction<R>> m, Length<R> stray) {
    using L = Length<R>;
    using One = Uniform<R>;
    // Room for the rounding of a few products of lengths up to 15.
    constexpr auto kRoom = Length<One>::from_raw(1 << 8);
    const Vec3<L> f = fitting_difference(solid.bound_centre, p);
    const L along = rounded<L>(dot(f, m));
    const auto radius = as<Length<One>>(solid.bound_radius * lobe.cone.secant) + kRoom;
    const L reach = as<L>((along + stray) * lobe.cone.tangent) + L(radius) + stray;
    const Area<R> across2 = fitting_difference(dot_of_ways(f, f), along * along);
    const Mask<R> ahead = reach >= L(0), near = across2 <= fitting_sum(reach * reach, kSquareRoom<R>);
    return ahead & near;
}

/// Which lanes of `front` must send their lobe's rays, and what these can meet: of the solids, only some `among` these.
/// The others see the background alone: `add_background` is told which.
template <class R, class Add>
ZERKALO_INLINE Mask<R> lanes_with_rays(const PlanFor<R>& plan, const LobeFor<R>& lobe, Vec3<Length<R>> p,
                                       Vec3<Direction<R>> m, Mask<R> front, CandidateMask& candidates,
                                       CandidateMask among, const Add& add_background) {
    candidates = all_of(plan);
    if constexpr (!Formats<R>::kFixed) {
        return front;
    } else {
        if (plan.exact_plan || !lobe.cone.narrow) return front;
        // The only mirror, if it is plane, meets none of its own rays.
        const bool alone = plan.mirror_count == 1 && !plan.mirrors[0].curved;
        candidates = alone ? 0 : candidates - solids_in(candidates);
        using L = Length<R>;
        auto reached = mask_of<R>(false);
        for (CandidateMask left = solids_in(all_of(plan)) & among; left != 0; left &= left - 1) {
            const int k = first_of(left);
            const auto here = front & cone_may_meet<R>(plan.solids[k], lobe, p, m, L(0));
            if (none(here)) continue;
            candidates |= CandidateMask{1} << k;
            reached = reached | here;
        }
        // What the rays of max-Phong weigh depends on the pixel.
        if (!alone || lobe.max_phong || lobe.ggx) return front;
        const auto empty = front & (!reached);
        if (any(empty)) add_background(empty);
        return reached;
    }
}

/// A job whose rays start at p about m: the frame, and the solids that the rays can meet.
template <class R>
ZERKALO_INLINE void aim_job(const PlanFor<R>& plan, const LobeStart<R>& start, LobeJob<R>& job, Vec3<Length<R>> p,
                            Vec3<Direction<R>> m, CandidateMask candidates) {
    static_cast<LobeStart<R>&>(job) = start;
    job.base = tangents_of(m);
    job.target_count = job.missed = 0;
    if constexpr (Formats<R>::kFixed) {
        using L = Length<R>;
        if (plan.exact_plan || mirrors_in(candidates) != 0 || any(job.max_phong | job.ggx)) return;
        for (CandidateMask left = candidates; left != 0; left &= left - 1) {
            if (job.target_count == kMostTargets) {
                job.target_count = 0;
                return;
            }
            LobeTarget<R>& target = job.targets[job.target_count++];
            target.solid = first_of(left);
            const SolidPlanFor<R>& solid = plan.solids[target.solid];
            const Vec3<L> f = solid.bound_centre - p;
            target.centre = {as<L>(dot(f, job.base.t)), as<L>(dot(f, job.base.b)), as<L>(dot(f, m))};
            target.beyond = dot(f, f) - (solid.bound_radius * solid.bound_radius + kSquareRoom<R>);
        }
    }
}

/// The solids that a ray of the job may meet from some active lane. Conservative.
template <class R>
ZERKALO_INLINE CandidateMask solids_met(const LobeJob<R>& job, const LobePoint<R>& point, Mask<R> active) {
    const Vec3<Direction<R>> d{point.side, point.up, point.forward};
    CandidateMask met = 0;
    for (std::int32_t i = 0; i < job.target_count; ++i) {
        const LobeTarget<R>& target = job.targets[i];
        const auto along = as<Length<R>>(dot(target.centre, d));
        const Mask<R> ahead = along > Length<R>(0), around = target.beyond <= Area<R>(0);
        const Mask<R> near = along * along >= target.beyond;
        if (any(Mask<R>(active & (ahead | around) & near))) met |= CandidateMask{1} << target.solid;
    }
    return met;
}

}  // namespace zerkalo::inline ZERKALO_ISA
