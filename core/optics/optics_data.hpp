// What the kernels read of lights, materials and lobes: plain uniform data, derived once by prepare().
#pragma once

#include "core/geometry/vec.hpp"

#include <cstdint>

namespace zerkalo {

/// No surface, no light and no share of it is brighter. Sums of 2^22 such terms, over lights, bounces and camera rays,
/// then stay within float: a picture holds no infinity, and no NaN where a tint of 0 meets one. Enough for brightness 1
/// from a light at the largest distance squared, 1e30.
constexpr float kBrightest = 0x1p100f;

struct LightData {
    Vec3<float> position;
    Rgb<float> power;       // color * intensity: E without the falloff
    float falloff_limit;    // 1/d^2 beyond which E would be brighter than any sum can hold
    float highlight_limit;  // n x beyond which (1-x)^n E cannot change a picture by 2^-24
    std::uint8_t inverse_square;
    std::uint8_t distant;  // so far away that shadow rays must start at the surface
};

/// The coefficients of seed formula 1.5 with everything constant multiplied out. A back of a mirror has no highlight.
struct SurfaceData {
    Rgb<float> ambient;   // C K_a I_a
    Rgb<float> diffuse;   // C K_d
    Rgb<float> specular;  // F K_s: F = 1 on solids, the tint on mirrors
    float shininess;      // n
    std::uint32_t unlit_by = 0;  // bit j: light j lies in or behind the plane of this side
};

/// What a solid's surface passes on: K_r, K_t and the two ratios of indices.
struct TransportData {
    float reflection, transmission;
    float eta_entering, eta_leaving;
    std::uint8_t fresnel;  // Fresnel's equations divide K_t
};

struct LobeData {
    float exponent;          // n
    float inverse_exponent;  // 1 / (n + 1)
    float cosine, sine;      // of the cone that holds all lobe rays, or all but 2^-11 of the lobe's energy
    float widest_sine;       // of the lattice ray farthest from the axis, rounded up
    std::uint8_t glossy;
    std::uint8_t max_phong;
};

constexpr int kChunk = 64;         // lattice points held at a time: one bit each in a mask
constexpr int kChunkPadding = 16;  // of the widest lane

/// A run of lattice points in lobe coordinates (optics/lattice.hpp).
struct LatticeChunk {
    float side[kChunk + kChunkPadding], up[kChunk + kChunkPadding], forward[kChunk + kChunkPadding];
    std::int32_t count;
};

}  // namespace zerkalo
