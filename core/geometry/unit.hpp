// A vector's direction and length, together.
#pragma once

#include "core/geometry/algebra.hpp"
#include "core/numeric/fixed_elementary.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// `unit`: v / |v|. Of the zero vector: NaN in float, the zero vector in fixed point.
template <class D, class L>
struct UnitOf {
    Vec3<D> unit;
    L length;
};

template <class R>
ZERKALO_INLINE UnitOf<R, R> unit_of(Vec3<R> v) {
    const R length = sqrt(dot(v, v));
    return {v * (R(1) / length), length};
}

/// All three components share one exponent, so that short vectors keep their digits.
template <class Rep, Format F>
ZERKALO_INLINE UnitOf<Direction<Fixed<Rep, F>>, Fixed<Rep, F>> unit_of(Vec3<Fixed<Rep, F>> v) {
    using T = LaneElement<Rep>;
    UnitOf<Direction<Fixed<Rep, F>>, Fixed<Rep, F>> result{};
    if constexpr (IntLaneTraits<Rep>::kInVectors) {
        const auto unit = unit_of_lanes(v.x.raw, v.y.raw, v.z.raw);
        result.unit.x.raw = unit.x, result.unit.y.raw = unit.y, result.unit.z.raw = unit.z;
        result.length.raw = unit.length;
        return result;
    }
    for (int k = 0; k < kLanesOf<Rep>; ++k) {
        const IntegerUnit one = unit_of_integers(lane_of(v.x.raw, k), lane_of(v.y.raw, k), lane_of(v.z.raw, k));
        set_lane(result.unit.x.raw, k, one.x);
        set_lane(result.unit.y.raw, k, one.y);
        set_lane(result.unit.z.raw, k, one.z);
        set_lane(result.length.raw, k, saturated<T>(magnitude_of(one.length), false));
    }
    return result;
}

}  // namespace zerkalo::inline ZERKALO_ISA
