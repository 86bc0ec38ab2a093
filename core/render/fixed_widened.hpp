// Which rays of a chunk pass a solid that is no ball, widened on all sides: rays in the lanes, from one origin.
//
// A yes too many costs time and changes no picture: so kernels in vector registers ask in float, a third of the work,
// and widen by what its rounding may do. One lane asks in its integers.
#pragma once

#include "core/render/class_rays.hpp"
#include "core/render/fixed_tile.hpp"
#include "core/render/trace.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class L>
ZERKALO_INLINE void store_raw(typename L::Element* target, const L& x) {
    using Rep = typename L::Representation;
    if constexpr (!IntLaneTraits<Rep>::kInVectors) {
        for (int k = 0; k < kLanesOf<Rep>; ++k) target[k] = lane_of(x.raw, k);
    } else if constexpr (std::same_as<typename L::Element, std::int32_t>) {
        __builtin_memcpy(target, &x.raw.v, sizeof x.raw.v);
    } else {
        store_longs(target, x.raw.v);
    }
}
template <class L>
ZERKALO_INLINE L load_raw(const typename L::Element* source) {
    using Rep = typename L::Representation;
    L x{};
    if constexpr (!IntLaneTraits<Rep>::kInVectors) {
        for (int k = 0; k < kLanesOf<Rep>; ++k) set_lane(x.raw, k, source[k]);
    } else if constexpr (std::same_as<typename L::Element, std::int32_t>) {
        __builtin_memcpy(&x.raw.v, source, sizeof x.raw.v);
    } else {
        x.raw.v = load_longs(source);
    }
    return x;
}

/// The numbers that decide which rays are traced.
template <class R, bool in_vectors = IntLaneTraits<Mask<R>>::kInVectors>
struct AimNumbersOf { using type = System<R>; };
template <class R>
struct AimNumbersOf<R, true> { using type = FloatNumbers<Real<kWidth<R>>>; };
template <class R>
using AimNumbers = typename AimNumbersOf<R>::type;

/// The same number as a float, if that is what is asked for.
template <class To, class Rep, Format F>
ZERKALO_INLINE To number_as(Fixed<Rep, F> x) {
    if constexpr (std::same_as<To, Fixed<Rep, F>>) {
        return x;
    } else {
        return float(x.raw) * (1.0f / float(std::int64_t{1} << F.fraction));
    }
}
template <class To, class From>
ZERKALO_INLINE Vec3<To> number_as(const Vec3<From>& v) {
    return {number_as<To>(v.x), number_as<To>(v.y), number_as<To>(v.z)};
}

/// kWidth<R> directions of a chunk, in its own frame.
template <class R>
    requires(Formats<AimNumbers<R>>::kFixed)
ZERKALO_INLINE Direction<R> load_directions(const std::int32_t* source) {
    return load_raw<Direction<R>>(source);
}
#if defined(ZERKALO_INT_VECTORS)
template <class R>
    requires(!Formats<AimNumbers<R>>::kFixed)
ZERKALO_INLINE Real<kVectorWidth> load_directions(const std::int32_t* source) {
    static_assert(Direction<R>::kFraction == 30);
    Words raw;
    __builtin_memcpy(&raw, source, sizeof raw);
    const auto real = __builtin_convertvector(raw, Vector<float, kVectorWidth>) * 0x1p-30f;
    alignas(64) float lanes[kVectorWidth];
    __builtin_memcpy(lanes, &real, sizeof real);
    return load<Real<kVectorWidth>>(lanes);
}
#endif

/// The first pixel's point and frame, and how far the other frames turn away from it (Frobenius norm).
template <class R>
struct LobePilot {
    using One = Uniform<R>;
    Vec3<Length<One>> o;
    Vec3<Direction<One>> m, t, b;
    Length<One> turning;
};

/// A solid that is no ball, widened on all sides, as the pilot sees it.
template <class R>
struct WidenedSolid {
    using One = Uniform<AimNumbers<R>>;
    struct Side {
        Vec3<Direction<One>> n;
        SlabOrigin<One> from;
    };
    Side sides[kMaxSides + 1];
    TubeDataOf<Formats<One>> tube;
    Vec3<Length<One>> from;
};

template <class R>
ZERKALO_INLINE void widen_tube(WidenedSolid<R>& wide, const TubeDataOf<FixedFormats>& tube, Vec3<Length<Uniform<R>>> o,
                               Length<Uniform<R>> delta) {
    using One = typename WidenedSolid<R>::One;
    using L = Length<One>;
    const L room = number_as<L>(delta);
    if constexpr (Formats<One>::kFixed) {
        wide.tube = tube;
    } else {
        using D = Direction<One>;
        wide.tube.centre = number_as<L>(tube.centre);
        wide.tube.axis_x = number_as<D>(tube.axis_x), wide.tube.axis_y = number_as<D>(tube.axis_y);
        wide.tube.axis_z = number_as<D>(tube.axis_z);
        wide.tube.mid_radius = number_as<L>(tube.mid_radius), wide.tube.slope = number_as<L>(tube.slope);
        wide.tube.half_height = number_as<L>(tube.half_height);
        wide.tube.normal_scale = number_as<D>(tube.normal_scale);
        wide.tube.upright = tube.upright;
    }
    const L wider = quotient<L>(room, wide.tube.normal_scale);
    wide.tube.mid_radius = wide.tube.mid_radius + wider;
    wide.tube.half_height = wide.tube.half_height + room;
    if constexpr (Formats<One>::kFixed) {
        // At its larger end the radius grows by at most twice as much.
        const L reach = root<L>(tube.reach2) + (wider + wider + room);
        wide.tube.reach2 = reach * reach;
    }
    wide.from = tube_seen_from<One>(wide.tube, number_as<L>(o));
}

template <class R>
ZERKALO_INLINE void widen_slabs(WidenedSolid<R>& wide, const PlanFor<R>& plan,
                                const HalfSpacesDataOf<FixedFormats>& body, Vec3<Length<Uniform<R>>> o,
                                Length<Uniform<R>> delta) {
    using One = typename WidenedSolid<R>::One;
    using L = Length<One>;
    const L room = number_as<L>(delta);
    const Vec3<L> way = number_as<L>(o) - number_as<L>(body.centre);
    for (std::int32_t s = 0; s < body.slab_count; ++s) {
        const auto& slab = plan.slabs[body.first_slab + s];
        const Vec3<Direction<One>> n = number_as<Direction<One>>(slab.n);
        const L at = as<L>(dot(n, way));
        wide.sides[s] = {n, {number_as<L>(slab.lo) - at - room, number_as<L>(slab.hi) - at + room}};
    }
}

/// Lanes whose ray from the pilot's point passes the widened solid.
template <class R>
ZERKALO_INLINE auto passes(const WidenedSolid<R>& wide, const SolidPlanFor<R>& solid,
                           Vec3<Direction<AimNumbers<R>>> d) {
    using S = AimNumbers<R>;
    Span<S> span = whole_span<S>();
    if (solid.shape == ShapeKind::tube) {
        span = tube_span<true, Faces::none, S>(wide.tube, wide.from, d);
    } else {
        for (std::int32_t s = 0; s < solid.half_spaces.slab_count; ++s) {
            clip<Faces::none>(span, wide.sides[s], wide.sides[s].from, d);
        }
    }
    return (span.entry <= span.exit) & (span.exit >= Length<S>(0));
}

/// Rays among `near` that pass the solid widened by delta, from the pilot.
template <class R>
ZERKALO_ONCE RayMask rays_through(const PlanFor<R>& plan, const SolidPlanFor<R>& solid, const RayChunk& chunk,
                                  RayMask near, const LobePilot<R>& pilot, Length<Uniform<R>> delta) {
    using S = AimNumbers<R>;
    using D = Direction<S>;
    using One = Direction<Uniform<S>>;
    // What float's rounding may move: lengths up to 15, to 24 bits each, in a few steps.
    constexpr auto kRoom = Length<Uniform<R>>::from_raw(1 << 15);
    if constexpr (!Formats<S>::kFixed) delta = delta + kRoom;
    WidenedSolid<R> wide;
    if (solid.shape == ShapeKind::tube) {
        widen_tube<R>(wide, solid.tube, pilot.o, delta);
    } else {
        widen_slabs<R>(wide, plan, solid.half_spaces, pilot.o, delta);
    }
    const Vec3<One> m = number_as<One>(pilot.m), t = number_as<One>(pilot.t), b = number_as<One>(pilot.b);
    RayMask through = 0;
    for (std::int32_t i = 0; i < kRayChunk && near >> i != 0; i += kWidth<R>) {
        if ((near >> i & ((RayMask{1} << (kWidth<R> - 1) << 1) - 1)) == 0) continue;
        const D side = load_directions<R>(chunk.side + i), up = load_directions<R>(chunk.up + i);
        const D forward = load_directions<R>(chunk.forward + i);
        const Vec3<D> d = as<D>(spread<D>(m) * forward + spread<D>(t) * side + spread<D>(b) * up);
        through |= RayMask{bits_of(passes<R>(wide, solid, d))} << i;
    }
    return near & through;
}

}  // namespace zerkalo::inline ZERKALO_ISA
