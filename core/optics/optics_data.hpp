// What the kernels read of lights, materials and lobes: plain uniform data, derived once by prepare().
// F: the formats of its numbers.
#pragma once

#include "core/geometry/vec.hpp"
#include "core/numeric/formats.hpp"
#include "core/optics/estimator.hpp"

#include <cstdint>

namespace zerkalo {

/// No surface, no light and no share of it is brighter. Sums of 2^22 such terms, over lights, bounces and camera rays,
/// then stay within float: a picture holds no infinity, and no NaN where a tint of 0 meets one. Enough for brightness 1
/// from a light at the largest distance squared, 1e30.
constexpr float kBrightest = 0x1p100f;

template <class F>
struct LightDataOf {
    Vec3<typename F::Length> position;
    Rgb<typename F::Radiance> power;       // color * intensity: E without the falloff
    typename F::Inverse falloff_limit;     // 1/d^2 beyond which E would be brighter than any sum can hold
    typename F::Exponent highlight_limit;  // n x beyond which (1-x)^n E is below F::kLeastShare
    std::uint8_t inverse_square;
    std::uint8_t distant;  // so far away that shadow rays must start at the surface
};
using LightData = LightDataOf<FloatFormats>;

/// The coefficients of seed formula 1.5 with everything constant multiplied out. A back of a mirror has no highlight.
template <class F>
struct SurfaceDataOf {
    Rgb<typename F::Radiance> ambient;  // C K_a I_a
    Rgb<typename F::Weight> diffuse;    // C K_d
    Rgb<typename F::Weight> specular;   // F K_s: F = 1 on solids, the tint on mirrors
    typename F::Exponent shininess;     // n
    std::uint32_t unlit_by = 0;         // bit j: light j lies in or behind the plane of this side
};
using SurfaceData = SurfaceDataOf<FloatFormats>;

/// What a solid's surface passes on: K_r, K_t and the two ratios of indices.
template <class F>
struct TransportDataOf {
    typename F::Weight reflection, transmission;
    typename F::Ratio eta_entering, eta_leaving;
    std::uint8_t fresnel;  // Fresnel's equations divide K_t
};
using TransportData = TransportDataOf<FloatFormats>;

/// Of fixed point alone: the cone that holds all lobe rays, as slopes; `narrow` where they fit their format.
template <class F>
struct LobeConeOf {};
template <>
struct LobeConeOf<FixedFormats> {
    FixedFormats::Ratio tangent, secant;
    std::uint8_t narrow;
};

template <class F>
struct LobeDataOf {
    typename F::Share inverse_exponent;  // 1 / (n + 1)
    typename F::Direction alpha;         // of a ggx lobe
    typename F::Weight cosine, sine;     // of the cone that holds all lobe rays, or all but 2^-11 of the lobe's energy
    typename F::Weight widest_sine;      // of the lattice ray farthest from the axis, rounded up
    std::uint8_t glossy;
    std::uint8_t max_phong;
    std::uint8_t ggx;
    [[no_unique_address]] LobeConeOf<F> cone;
};
using LobeData = LobeDataOf<FloatFormats>;

constexpr int kProfileTerms = 10;

/// Of a lobe cos^n, for its coverage (optics/coverage.hpp): the polynomial that stands for the power, and the cone
/// beyond which the power counts as 0.
struct LobeProfile {
    float powers[kProfileTerms];  // of y = to_unit v - 1, v = sin^2 of the angle to the axis: (1 - cos^(n+1)) / v
    float to_unit;
    float edge;       // sin^2 of the cone's half-angle
    float tangent2;   // tan^2 of it
    float from_axis;  // 1 - its cosine
};

constexpr int kChunk = 64;         // lattice points held at a time: one bit each in a mask
constexpr int kChunkPadding = 16;  // of the widest lane

constexpr int kLatticeClasses = 4;

/// A run of lattice points in lobe coordinates (optics/lattice.hpp). The first `rim` of them count for less than the
/// others (optics/shares.hpp): for `weight` of one of these.
struct LatticeChunk {
    float side[kChunk + kChunkPadding], up[kChunk + kChunkPadding], forward[kChunk + kChunkPadding];
    float weight[kChunk];
    std::int32_t count, rim;
};

constexpr std::int32_t kRayChunk = 32;
using RayMask = std::uint32_t;  // bit i: ray i of a chunk

/// The same in fixed point, as raw integers of directions.
struct RayChunk {
    std::int32_t side[kRayChunk], up[kRayChunk], forward[kRayChunk];
};
/// Of each class of pixels.
struct ClassRays {
    std::int32_t count;
    RayChunk of_class[kLatticeClasses];
};

}  // namespace zerkalo
