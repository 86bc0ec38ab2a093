// Which lattice rays of a class of pixels can meet a solid: decided for all of them at once, with rays in the lanes.
//
// The pixels of a class lie in one tile and share the lattice. In the lobe's own frame a solid looks nearly the same
// from each of them: from the first one, the pilot, plus a stray delta. So a ray that passes the solid widened by delta
// in the pilot's frame passes the solid from every pixel. A ball is tried first, then the widened solid itself.
#pragma once

#include "core/numeric/shuffle.hpp"
#include "core/render/lattice_chunk.hpp"
#include "core/render/visibility.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The lobe's frame at each mirror point, turned by its class.
template <class R>
struct LobeFrame {
    Vec3<R> m, t, b;
};

template <class R>
ZERKALO_INLINE LobeFrame<R> lobe_frame(Vec3<R> m, SineCosine<float> phase) {
    const Tangents<R> base = tangents_of(m);
    const Vec3<R> t = base.t * phase.cosine + base.b * phase.sine;
    const Vec3<R> b = base.b * phase.cosine - base.t * phase.sine;
    return {m, t, b};
}

template <class R>
ZERKALO_INLINE Vec3<float> first_lane(Vec3<R> v) {
    return {first_lane(v.x), first_lane(v.y), first_lane(v.z)};
}

template <class R>
ZERKALO_INLINE R square(Vec3<R> v) {
    return dot(v, v);
}

/// Pixels that share one decision: fewer ask too often, more stray too far from the pilot (measured).
constexpr int kGroupPixels = 16;
template <class R>
constexpr int kGroupPackets = kWidth<R> < kGroupPixels ? kGroupPixels / kWidth<R> : 1;

/// The mirror points of a class's pixels and their frames, by packet; the last one is filled up with copies.
template <class R>
struct GroupFrames {
    Vec3<R> p[kGroupPackets<R>];
    LobeFrame<R> frame[kGroupPackets<R>];
    std::int32_t packets;
};

/// The first pixel's point and frame, and how far the other frames turn away from it (Frobenius norm).
struct LobePilot {
    Vec3<float> p, m, t, b;
    float turning;
};

template <class R>
ZERKALO_INLINE LobePilot pilot_of(const GroupFrames<R>& frames) {
    const LobeFrame<R>& first = frames.frame[0];
    LobePilot pilot{first_lane(frames.p[0]), first_lane(first.m), first_lane(first.t), first_lane(first.b), 0};
    R turning = R(0);
    for (std::int32_t i = 0; i < frames.packets; ++i) {
        const LobeFrame<R>& frame = frames.frame[i];
        turning =
            max(turning, square(frame.m - pilot.m) + square(frame.t - pilot.t) + square(frame.b - pilot.b));
    }
    pilot.turning = sqrt(largest_lane(turning));
    return pilot;
}

/// Bits of the rays that pass the bounding ball, centre c in the pilot's frame: c.w > 0 and (c.w)^2 >= |c|^2 - r^2.
template <class R>
ZERKALO_INLINE std::uint64_t rays_near_ball(const LatticeChunk& chunk, Vec3<float> c, float radius) {
    constexpr float kRoom = 0x1p-16f;  // far above the rounding of a few products
    const float beyond = dot(c, c) * (1 - kRoom) - radius * radius * (1 + kRoom);
    if (!(beyond > 0)) return ~std::uint64_t{0};
    std::uint64_t rays = 0;
    for (std::int32_t s = 0; s < chunk.count; s += kWidth<R>) {
        const R along =
            load<R>(chunk.side + s) * R(c.x) + load<R>(chunk.up + s) * R(c.y) + load<R>(chunk.forward + s) * R(c.z);
        const auto near = (along > R(0)) & (along * along >= R(beyond));
        rays |= static_cast<std::uint64_t>(bits_of(near)) << s;
    }
    return rays;
}

/// A solid that is not a sphere, widened on all sides, as the pilot sees it.
struct WidenedSolid {
    SlabOrigin<FloatNumbers<float>> slabs[kMaxSides + 1];
    TubeData tube;
    Vec3<float> tube_from;
};

ZERKALO_INLINE void widen(WidenedSolid& out, const Plan& plan, const SolidPlan& solid, Vec3<float> p, float delta) {
    using N = FloatNumbers<float>;
    if (solid.shape == ShapeKind::half_spaces) {
        const Slab* slabs = plan.slabs + solid.half_spaces.first_slab;
        const Vec3<float> o = p - solid.half_spaces.centre;
        for (std::int32_t s = 0; s < solid.half_spaces.slab_count; ++s) {
            const auto from = slab_seen_from<N>(slabs[s], o);
            out.slabs[s] = {from.lo - delta, from.hi + delta};
        }
    } else {
        out.tube = solid.tube;
        out.tube.mid_radius += delta / solid.tube.normal_scale;
        out.tube.half_height += delta;
        out.tube_from = tube_seen_from<N>(out.tube, p);
    }
}

/// Lanes whose ray from the pilot's point passes the widened solid.
template <class R>
ZERKALO_INLINE Mask<R> passes(const WidenedSolid& wide, const Plan& plan, const SolidPlan& solid, Vec3<R> d) {
    using N = FloatNumbers<R>;
    R entry = R(0), exit = R(0);
    if (solid.shape == ShapeKind::half_spaces) {
        Span<N> span = whole_span<N>();
        const Slab* slabs = plan.slabs + solid.half_spaces.first_slab;
        for (std::int32_t s = 0; s < solid.half_spaces.slab_count; ++s) {
            clip<Faces::none>(span, slabs[s], wide.slabs[s], d);
        }
        entry = span.entry, exit = span.exit;
    } else {
        const Span<N> span = tube_span<true, Faces::none, N>(wide.tube, wide.tube_from, d);
        entry = span.entry, exit = span.exit;
    }
    return Mask<R>((entry <= exit) & (exit >= R(0)));
}

/// The solid's centre in the lobe's frame at each point of a packet.
template <class R>
ZERKALO_INLINE Vec3<R> centre_in_frame(const SolidPlan& solid, const LobeFrame<R>& frame, Vec3<R> p) {
    const Vec3<R> f = solid.bound_centre - p;
    return {dot(f, frame.t), dot(f, frame.b), dot(f, frame.m)};
}

/// Which rays of the chunk may meet the solid from any pixel of the class. Conservative.
template <class R>
ZERKALO_INLINE std::uint64_t reach_of_chunk(const Plan& plan, const SolidPlan& solid, const LatticeChunk& chunk,
                                            const LobePilot& pilot, const GroupFrames<R>& frames) {
    Vec3<R> in_frame = centre_in_frame(solid, frames.frame[0], frames.p[0]);
    const Vec3<float> c = first_lane(in_frame);
    R stray2 = square(in_frame - c);
    for (std::int32_t i = 1; i < frames.packets; ++i) {
        in_frame = centre_in_frame(solid, frames.frame[i], frames.p[i]);
        stray2 = max(stray2, square(in_frame - c));
    }
    const float stray = sqrt(largest_lane(stray2));
    const std::uint64_t near = rays_near_ball<R>(chunk, c, solid.bound_radius + stray);
    if (near == 0 || solid.shape == ShapeKind::sphere) return near;
    // A point at q from the centre strays by at most stray + |q| turning; the rest is room for rounding.
    const float delta = (stray + solid.bound_radius * pilot.turning) * (1 + 0x1p-10f) +
                        0x1p-16f * (solid.bound_radius + sqrt(dot(c, c)));
    WidenedSolid wide;
    widen(wide, plan, solid, pilot.p, delta);
    std::uint64_t reach = 0;
    for (std::int32_t s = 0; s < chunk.count; s += kWidth<R>) {
        constexpr std::uint64_t kPacket = (std::uint64_t{1} << kWidth<R>)-1;
        if ((near >> s & kPacket) == 0) continue;
        const Vec3<R> d =
            pilot.m * load<R>(chunk.forward + s) + pilot.t * load<R>(chunk.side + s) + pilot.b * load<R>(chunk.up + s);
        reach |= static_cast<std::uint64_t>(bits_of(passes(wide, plan, solid, d))) << s;
    }
    return reach & near;
}

}  // namespace zerkalo::inline ZERKALO_ISA
