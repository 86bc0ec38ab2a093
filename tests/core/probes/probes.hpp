// The core's lane functions over arrays, one table for each instruction set and width: the door by which tests,
// themselves compiled for the plainest CPU, reach code that exists only in units compiled for wider ones.
#pragma once

#include "core/optics/optics_data.hpp"
#include "core/shapes/mirror_data.hpp"
#include "core/shapes/shape_data.hpp"

#include <cstdint>

namespace zerkalo::probes {

/// Every array holds a multiple of this many elements, so that no width has a tail.
constexpr int kWidest = 16;

enum class Unary { negate, root, magnitude, round_trip, shift_left_5, shift_right_9, cap_at_one, raise_to_one };
enum class Binary {
    add,
    subtract,
    multiply,
    divide,
    least,
    greatest,
    choose,
    choose_or_one,
    one_or_choose,
    with_sign_of,
    bits_add,
    bits_subtract,
    bits_multiply,
    bits_and,
    bits_or,
    bits_xor,
};
enum class Elementary { exp2_minus_one, exp2, log2, log2_one_minus, sine, cosine };

/// What a packet says of its lanes; bit k of a mask is lane k.
struct PacketFacts {
    std::uint32_t less, greater, less_equal, greater_equal, equal, unequal;
    std::uint32_t both, either, neither, chosen;  // of less and a > 0
    std::uint32_t count_of_less;
    bool any_less, all_less, none_less;
    float first, largest;
};

struct Points {
    const float *x, *y, *z;
};
struct PointsOut {
    float *x, *y, *z;
};
struct Rays {
    Points o, d;
    int count;
};
struct SpansOut {
    float *entry, *exit, *face_in, *face_out;
};

enum class MirrorWay { plane, curved, own_chord };
struct MirrorHitsOut {
    float *hit, *t, *x, *y, *z;  // hit: 1 or 0
};
struct MeshHitsOut {
    float *hit, *back, *t, *face;
};

struct LaneProbes {
    void (*unary)(Unary op, const float* a, float* out, int count);
    void (*binary)(Binary op, const float* a, const float* b, float* out, int count);
    void (*facts)(const float* a, const float* b, PacketFacts* out, int count);  // one entry a packet
    void (*elementary)(Elementary op, const float* a, float* out, int count);
    void (*log2_with_lost)(const float* u, const float* lost, float* out, int count);
    void (*power)(const float* x, const float* n, float* out, int count);
};

struct ShapeProbes {
    void (*sphere)(const SphereData& sphere, const Rays& rays, const SpansOut& out);
    void (*tube)(const TubeData& tube, Faces faces, const Rays& rays, const SpansOut& out);
    void (*half_spaces)(const Slab* slabs, const HalfSpacesData& body, Faces faces, const Rays& rays,
                        const SpansOut& out);
    void (*mesh)(const TriangleData* triangles, int count, Faces sides, const Rays& rays, const MeshHitsOut& out);
    /// own_chord: the rays are given in the mirror's own frame.
    void (*mirror)(const MirrorShape& mirror, MirrorWay way, const Rays& rays, const MirrorHitsOut& out);
    void (*inside)(const BoundaryData& boundary, const float* x, const float* y, float* out, int count);
    void (*sphere_normal)(const SphereData& sphere, Points p, const PointsOut& out, int count);
    void (*tube_normal)(const TubeData& tube, Points p, const float* face, const PointsOut& out, int count);
    void (*mirror_normal)(const MirrorShape& mirror, Points p, const PointsOut& out, int count);
};

struct OpticsProbes {
    void (*reflect)(Points d, Points n, const PointsOut& out, int count);
    void (*mirror_direction)(Points l, Points n, const PointsOut& out, int count);
    void (*refract)(Points d, Points n, const float* eta, const PointsOut& out, float* total, int count);
    void (*fresnel)(Points d, Points n, const float* eta, float* across, float* within, float* both, int count);
    void (*tangents)(Points m, const PointsOut& t, const PointsOut& b, int count);
    void (*lobe)(const float* u, const float* turn, float inverse_exponent, const PointsOut& out, int count);
    void (*lattice)(std::int32_t points, float inverse_exponent, const PointsOut& out, int count);
    /// The first `count` points, or more, of a keyed rule's set of `points`.
    void (*set)(Estimator rule, std::int32_t points, std::uint32_t key, std::uint32_t half, float* u, float* turn,
                int count);
    /// `viewer`: x, y, z in the mirror's frame; so are the rays.
    void (*ggx)(const float* u, const float* turn, float alpha, const float* viewer, const PointsOut& out,
                float* weight, int count);
    void (*ggx_weight)(const float* cosine, float cosine_out, float alpha, float* out, int count);
    void (*weight)(const float* cosine, float inverse_cosine_out, float* out, int count);
    void (*light)(const LightData& light, const SurfaceData& surface, const Rays& seen_from, Points n,
                  const PointsOut& rgb);  // rays: o the surface point, d the unit way to the viewer
};

/// Coverage of lobes, places in the lobe's frame.
struct CoverageProbes {
    void (*polygon)(const LobeProfile& profile, const Points* corners, int corner_count, float* out, int count);
    void (*ball)(const LobeProfile& profile, const float* across, const float* along, const float* radius, float* out,
                 int count);
    /// The same ball by the conic arcs that its outline consists of, each cut into panels.
    void (*rim)(const LobeProfile& profile, const float* across, const float* along, const float* radius,
                std::int32_t panels, float* out, int count);
    void (*turn)(const float* y, const float* x, float* out, int count);
};

struct Probes {
    int width;
    LaneProbes lanes;
    ShapeProbes shapes;
    OpticsProbes optics;
    CoverageProbes coverage;
};

/// Of one translation unit: width 1 and the unit's own width (for `scalar` both are 1).
struct ProbePair {
    Probes serial, wide;
};

extern const ProbePair kProbes_scalar, kProbes_sse2, kProbes_sse4_2, kProbes_avx2, kProbes_avx512, kProbes_neon;

}  // namespace zerkalo::probes
