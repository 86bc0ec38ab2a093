// The pixels of a tile whose lobes wait in fixed point, and which of these can meet anything.
#pragma once

#include "core/render/fixed_aim.hpp"
#include "core/render/packet.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// The light of a tile's pixels, as raw integers, in the order of place_of_pixel().
struct LightSums {
    alignas(64) std::int64_t r[kTilePixels], g[kTilePixels], b[kTilePixels];
};

/// Pixels whose lobes must send rays: mirror points and mirror directions, as raw integers, and what the rays can meet.
struct WaitingLobes {
    alignas(64) std::int32_t o[3][kTilePixels], m[3][kTilePixels];
    std::uint64_t pixels;
    CandidateMask candidates;
};

/// The lanes of a packet as pixels of the tile, and the places of their light; those past its end are copies of its
/// last one.
struct PacketPixels {
    std::uint8_t of_lane[kWidestLane], place_of_lane[kWidestLane];
};

template <class L>
ZERKALO_INLINE L gather_words(const std::int32_t* source, const PacketPixels& pixels) {
    constexpr int kLanes = kLanesOf<typename L::Representation>;
    alignas(64) std::int32_t lanes[kLanes];
    for (int k = 0; k < kLanes; ++k) lanes[k] = source[pixels.of_lane[k]];
    return load_raw<L>(lanes);
}
template <class L>
ZERKALO_INLINE Vec3<L> gather_vector(const std::int32_t (&source)[3][kTilePixels], const PacketPixels& pixels) {
    return {gather_words<L>(source[0], pixels), gather_words<L>(source[1], pixels), gather_words<L>(source[2], pixels)};
}
template <class R>
ZERKALO_INLINE LightSum<R> gather_longs(const std::int64_t* source, const PacketPixels& pixels) {
    alignas(64) std::int64_t lanes[kWidth<R>];
    for (int k = 0; k < kWidth<R>; ++k) lanes[place_of_long<R>(k)] = source[pixels.place_of_lane[k]];
    return load_raw<LightSum<R>>(lanes);
}

template <class R>
ZERKALO_INLINE void store_sum(LightSums& sums, int first, const Rgb<LightSum<R>>& sum) {
    store_raw(sums.r + first, sum.r), store_raw(sums.g + first, sum.g), store_raw(sums.b + first, sum.b);
}
template <class R>
ZERKALO_INLINE Rgb<LightSum<R>> load_sum(const LightSums& sums, int first) {
    using S = LightSum<R>;
    return {load_raw<S>(sums.r + first), load_raw<S>(sums.g + first), load_raw<S>(sums.b + first)};
}
template <class R>
ZERKALO_INLINE Rgb<LightSum<R>> gather_sum(const LightSums& sums, const PacketPixels& pixels) {
    return {gather_longs<R>(sums.r, pixels), gather_longs<R>(sums.g, pixels), gather_longs<R>(sums.b, pixels)};
}
/// The active lanes come first.
template <class R>
ZERKALO_INLINE void scatter_sum(LightSums& sums, const PacketPixels& pixels, Mask<R> active,
                                const Rgb<LightSum<R>>& sum) {
    alignas(64) std::int64_t r[kWidth<R>], g[kWidth<R>], b[kWidth<R>];
    store_raw(r, sum.r), store_raw(g, sum.g), store_raw(b, sum.b);
    for (int k = 0; k < static_cast<int>(count_of(active)); ++k) {
        const int to = pixels.place_of_lane[k], from = place_of_long<R>(k);
        sums.r[to] = r[from], sums.g[to] = g[from], sums.b[to] = b[from];
    }
}

template <class R>
ZERKALO_INLINE void enqueue(WaitingLobes& waiting, Mask<R> mask, const Vec3<Length<R>>& o, const Vec3<Direction<R>>& m,
                            int first) {
    store_raw(waiting.o[0] + first, o.x), store_raw(waiting.o[1] + first, o.y), store_raw(waiting.o[2] + first, o.z);
    store_raw(waiting.m[0] + first, m.x), store_raw(waiting.m[1] + first, m.y), store_raw(waiting.m[2] + first, m.z);
    waiting.pixels |= std::uint64_t{bits_of(mask)} << first;
}

template <class R>
struct WaitingPacket {
    Vec3<Length<R>> o;
    Vec3<Direction<R>> m;
    Mask<R> active;
};
template <class R>
ZERKALO_INLINE WaitingPacket<R> load_waiting(const WaitingLobes& waiting, int first) {
    using L = Length<R>;
    using D = Direction<R>;
    return {{load_raw<L>(waiting.o[0] + first), load_raw<L>(waiting.o[1] + first), load_raw<L>(waiting.o[2] + first)},
            {load_raw<D>(waiting.m[0] + first), load_raw<D>(waiting.m[1] + first), load_raw<D>(waiting.m[2] + first)},
            lanes_of_bits<R>(waiting.pixels >> first)};
}

/// The largest component: at least the distance over the root of 3.
template <class L>
ZERKALO_INLINE L largest_of(const Vec3<L>& v) {
    return max(max(absolute(v.x), absolute(v.y)), absolute(v.z));
}

/// Solids that some waiting pixel's lobe may be near, by the lobe of the first one: the others' points and directions
/// stray from it.
template <class R>
ZERKALO_INLINE CandidateMask solids_near_lobes(const PlanFor<R>& plan, const WaitingLobes& waiting) {
    using One = Uniform<R>;
    using L = Length<R>;
    using D = Direction<R>;
    const int pilot = first_of(waiting.pixels);
    const WaitingPacket<One> at = load_waiting<One>(waiting, pilot);
    L stray(0);
    D turn(0);
    for (int first = 0; first < kTilePixels; first += kWidth<R>) {
        const WaitingPacket<R> packet = load_waiting<R>(waiting, first);
        if (none(packet.active)) continue;
        const L off = largest_of(fitting_difference(packet.o, spread<L>(at.o)));
        stray = max(stray, select(packet.active, off, L(0)));
        turn = max(turn, select(packet.active, largest_of(packet.m - spread<D>(at.m)), D(0)));
    }
    // More than the root of the packets' own room.
    constexpr auto kRoom = Length<One>::from_raw(1 << 18);
    const auto most_off = largest_lane_of(stray), most_angle = as<Length<One>>(largest_lane_of(turn));
    const auto most_stray = most_off + most_off + kRoom, most_turn = most_angle + most_angle;
    CandidateMask near = 0;
    for (std::int32_t k = 0; k < plan.solid_count; ++k) {
        const auto way = plan.solids[k].bound_centre - at.o;
        const auto far = root<Length<One>>(dot_of_ways(way, way)) + kRoom;
        const auto around = most_stray + as<Length<One>>(far * most_turn);
        if (cone_may_meet<One>(plan.solids[k], plan.mirrors[0].lobe, at.o, at.m, around)) near |= CandidateMask{1} << k;
    }
    return near;
}

/// Takes away the pixels whose lobes meet nothing, with their light; finds what the others can meet.
template <class R>
ZERKALO_ONCE void cull_lobes(const PlanFor<R>& plan, WaitingLobes& waiting, LightSums& sums) {
    const LobeFor<R>& lobe = plan.mirrors[0].lobe;
    const bool narrow = !plan.exact_plan && lobe.cone.narrow;
    const CandidateMask solids = narrow ? solids_near_lobes<R>(plan, waiting) : solids_in(all_of(plan));
    std::uint64_t sending = 0;
    waiting.candidates = 0;
    using One = Uniform<R>;
    Rgb<LightSum<One>> whole_lobe{LightSum<One>(0), LightSum<One>(0), LightSum<One>(0)};
    add_whole_lobe<One>(plan, true, full_throughput<One>(plan), whole_lobe);
    for (int first = 0; first < kTilePixels; first += kWidth<R>) {
        const WaitingPacket<R> packet = load_waiting<R>(waiting, first);
        if (none(packet.active)) continue;
        Rgb<LightSum<R>> sum = load_sum<R>(sums, first);
        CandidateMask candidates;
        const Mask<R> with_rays = lanes_with_rays<R>(
            plan, lobe, packet.o, packet.m, packet.active, candidates, solids,
            [&](const Mask<R>& empty) ZERKALO_INLINE_LAMBDA { add_uniform<R>(sum, empty, whole_lobe); });
        store_sum<R>(sums, first, sum);
        sending |= std::uint64_t{bits_of(with_rays)} << first;
        waiting.candidates |= candidates;
    }
    waiting.pixels = sending;
}

}  // namespace zerkalo::inline ZERKALO_ISA
