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

ZERKALO_INLINE Target target_of(const SolidPlan& solid, const TileLobe& lobe, const LobeProfile& profile,
                                bool all_of_it) {
    const Vec3<float> f = solid.bound_centre - lobe.p;
    const float inverse = 1 / sqrt(dot(f, f));
    const Vec3<float> u = f * inverse, aside = lobe.m - u;
    constexpr float kMostOfLobe = 0.6f;  // 2.4 of the 4.08 deviations of the cone
    const float ball = solid.bound_radius * inverse, cone = kMostOfLobe * sqrt(profile.edge);
    if (all_of_it || !(ball > cone)) return {u, tangents_of(u), ball};
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

/// What each scout tells of a solid: its power, and what it brings beyond the background, both 0 where it does not meet
/// the solid's face 0 (the only round one) or meets something before it.
struct ScoutNotes {
    alignas(64) float met[kScouts], seen[kScouts], face[kScouts], r[kScouts], g[kScouts], b[kScouts];
    std::uint32_t meets[kMaxSolids];   // of each rival, bit s: scout s meets it and the solid
    std::uint32_t before[kMaxSolids];  // and the rival first
};

/// Sums over the scouts, by the lobe's power and by what a ray counts there (render/cover_hidden.hpp).
struct Report {
    float met, seen;   // of squares of what they count; of what they count where the solid is seen
    float face;        // the same as `met` in face 0
    Rgb<float> light;  // what they bring there
};

/// One after another, for a packet may hold any number of scouts.
ZERKALO_INLINE Report sum_of(const ScoutNotes& notes, CandidateMask hidden_by) {
    Report sum{};
    for (std::int32_t s = 0; s < kScouts; ++s) {
        float counts = 1;
        for (CandidateMask left = hidden_by; left != 0; left &= left - 1) {
            counts -= float(notes.meets[first_of(left)] >> s & 1);
        }
        sum.met += notes.met[s] * counts * counts, sum.seen += notes.seen[s] * counts;
        sum.face += notes.face[s] * counts * counts;
        sum.light = sum.light + scaled(Rgb<float>{notes.r[s], notes.g[s], notes.b[s]}, counts);
    }
    return sum;
}

/// Of the rivals that hide a part of the solid those whose outlines are worth to be taken off its own: each hides more
/// scouts anew than it takes off twice.
ZERKALO_INLINE CandidateMask hiders_of(const ScoutNotes& notes, CandidateMask rivals) {
    CandidateMask chosen = 0;
    std::uint32_t hidden = 0;
    for (CandidateMask left = rivals; left != 0; left &= left - 1) {
        const int k = first_of(left);
        float anew = 0, twice = 0;
        for (std::int32_t s = 0; s < kScouts; ++s) {
            const bool taken = hidden >> s & 1;
            if (notes.before[k] >> s & 1 & !taken) anew += notes.met[s];
            if (notes.meets[k] >> s & 1 & (taken || !(notes.before[k] >> s & 1))) twice += notes.met[s];
        }
        if (!(anew > twice)) continue;
        chosen |= CandidateMask{1} << k;
        hidden |= notes.meets[k];
    }
    return chosen;
}

/// Sends the scouts from the tile's middle to solid k, which the rivals may hide: to the part near the lobe, or to all.
template <class R>
ZERKALO_ONCE void scout(ScoutNotes& notes, const Plan& plan, const TileLobe& lobe, int k, CandidateMask rivals,
                        bool all_of_it, TileCounts& counts) {
    const MirrorPlan& mirror = plan.mirrors[0];
    const SolidPlan& solid = plan.solids[k];
    const Target target = target_of(solid, lobe, mirror.profile, all_of_it);
    const PointOrigin<R> origin{spread<R>(lobe.p)};
    const Rgb<R> none_yet = spread<R>(Rgb<float>{0, 0, 0});
    for (CandidateMask left = rivals; left != 0; left &= left - 1) {
        notes.meets[first_of(left)] = notes.before[first_of(left)] = 0;
    }
    for (std::int32_t s = 0; s < kScouts; s += kWidth<R>) {
        const R side = load<R>(mirror.scouts.side + s) * R(target.radius);
        const R up = load<R>(mirror.scouts.up + s) * R(target.radius);
        const Vec3<R> towards = target.across.t * side + target.across.b * up + target.middle;
        const Vec3<R> d = towards * (R(1) / sqrt(dot(towards, towards)));
        const R power = power_towards(mirror.profile, dot(d, spread<R>(lobe.m)));
        const Nearest<R> own = nearest_solid(plan, CandidateMask{1} << k, origin, d);
        const auto met = own.id >= R(0);
        auto seen = met;
        for (CandidateMask left = rivals; left != 0; left &= left - 1) {
            const int other = first_of(left);
            const Nearest<R> rival = nearest_solid(plan, left & (~left + 1), origin, d);
            const auto meets = met & (rival.id >= R(0)), before = meets & !(own.t < rival.t);
            notes.meets[other] |= bits_of(meets) << s, notes.before[other] |= bits_of(before) << s;
            seen = seen & !before;
        }
        const auto face = met & (own.face == R(0)), shown = seen & face;
        Rgb<R> light = none_yet;
        if (any(shown)) {
            light = light_of_solid<R>(plan, solid, origin.o + d * own.t, own.face, d, shown, counts);
            light = select(shown, scaled(light - spread<R>(plan.background), power), none_yet);
        }
        store(notes.met + s, select(met, power, R(0))), store(notes.seen + s, select(seen, power, R(0)));
        store(notes.face + s, select(face, power, R(0)));
        store(notes.r + s, light.r), store(notes.g + s, light.g), store(notes.b + s, light.b);
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
