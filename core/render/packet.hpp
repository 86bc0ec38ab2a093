// Which pixels a packet holds, the camera rays through them, and the per-pixel phase of the lobe lattice.
#pragma once

#include "core/geometry/algebra.hpp"
#include "core/optics/lattice.hpp"
#include "core/render/plan.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// 0, 1, ... as lanes and as bits.
struct LaneNumbers {
    float real[16];
    std::uint32_t bits[16];
};
constexpr LaneNumbers kLaneNumbers{{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
                                   {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}};

/// Column and row of the pixels of a tile, row-major: of any packet's lanes, from its first pixel's.
struct TilePlaces {
    float column[16], row[16];
};
constexpr TilePlaces kTilePlaces{{0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7},
                                 {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1}};
static_assert(kTileSide == 8);

/// Pixel coordinates of kWidth<R> neighbours of a tile, row-major from its pixel `first`, a multiple of the width.
template <class R>
struct PixelLanes {
    R x, y;
};

template <class R>
ZERKALO_INLINE R column_lanes(const Rect& tile, int first) {
    return load<R>(kTilePlaces.column + first % kTileSide) + R(float(tile.left));
}
template <class R>
ZERKALO_INLINE R row_lanes(const Rect& tile, int first) {
    const R row = R(float(tile.top + first / kTileSide));
    if constexpr (kWidth<R> <= kTileSide) return row;
    return row + load<R>(kTilePlaces.row);
}
template <class R>
ZERKALO_INLINE PixelLanes<R> pixel_lanes(const Rect& tile, int first) {
    return {column_lanes<R>(tile, first), row_lanes<R>(tile, first)};
}

/// Lanes whose pixel belongs to the tile, which the picture's edge may cut.
template <class R>
ZERKALO_INLINE Mask<R> lanes_inside(const Rect& tile, int first) {
    const PixelLanes<R> pixel = pixel_lanes<R>(tile, first);
    return (pixel.x < R(float(tile.left + tile.width))) & (pixel.y < R(float(tile.top + tile.height)));
}

/// A point of the pixel, from its centre, in pixels.
struct SubPixel {
    float x, y;
};

/// Camera sample a of n: a Fibonacci lattice over the pixel's square; one sample is the centre.
ZERKALO_INLINE SubPixel sub_pixel(std::int32_t a, std::int32_t n) {
    if (n == 1) return {0, 0};
    const auto phase = static_cast<std::uint32_t>(a) * kGoldenTurn;
    return {(float(a) + 0.5f) / float(n) - 0.5f, turn_of_phase<float>(phase)};
}

/// Twice the way from the picture's middle to a pixel's point, to the right and upwards.
template <class R>
ZERKALO_INLINE R twice_across(const Plan& plan, R x, SubPixel at) {
    return (x + x) + (R(2 * at.x) - R(float(plan.width - 1)));
}
template <class R>
ZERKALO_INLINE R twice_upwards(const Plan& plan, R y, SubPixel at) {
    return R(float(plan.height - 1)) - (y + y) - R(2 * at.y);
}

/// Seed formulas 2.5-2.10 with the pixel's centre; see CameraPlan. The part that a column of pixels shares, and the
/// whole, not normalised.
template <class R>
ZERKALO_INLINE Vec3<R> towards_column(const CameraPlan& camera, R across) {
    return camera.view + camera.step_x * across;
}
template <class R>
ZERKALO_INLINE Vec3<R> towards_pixel(const CameraPlan& camera, Vec3<R> column, R upwards) {
    return column + camera.step_y * upwards;
}

/// Directions to the columns of a tile, by packet.
template <class R>
struct TileColumns {
    static constexpr int kPackets = kWidth<R> < kTileSide ? kTileSide / kWidth<R> : 1;
    Vec3<R> towards[kPackets];
};

template <class R>
ZERKALO_INLINE void fill_columns(TileColumns<R>& columns, const Plan& plan, const Rect& tile, SubPixel at) {
    for (int c = 0; c < TileColumns<R>::kPackets; ++c) {
        const R x = column_lanes<R>(tile, c * kWidth<R>);
        columns.towards[c] = towards_column(plan.camera, twice_across(plan, x, at));
    }
}

template <class R>
struct CameraRay {
    Vec3<R> o, d;
    R t_min;
};

/// The ray through a pixel's point, also from far away.
template <class R>
ZERKALO_INLINE CameraRay<R> camera_ray(const Plan& plan, R x, R y, SubPixel at) {
    const CameraPlan& camera = plan.camera;
    const R across = twice_across(plan, x, at), upwards = twice_upwards(plan, y, at);
    const Vec3<R> towards = towards_pixel(camera, towards_column(camera, across), upwards);
    const R length = sqrt(dot(towards, towards));
    CameraRay<R> ray{spread<R>(camera.origin), towards * (R(1) / length), R(0)};
    if (plan.features & kFeatureFar) {
        ray.o = camera.origin + camera.origin_step_x * across + camera.origin_step_y * upwards;
        ray.t_min = -(length * R(camera.pull));
    }
    return ray;
}

/// The hash behind the lattice classes of a tile's pixels.
ZERKALO_INLINE std::uint32_t tile_hash(const Plan& plan, const Rect& tile) {
    const auto tiles_across = static_cast<std::uint32_t>(plan.width + kTileSide - 1) / kTileSide;
    return hash_bits(static_cast<std::uint32_t>(tile.top / kTileSide) * tiles_across +
                     static_cast<std::uint32_t>(tile.left / kTileSide));
}

}  // namespace zerkalo::inline ZERKALO_ISA
