// Which pixels a packet holds, the camera rays through them, and the per-pixel phase of the lobe lattice.
#pragma once

#include "core/geometry/unit.hpp"
#include "core/optics/lattice.hpp"
#include "core/render/plan.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// 0, 1, ... as lanes and as bits, and 2 to their powers.
struct LaneNumbers {
    float real[16];
    std::uint32_t bits[16], powers[16];
};
constexpr LaneNumbers kLaneNumbers{{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
                                   {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
                                   {1u, 1u << 1, 1u << 2, 1u << 3, 1u << 4, 1u << 5, 1u << 6, 1u << 7, 1u << 8,
                                    1u << 9, 1u << 10, 1u << 11, 1u << 12, 1u << 13, 1u << 14, 1u << 15}};

/// Column and row of the pixels of a tile, row-major: of any packet's lanes, from its first pixel's.
struct LanePlaces {
    float real[16];
    int whole[16];
};
constexpr LanePlaces kColumns{{0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7},
                              {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7}};
constexpr LanePlaces kRows{{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1},
                           {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1}};
static_assert(kTileSide == 8);

/// A whole number of pixels as the system R counts them.
template <class R>
ZERKALO_INLINE Pixels<R> pixels_of(std::int32_t count) {
    if constexpr (Formats<R>::kFixed) {
        return Pixels<Uniform<R>>(count);
    } else {
        return R(float(count));
    }
}

/// kWidth<R> entries of a table of small whole numbers.
template <class R>
ZERKALO_INLINE Pixels<R> load_places(const LanePlaces& places, int first) {
    if constexpr (Formats<R>::kFixed) {
        Pixels<R> result{};
        for (int k = 0; k < kWidth<R>; ++k) set_lane(result.raw, k, Pixels<Uniform<R>>(places.whole[first + k]).raw);
        return result;
    } else {
        return load<R>(places.real + first);
    }
}

/// Columns and rows of kWidth<R> neighbours of a tile, row-major from its pixel `first`, a multiple of the width.
template <class R>
ZERKALO_INLINE Pixels<R> column_lanes(const Rect& tile, int first) {
    return load_places<R>(kColumns, first % kTileSide) + pixels_of<R>(tile.left);
}
template <class R>
ZERKALO_INLINE Pixels<R> row_lanes(const Rect& tile, int first) {
    const Pixels<R> row = pixels_of<R>(tile.top + first / kTileSide);
    if constexpr (kWidth<R> <= kTileSide) return row;
    return row + load_places<R>(kRows, 0);
}

/// Lanes whose bit is set.
template <class R>
ZERKALO_INLINE Mask<R> lanes_of_bits(std::uint64_t bits) {
    if constexpr (requires { StoredMask<R>::of_bits(0u); }) {
        return StoredMask<R>::of_bits(static_cast<std::uint32_t>(bits));
    } else if constexpr (Formats<R>::kFixed || kWidth<R> == 1) {
        auto set = mask_of<R>(false);
        for (int k = 0; k < kWidth<R>; ++k) set_lane(set, k, (bits >> k & 1) != 0);
        return set;
    } else {
        // A lane's bit makes a float of [1, 2) more than 1.
        const auto here = Bits<R>(static_cast<std::uint32_t>(bits)) & load_bits<R>(kLaneNumbers.powers);
        return from_bits(here | Bits<R>(0x3f800000u)) > R(1);
    }
}

/// Lanes whose pixel is one of the tile's.
template <class R>
ZERKALO_INLINE Mask<R> lanes_of(const Tile& tile, int first) {
    return tile.pixels == kWholeTile ? mask_of<R>(true) : lanes_of_bits<R>(tile.pixels >> first);
}

/// A point of the pixel, from its centre, in pixels.
template <class P>
struct SubPixelOf {
    P x, y;
};
using SubPixel = SubPixelOf<float>;

/// Camera sample a of n: a Fibonacci lattice over the pixel's square; one sample is the centre.
template <class N>
ZERKALO_INLINE SubPixelOf<Pixels<N>> sub_pixel(std::int32_t a, std::int32_t n) {
    using P = Pixels<N>;
    if (n == 1) return {P(0), P(0)};
    const auto phase = static_cast<std::uint32_t>(a) * kGoldenTurn;
    if constexpr (Formats<N>::kFixed) {
        // A turn is a pixel here: 2^32 steps of the phase.
        const auto shifted = static_cast<std::int32_t>(phase ^ 0x80000000u);
        const std::int32_t x = rounded_quotient<std::int32_t, P::kFraction - 1>(2 * a + 1 - n, n);
        return {P::from_raw(x), P::from_raw(rescaled<std::int32_t, 32 - P::kFraction>(shifted))};
    } else {
        return {(P(a) + P(0.5f)) / P(n) - P(0.5f), turn_of_phase<P>(phase)};
    }
}

/// Twice the way from the picture's middle to a pixel's point, to the right and upwards.
template <class R, class P>
ZERKALO_INLINE R twice_across(const PlanHead& plan, R x, SubPixelOf<P> at) {
    return (x + x) + (R(at.x + at.x) - pixels_of<Numbers<R>>(plan.width - 1));
}
template <class R, class P>
ZERKALO_INLINE R twice_upwards(const PlanHead& plan, R y, SubPixelOf<P> at) {
    return pixels_of<Numbers<R>>(plan.height - 1) - (y + y) - R(at.y + at.y);
}

/// Seed formulas 2.5-2.10 with the pixel's centre; see CameraPlan. The part that a column of pixels shares, and the
/// whole, not normalised.
template <class F, class P>
ZERKALO_INLINE Vec3<View<P>> towards_column(const CameraPlanOf<F>& camera, P across) {
    return fitting_sum(camera.view, rounded_product<View<P>>(camera.step_x, across));
}
template <class F, class V, class P>
ZERKALO_INLINE Vec3<V> towards_pixel(const CameraPlanOf<F>& camera, Vec3<V> column, P upwards) {
    return fitting_sum(column, rounded_product<V>(camera.step_y, upwards));
}

/// Directions to the columns of a tile, by packet.
template <class R>
struct TileColumns {
    static constexpr int kPackets = kWidth<R> < kTileSide ? kTileSide / kWidth<R> : 1;
    Vec3<View<R>> towards[kPackets];
};

template <class R, class P>
ZERKALO_INLINE void fill_columns(TileColumns<R>& columns, const PlanOf<Formats<R>>& plan, const Rect& tile,
                                 SubPixelOf<P> at) {
    for (int c = 0; c < TileColumns<R>::kPackets; ++c) {
        const Pixels<R> x = column_lanes<R>(tile, c * kWidth<R>);
        columns.towards[c] = towards_column(plan.camera, twice_across(plan, x, at));
    }
}

template <class R>
struct CameraRay {
    Vec3<Length<R>> o;
    Vec3<Direction<R>> d;
    Length<R> t_min;
};

/// The row of a packet's pixels: one that all lanes share, where the tile is as wide.
template <class R>
ZERKALO_INLINE auto packet_row(const Rect& tile, int first) {
    if constexpr (kWidth<R> <= kTileSide) {
        return Pixels<Uniform<R>>(pixels_of<Numbers<Pixels<Uniform<R>>>>(tile.top + first / kTileSide));
    } else {
        return row_lanes<R>(tile, first);
    }
}

/// The rays through a point of each pixel of a packet, also from far away.
template <class R, class P>
ZERKALO_INLINE CameraRay<R> camera_ray(const PlanOf<Formats<R>>& plan, const TileColumns<R>& columns, const Rect& tile,
                                       int first, SubPixelOf<P> at) {
    using L = Length<R>;
    using F = FarStep<R>;
    const auto& camera = plan.camera;
    const auto upwards = twice_upwards(plan, packet_row<R>(tile, first), at);
    const int packet = first / kWidth<R> % TileColumns<R>::kPackets;
    const auto towards = unit_of(towards_pixel(camera, columns.towards[packet], upwards));
    CameraRay<R> ray{spread<L>(camera.origin), towards.unit, L(0)};
    if (plan.features & kFeatureFar) {
        const Pixels<R> across = twice_across(plan, column_lanes<R>(tile, first), at);
        const Vec3<L> from_column = camera.origin + as<L>(product<F>(camera.origin_step_x, across));
        ray.o = from_column + as<L>(product<F>(camera.origin_step_y, upwards));
        ray.t_min = -as<L>(product<F>(towards.length, F(camera.pull)));
    }
    return ray;
}

/// The hash behind the lattice classes of a tile's pixels.
ZERKALO_INLINE std::uint32_t tile_hash(const PlanHead& plan, const Rect& tile) {
    const auto tiles_across = static_cast<std::uint32_t>(plan.width + kTileSide - 1) / kTileSide;
    return hash_bits(static_cast<std::uint32_t>(tile.top / kTileSide) * tiles_across +
                     static_cast<std::uint32_t>(tile.left / kTileSide));
}

}  // namespace zerkalo::inline ZERKALO_ISA
