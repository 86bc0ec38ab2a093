// Which rays of a lobe can meet which solids, for a tile's pixels of one lattice class in fixed point.
//
// The pixels share the directions of their rays in the lobe's own frame, where a solid's bounding ball looks nearly the
// same from each of them. So the ball as the first pixel sees it, widened by how far it strays for the others, is asked
// once for all: with rays in the lanes. What an intersection owes to the origins of a packet is computed here too.
#pragma once

#include "core/render/fixed_widened.hpp"
#include "core/render/trace.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// In sums of neighbours: processors without the instruction have no library here.
constexpr std::int32_t count_of_rays(RayMask rays) {
    rays -= rays >> 1 & 0x55555555u;
    rays = (rays & 0x33333333u) + (rays >> 2 & 0x33333333u);
    return static_cast<std::int32_t>(((rays + (rays >> 4)) & 0x0f0f0f0fu) * 0x01010101u >> 24);
}
constexpr RayMask first_rays(std::int32_t count) { return count < kRayChunk ? (RayMask{1} << count) - 1 : ~RayMask{0}; }

// Sixteen lanes of them take as much stack as there is.
template <class R>
constexpr int kMostAimed = kWidth<R> > 8 ? 4 : 8;
template <class R>
constexpr int kHoistedSlabs = kWidth<R> > 8 ? 10 : 16;

/// A solid that some rays may meet from some pixels, and what its intersections owe to the origins.
template <class R>
struct AimedSolid {
    RayMask rays;
    std::int32_t k;
    std::int32_t first_slab;  // its first hoisted one, or -1: there was no room
    Vec3<Length<R>> from;
    Area<R> c;
};

/// What the lobes of a packet share.
template <class R>
struct PacketLobes {
    Vec3<Length<R>> o;
    Vec3<Direction<R>> m;
    Tangents<Direction<R>> base;
    Mask<R> active;
};

/// The lobes of a class.
template <class R>
struct ClassLobes {
    static constexpr int kMostPackets = kTilePixels / kLatticeClasses / kWidth<R>;
    PacketLobes<R> packets[kMostPackets];
    int count;
};

/// The solids that the lobes of a class can meet, and what one packet of them needs to ask.
template <class R>
struct LobeAim {
    Vec3<Length<R>> o;
    AimedSolid<R> solids[kMostAimed<R>];
    SlabOrigin<System<R>> slabs[kHoistedSlabs<R>];
    std::int32_t count, used_slabs;
    RayMask rays;  // that may meet any of them
};

/// Rays that pass a ball about c, in the lobe's frame, from its origin:
///     |c| <= r, or c.w > 0 and (c.w)^2 >= |c|^2 - r^2
template <class R>
ZERKALO_INLINE RayMask rays_near_ball(const RayChunk& chunk, std::int32_t count, Vec3<Length<Uniform<R>>> c,
                                      Area<Uniform<R>> beyond) {
    using D = Direction<R>;
    if (beyond <= Area<Uniform<R>>(0)) return first_rays(count);
    RayMask rays = 0;
    for (std::int32_t i = 0; i < count; i += kWidth<R>) {
        const Vec3<D> w{load_raw<D>(chunk.side + i), load_raw<D>(chunk.up + i), load_raw<D>(chunk.forward + i)};
        const auto along = as<Length<R>>(dot(spread<Length<R>>(c), w));
        const auto near = (along > Length<R>(0)) & (along * along >= Area<R>(beyond));
        rays |= RayMask{bits_of(near)} << i;
    }
    return rays & first_rays(count);
}

/// The largest lane.
template <class A, Format F>
ZERKALO_INLINE auto largest_lane_of(const Fixed<A, F>& x) {
    auto most = lane_of(x.raw, 0);
    for (int k = 1; k < kLanesOf<A>; ++k) most = lane_of(x.raw, k) > most ? lane_of(x.raw, k) : most;
    return with_format<F>(most);
}

constexpr int kFewSteps = 1 << 4;    // of a length: room for the rounding of a few terms
constexpr int kFewRays = 3;
constexpr int kManySteps = 1 << 11;  // and of points as far away as the scene is large

template <class L>
ZERKALO_INLINE auto first_lane_of(const Vec3<L>& v) {
    using One = Fixed<typename L::Element, L::kFormat>;
    return Vec3<One>{One::from_raw(lane_of(v.x.raw, 0)), One::from_raw(lane_of(v.y.raw, 0)),
                     One::from_raw(lane_of(v.z.raw, 0))};
}

template <class R>
ZERKALO_INLINE LobePilot<R> pilot_of(const ClassLobes<R>& lobes) {
    using D = Direction<R>;
    using L = Length<R>;
    const PacketLobes<R>& first = lobes.packets[0];
    LobePilot<R> pilot{first_lane_of(first.o), first_lane_of(first.m), first_lane_of(first.base.t),
                       first_lane_of(first.base.b), {}};
    const auto away = [](const Vec3<D>& v, const auto& from) ZERKALO_INLINE_LAMBDA {
        const auto off = as<L>(v - spread<D>(from));
        return dot(off, off);
    };
    Area<R> most(0);
    for (int p = 0; p < lobes.count; ++p) {
        const PacketLobes<R>& own = lobes.packets[p];
        most = max(most, Area<R>(away(own.m, pilot.m) + away(own.base.t, pilot.t) + away(own.base.b, pilot.b)));
    }
    pilot.turning = root<Length<Uniform<R>>>(largest_lane_of(most)) + Length<Uniform<R>>::from_raw(kFewSteps);
    return pilot;
}

/// Rays of the chunk that may meet the solid from some pixel. Conservative.
template <class R>
ZERKALO_INLINE RayMask rays_to_solid(const PlanFor<R>& plan, const SolidPlanFor<R>& solid, const RayChunk& chunk,
                                     std::int32_t count, const LobePilot<R>& pilot, const ClassLobes<R>& lobes) {
    using L = Length<R>;
    using One = Length<Uniform<R>>;
    Vec3<One> c{};
    Area<R> most(0);
    for (int p = 0; p < lobes.count; ++p) {
        const PacketLobes<R>& own = lobes.packets[p];
        const Vec3<L> f = fitting_difference(solid.bound_centre, own.o);
        const Vec3<L> centre{rounded<L>(dot(f, own.base.t)), rounded<L>(dot(f, own.base.b)), rounded<L>(dot(f, own.m))};
        if (p == 0) c = first_lane_of(centre);
        const Vec3<L> off = centre - spread<L>(c);
        most = max(most, Area<R>(dot(off, off)));
    }
    const One stray = root<One>(largest_lane_of(most)) + One::from_raw(kFewSteps);
    if (stray > One(1)) return first_rays(count);
    const One reach = solid.bound_radius + stray;
    const RayMask near = rays_near_ball<R>(chunk, count, c, dot(c, c) - (reach * reach + kSquareRoom<R>));
    // For a few rays the solid itself is not asked more than the widened one would be.
    if (count_of_rays(near) < kFewRays || solid.shape == ShapeKind::sphere) return near;
    // A point at q from the centre strays by at most stray + |q| turning.
    const One delta = stray + as<One>(solid.bound_radius * pilot.turning) + One::from_raw(kManySteps);
    return rays_through<R>(plan, solid, chunk, near, pilot, delta);
}

template <class R>
ZERKALO_INLINE void hoist(AimedSolid<R>& aimed, LobeAim<R>& aim, const PlanFor<R>& plan) {
    using N = System<R>;
    const SolidPlanFor<R>& solid = plan.solids[aimed.k];
    aimed.first_slab = -1;
    if (solid.shape == ShapeKind::sphere) {
        const auto seen = sphere_seen_from<N>(solid.sphere, aim.o);
        aimed.from = seen.f, aimed.c = seen.c;
    } else if (solid.shape == ShapeKind::tube) {
        aimed.from = tube_seen_from<N>(solid.tube, aim.o);
    } else if (aim.used_slabs + solid.half_spaces.slab_count <= kHoistedSlabs<R>) {
        aimed.first_slab = aim.used_slabs;
        const auto* slabs = plan.slabs + solid.half_spaces.first_slab;
        const Vec3<Length<R>> o = aim.o - solid.half_spaces.centre;
        for (std::int32_t s = 0; s < solid.half_spaces.slab_count; ++s) {
            aim.slabs[aim.used_slabs++] = slab_seen_from<N>(slabs[s], o);
        }
    }
}

/// Chooses among the candidates for the rays of a chunk. False where there are too many: then any ray may meet any of
/// them.
template <class R>
ZERKALO_ONCE bool aim_lobes(LobeAim<R>& aim, const PlanFor<R>& plan, CandidateMask candidates, const RayChunk& chunk,
                            std::int32_t count, const ClassLobes<R>& lobes) {
    aim.count = 0;
    aim.rays = 0;
    const LobePilot<R> pilot = pilot_of<R>(lobes);
    for (CandidateMask left = candidates; left != 0; left &= left - 1) {
        const int k = first_of(left);
        const RayMask rays = rays_to_solid<R>(plan, plan.solids[k], chunk, count, pilot, lobes);
        if (rays == 0) continue;
        if (aim.count == kMostAimed<R>) return false;
        aim.solids[aim.count].rays = rays;
        aim.solids[aim.count].k = k;
        aim.rays |= rays;
        ++aim.count;
    }
    return true;
}

/// Readies the aim for the packet whose lobes begin at o.
template <class R>
ZERKALO_INLINE void stand_at(LobeAim<R>& aim, const PlanFor<R>& plan, const Vec3<Length<R>>& o) {
    aim.o = o;
    aim.used_slabs = 0;
    for (std::int32_t c = 0; c < aim.count; ++c) hoist(aim.solids[c], aim, plan);
}

/// Hands `use` the span of an aimed solid along d.
template <class R, class Use>
ZERKALO_INLINE void with_aimed_span(const PlanFor<R>& plan, const LobeAim<R>& aim, const AimedSolid<R>& aimed,
                                    Vec3<Direction<R>> d, Use use) {
    using N = System<R>;
    const SolidPlanFor<R>& solid = plan.solids[aimed.k];
    if (solid.shape == ShapeKind::sphere) {
        use(sphere_span<N>(solid.sphere, SphereOrigin<N>{aimed.from, aimed.c}, d));
    } else if (solid.shape == ShapeKind::half_spaces) {
        if (aimed.first_slab < 0) {
            return use(half_spaces_span<Faces::entry, R>(plan, solid.half_spaces, PointOrigin<Length<R>>{aim.o}, d));
        }
        const SlabOrigin<N>* own = aim.slabs + aimed.first_slab;
        const auto seen = [own](std::int32_t s) ZERKALO_INLINE_LAMBDA { return own[s]; };
        use(slabs_span<Faces::entry, N>(plan.slabs + solid.half_spaces.first_slab, solid.half_spaces.slab_count, d,
                                        seen));
    } else if (solid.tube.tapered) {
        use(tube_span<true, Faces::entry, N>(solid.tube, aimed.from, d));
    } else {
        use(tube_span<false, Faces::entry, N>(solid.tube, aimed.from, d));
    }
}

/// The nearest of the solids that ray i may meet; adds them to `asked`.
template <class R>
ZERKALO_ONCE Nearest<R> nearest_aimed(const PlanFor<R>& plan, const LobeAim<R>& aim, std::int32_t i,
                                      const Vec3<Direction<R>>& d, const Mask<R>& active, CandidateMask& asked) {
    Nearest<R> best = nothing_yet<R>();
    for (std::int32_t c = 0; c < aim.count; ++c) {
        const AimedSolid<R>& aimed = aim.solids[c];
        if (!(aimed.rays >> i & 1)) continue;
        asked |= CandidateMask{1} << aimed.k;
        with_aimed_span<R>(plan, aim, aimed, d, [&](const Span<System<R>>& span) ZERKALO_INLINE_LAMBDA {
            keep_nearer<R>(best, span, plan.solids[aimed.k], active & (span.entry <= span.exit));
        });
    }
    return best;
}

}  // namespace zerkalo::inline ZERKALO_ISA
