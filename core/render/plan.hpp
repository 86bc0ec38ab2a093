// What the kernels read: every constant of one frame, derived by prepare(). Trivially copyable, fixed capacity.
// F: the formats of its numbers. `Plan` is the one of the float kernels, `FixedPlan` that of the fixed-point kernel,
// `DoublePlan` that of the kernel in double.
#pragma once

#include "core/image/image_view.hpp"
#include "core/optics/optics_data.hpp"
#include "core/render/outline.hpp"
#include "core/render/settings.hpp"
#include "core/scene/scene.hpp"
#include "core/shapes/mirror_data.hpp"
#include "core/shapes/shape_data.hpp"

namespace zerkalo {

constexpr int kTileSide = 8;
constexpr int kTilePixels = kTileSide * kTileSide;
constexpr std::uint64_t kWholeTile = ~std::uint64_t{0};

/// Pixels to render of a tile: bit p is pixel p of the full tile side, row-major. Of a rectangle: all of it.
struct Tile : Rect {
    std::uint64_t pixels;

    constexpr Tile(const Rect& rect) : Tile(rect, kWholeTile) {}
    /// Those of `chosen` that the rectangle has.
    constexpr Tile(const Rect& rect, std::uint64_t chosen) : Rect(rect), pixels(chosen) {
        constexpr std::uint64_t kFirstColumn = 0x0101010101010101ull;
        if (width < kTileSide) pixels &= kFirstColumn * ((1u << width) - 1);
        if (height < kTileSide) pixels &= (std::uint64_t{1} << (kTileSide * height)) - 1;
    }
};
constexpr int kWidestLane = 16;
static_assert(kMaxMirrors <= kWidestLane);
constexpr int kMaxSlabs = kMaxSolids * (kMaxSides + 1);

/// What a frame uses. A kernel that lacks a feature contains no code for it.
enum Feature : std::uint32_t {
    kFeatureMirror = 1u << 0,  // a front that reflects
    kFeatureGlossy = 1u << 1,  // an unpolished one
    kFeatureChain = 1u << 2,   // more than one bounce: several or hollow mirrors, reflecting or transparent solids
    kFeatureBranch = 1u << 3,  // a surface that both reflects and refracts
    kFeatureCurved = 1u << 4,  // a spherical mirror
    kFeatureMesh = 1u << 5,
    kFeatureFar = 1u << 6,     // a camera or a light too far away for its position to be a float origin
    kFeatureInside = 1u << 7,  // the camera or a light is inside a solid, or nearly so
    kFeatureSphere = 1u << 8,
    kFeatureHalfSpaces = 1u << 9,
    kFeatureTube = 1u << 10,
    kFeatureFalloff = 1u << 11,
    kFeatureShadow = 1u << 12,  // lights and something to cast a shadow
    kFeatureMaxPhong = 1u << 13,
    kFeatureAntialias = 1u << 14,
    kFeatureFresnel = 1u << 15,  // a transparent solid that reflects by Fresnel's equations
    kFeatureFlush = 1u << 16,    // a solid's face lies in the plane of a mirror and looks to the camera's side
    kFeatureCoverage = 1u << 17,  // how much of a lobe the solids cover is integrated, not sampled
    kFeatureGgx = 1u << 18,       // a rough mirror of microfacets
};

/// What only the general kernel does.
constexpr std::uint32_t kNeedsGeneral = kFeatureChain | kFeatureBranch | kFeatureCurved | kFeatureMesh | kFeatureFar |
                                        kFeatureInside | kFeatureFlush | kFeatureGgx;

constexpr std::int32_t kScouts = 32;  // rays that look what a solid brings to a tile of mirror pixels

/// How the rays of one kind meet a solid: the closed list of kernels behind the six kinds of a scene.
enum class ShapeKind : std::uint8_t { sphere, half_spaces, tube, mesh };

/// What can stand between each light and one surface.
struct Blockers {
    std::uint64_t of_light[kMaxLights];
};

template <class F>
struct SolidPlanOf {
    ShapeKind shape;
    typename F::Index id;  // its index in the scene, as lanes hold it
    SphereDataOf<F> sphere;
    HalfSpacesDataOf<F> half_spaces;
    TubeDataOf<F> tube;
    MeshData mesh;
    Vec3<typename F::Length> bound_centre;
    typename F::Length bound_radius;  // contains the solid, with room for rounding
    SurfaceDataOf<F> surface;
    TransportDataOf<F> transport;
    Blockers blockers;
};
using SolidPlan = SolidPlanOf<FloatFormats>;

/// What only the kernels for at most one bounce read of a mirror, a light, a plan.
template <class F>
struct OneBounceMirror {};
template <>
struct OneBounceMirror<FloatFormats> {
    LatticeChunk lattice;  // the lobe's first points; all of them if `samples` are at most kChunk
    LobeProfile profile;   // for its coverage
    LatticeChunk scouts;   // even points of the unit disc: what a solid brings, and which ones hide it
};
template <>
struct OneBounceMirror<FixedFormats> {
    ClassRays rays;  // the lobe's first ones, of the first camera sample, unless a tile has its own
};
template <class F>
struct OneBounceLight {};
template <class F>
struct OneBouncePlan {};

template <class F>
struct MirrorPlanOf : OneBounceMirror<F> {
    MirrorShapeOf<F> shape;
    SurfaceDataOf<F> front, back;
    Blockers blockers;
    Rgb<typename F::Weight> reflectance;  // F K_r
    LobeDataOf<F> lobe;
    double lobe_exponent;
    std::uint32_t flush;                           // bit k: a face of solid k lies in the mirror's plane
    typename F::Index flush_face[kMaxSolids];      // which one
    std::uint8_t curved;
    std::uint8_t reflects;
};
using MirrorPlan = MirrorPlanOf<FloatFormats>;

/// Camera ray of pixel (i, j): direction view + step_x (2 i + 1 - W) + step_y (H - 2 j - 1), before normalising.
/// A far camera's rays start on the plane through the scene's centre: origin + origin_step * (...), t > -pull
/// |direction|.
template <class F>
struct CameraPlanOf {
    Vec3<typename F::Length> origin;
    Vec3<typename F::View> view, step_x, step_y;
    Vec3<typename F::FarStep> origin_step_x, origin_step_y;
    typename F::FarStep pull;
    std::int32_t stands_on;                 // a surface nearer than floats can tell: solid, kMaxSolids + mirror, or -1
    Vec3<typename F::Direction> out_of_it;  // the outward normal of that solid there; otherwise 0
};
using CameraPlan = CameraPlanOf<FloatFormats>;

constexpr int kTileCorners = 4;

/// From the middle of a tile's camera rays, not normalised, to those of its corners: again and again for wider lanes.
struct TileCorners {
    float x[kWidestLane], y[kWidestLane], z[kWidestLane];
    float fall[kWidestLane];  // against the first mirror's normal
    float reach;              // length of the longest
};

template <class F>
struct SharedSlabOf {
    typename F::Length lo, hi;
};
template <class F>
struct SharedSolidOf {
    Vec3<typename F::Length> from;
    typename F::Area c;
};

/// One origin of many rays, the camera or a light, and what all of them have in common (shapes/*.hpp: ..._seen_from).
template <class F>
struct SharedOriginOf {
    SharedSolidOf<F> solids[kMaxSolids];
    SharedSlabOf<F> slabs[kMaxSlabs];
    Vec3<typename F::Length> mirrors[kMaxMirrors];
};
using SharedOrigin = SharedOriginOf<FloatFormats>;

/// A solid's bounding sphere as a light sees it: its centre from there, and |centre|^2 - radius^2 with room for
/// rounding.
struct SharedBound {
    Vec3<float> centre;
    float beyond;
};

template <>
struct OneBounceLight<FloatFormats> {
    SharedBound bounds[kMaxSolids];
};
template <class F>
struct LightPlanOf : OneBounceLight<F> {
    LightDataOf<F> data;
    SharedOriginOf<F> origin;
};
using LightPlan = LightPlanOf<FloatFormats>;

/// Pixels that a projection can touch: left <= x < right, top <= y < bottom.
struct PixelBounds {
    std::int32_t left, top, right, bottom;
};

/// The same for several objects, one a lane. T: float or double, which hold them exactly, or integers.
template <int count, class T = float>
struct PixelBoundsTable {
    static_assert(count % kWidestLane == 0);
    T left[count], top[count], right[count], bottom[count];

    constexpr void set(std::int32_t k, const PixelBounds& bounds) {
        left[k] = T(bounds.left), top[k] = T(bounds.top);
        right[k] = T(bounds.right), bottom[k] = T(bounds.bottom);
    }
};

/// The bounding spheres of SolidPlan, one a lane.
struct BoundTable {
    float x[kMaxSolids], y[kMaxSolids], z[kMaxSolids], radius[kMaxSolids];
};

template <>
struct OneBouncePlan<FloatFormats> {
    Outline outlines[kMaxSolids];
    TileCorners tile_corners;
    BoundTable bounds;
    PixelBoundsTable<kMaxSolids> image_bounds;  // of the solids' images behind the only, plane mirror
};

/// What a plan tells whoever runs its tiles.
struct PlanHead {
    Vec3<double> origin;  // of all places in the plan: 0, but for a scene that lies far from there
    std::int32_t width, height;
    std::int32_t samples, antialias, edge_antialias, depth_limit;
    Sampling sampling;
    float part_scale[kSpreadParts];  // makes every fourth lobe ray's sum count for a fourth of the whole
    std::uint32_t features;
    std::uint8_t exact_plan;
    std::int32_t solid_count, mirror_count, light_count;
    std::int32_t exposure;  // stored radiance times 2^exposure is the picture's; 0 in float
};

template <class F>
struct PlanOf : PlanHead, OneBouncePlan<F> {
    Rgb<typename F::Radiance> background;
    CameraPlanOf<F> camera;
    SharedOriginOf<F> camera_origin;
    SolidPlanOf<F> solids[kMaxSolids];
    MirrorPlanOf<F> mirrors[kMaxMirrors];
    LightPlanOf<F> lights[kMaxLights];
    SlabOf<F> slabs[kMaxSlabs];
    TriangleDataOf<F> triangles[kMaxTriangles];

    // Culling. Bit k of a mask is solid k, bit kMaxSolids + k is mirror k.
    PixelBoundsTable<kMaxSolids, typename F::PixelBound> solid_bounds;
    PixelBoundsTable<kWidestLane, typename F::PixelBound> mirror_bounds;
    PixelBoundsTable<kMaxSolids, typename F::PixelBound> shadow_bounds[kMaxLights];  // on the only, plane mirror
};
using Plan = PlanOf<FloatFormats>;
using FixedPlan = PlanOf<FixedFormats>;
using DoublePlan = PlanOf<DoubleFormats>;

}  // namespace zerkalo
