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

/// Pixel coordinates of kWidth<R> neighbours of a tile, row-major from its pixel `first`.
template <class R>
struct PixelLanes {
    R x, y;
};

template <class R>
ZERKALO_INLINE PixelLanes<R> pixel_lanes(const Rect& tile, int first) {
    const R index = load<R>(kLaneNumbers.real) + R(float(first));
    // Exact: small integers. floor(index / 8) through the rounding of a half-step lower value.
    const R row = (index * R(0.125f) - R(0.4375f)) + R(12582912.0f) - R(12582912.0f);
    return {index - row * R(float(kTileSide)) + R(float(tile.left)), row + R(float(tile.top))};
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

template <class R>
struct CameraRay {
    Vec3<R> o, d;
    R t_min;
};

/// Seed formulas 2.5-2.10 with the pixel's centre; see CameraPlan.
template <class R>
ZERKALO_INLINE CameraRay<R> camera_ray(const Plan& plan, R x, R y, SubPixel at) {
    const CameraPlan& camera = plan.camera;
    const R across = (x + x) + (R(2 * at.x) - R(float(plan.width - 1)));
    const R upwards = R(float(plan.height - 1)) - (y + y) - R(2 * at.y);
    const Vec3<R> towards = camera.view + camera.step_x * across + camera.step_y * upwards;
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
