// What a few rays from the middle of a tile, its scouts, tell of one solid before it is covered: how much of it other
// solids hide there, and what it brings on average. They are aimed at the solid and count by the lobe's power: one at
// the rim of the lobes is judged as surely as one in their middle.
#pragma once

#include "core/optics/coverage.hpp"
#include "core/render/lattice_chunk.hpp"
#include "core/render/lobe_tile.hpp"
#include "core/render/shade.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// May one of two solids hide a part of the other from a place of the tile? Not where the cones around the balls that
/// bound them lie apart.
ZERKALO_INLINE bool may_overlap(const SolidPlan& one, const SolidPlan& other, const TileLobe& lobe) {
    const Vec3<float> a = one.bound_centre - lobe.p, b = other.bound_centre - lobe.p;
    const float radius_a = one.bound_radius + lobe.stray, radius_b = other.bound_radius + lobe.stray;
    const float ahead_a = dot(a, a) - radius_a * radius_a, ahead_b = dot(b, b) - radius_b * radius_b;
    if (!(ahead_a > 0 && ahead_b > 0)) return true;
    // The cosine of the sum of both half-angles, times both distances.
    constexpr float kRoom = 1 - 0x1p-18f;
    return dot(a, b) > (sqrt(ahead_a) * sqrt(ahead_b) - radius_a * radius_b) * kRoom;
}

/// Solids of the mask that may hide solid k, or be hidden by it.
ZERKALO_INLINE CandidateMask rivals_of(const Plan& plan, const TileLobe& lobe, CandidateMask solids, int k) {
    CandidateMask rivals = 0;
    for (CandidateMask left = solids & ~(CandidateMask{1} << k); left != 0; left &= left - 1) {
        if (may_overlap(plan.solids[k], plan.solids[first_of(left)], lobe)) rivals |= left & (~left + 1);
    }
    return rivals;
}

/// Where the scouts go: the disc at unit distance behind which the ball lies that bounds the solid; of a ball that is
/// wider than most of the lobe, a disc as wide as that, the one nearest to the lobe's axis.
struct Target {
    Vec3<float> middle;
    Tangents<float> across;
    float radius;
};

ZERKALO_INLINE Target target_of(const SolidPlan& solid, const TileLobe& lobe, const LobeProfile& profile) {
    const Vec3<float> f = solid.bound_centre - lobe.p;
    const float inverse = 1 / sqrt(dot(f, f));
    const Vec3<float> u = f * inverse, aside = lobe.m - u;
    constexpr float kMostOfLobe = 0.6f;  // 2.4 of the 4.08 deviations of the cone
    const float ball = solid.bound_radius * inverse, cone = kMostOfLobe * sqrt(profile.edge);
    if (!(ball > cone)) return {u, tangents_of(u), ball};
    const float off = sqrt(dot(aside, aside)), room = ball - cone;
    return {off > room ? u + aside * (room / off) : lobe.m, tangents_of(u), cone};
}

/// The power of the lobe in a direction, never nothing: cos^(n+1), as its coverage has it.
template <class R>
ZERKALO_INLINE R power_towards(const LobeProfile& profile, R cosine) {
    const R v = R(1) - cosine * cosine;
    const auto inside = (cosine > R(0)) & (v < R(profile.edge));
    const R within = max(min(v, R(profile.edge)), R(0));
    return select(inside, R(1) - within * winding_density(profile, within), R(0x1p-12f));
}

/// Sums over the scouts that meet a solid, by the lobe's power.
struct Report {
    float met, seen;   // `seen`: before any rival
    float face;        // those met in face 0: the only round one
    Rgb<float> light;  // what those of them that are seen bring beyond the background
};

/// What each scout tells; summed one after another, for a packet may hold any number of them.
struct ScoutNotes {
    alignas(64) float met[kScouts], seen[kScouts], r[kScouts], g[kScouts], b[kScouts], face[kScouts];
};

ZERKALO_INLINE Report sum_of(const ScoutNotes& notes) {
    Report sum{};
    for (std::int32_t s = 0; s < kScouts; ++s) {
        sum.met += notes.met[s], sum.seen += notes.seen[s], sum.face += notes.face[s];
        sum.light = sum.light + Rgb<float>{notes.r[s], notes.g[s], notes.b[s]};
    }
    return sum;
}

/// Sends the scouts from the tile's middle to solid k, which the rivals may hide.
template <class R>
ZERKALO_ONCE Report scout(const Plan& plan, const TileLobe& lobe, int k, CandidateMask rivals, TileCounts& counts) {
    const MirrorPlan& mirror = plan.mirrors[0];
    const SolidPlan& solid = plan.solids[k];
    const Target target = target_of(solid, lobe, mirror.profile);
    const Vec3<R> p = spread<R>(lobe.p);
    const Rgb<R> none_yet = spread<R>(Rgb<float>{0, 0, 0});
    ScoutNotes notes;
    for (std::int32_t s = 0; s < kScouts; s += kWidth<R>) {
        const R side = load<R>(mirror.scouts.side + s) * R(target.radius);
        const R up = load<R>(mirror.scouts.up + s) * R(target.radius);
        const Vec3<R> towards = target.across.t * side + target.across.b * up + target.middle;
        const Vec3<R> d = towards * (R(1) / sqrt(dot(towards, towards)));
        const R power = power_towards(mirror.profile, dot(d, spread<R>(lobe.m)));
        const Nearest<R> rival = nearest_solid(plan, rivals, PointOrigin<R>{p}, d);
        with_span<Faces::entry, R>(plan, k, PointOrigin<R>{p}, d,
                                   [&](const Span<FloatNumbers<R>>& span) ZERKALO_INLINE_LAMBDA {
            const auto met = (span.entry <= span.exit) & (span.entry > R(0));
            const auto seen = met & (span.entry < rival.t), own = met & (span.face_in == R(0));
            Rgb<R> light = none_yet;
            if (any(seen & own)) {
                light = light_of_solid<R>(plan, solid, p + d * span.entry, span.face_in, d, seen & own, counts);
                light = select(seen & own, scaled(light - spread<R>(plan.background), power), none_yet);
            }
            store(notes.met + s, select(met, power, R(0))), store(notes.seen + s, select(seen, power, R(0)));
            store(notes.r + s, light.r), store(notes.g + s, light.g), store(notes.b + s, light.b);
            store(notes.face + s, select(own, power, R(0)));
        });
    }
    return sum_of(notes);
}

}  // namespace zerkalo::inline ZERKALO_ISA
