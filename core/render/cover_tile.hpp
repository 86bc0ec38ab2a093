// What the pixels of a tile share about the coverage of their lobes: which solids are covered, and for each face what a
// hit brings beyond the background, c_f - b, from one place. Any value is right (gloss.hpp): the closer to what the
// lobe rays will see, the less error they leave.
#pragma once

#include "core/render/lobe_aim.hpp"
#include "core/render/lobe_tile.hpp"

namespace zerkalo::inline ZERKALO_ISA {

constexpr int kMaxCovered = 8;    // solids a tile
constexpr int kMostPanels = 32;   // of a quarter of a tube's rim

struct CoveredSolid {
    std::int32_t k;
    std::int32_t panels;      // into which each quarter of a tube's rims is cut
    bool few_nodes;           // four nodes serve each panel
    std::int32_t face_count;  // a hit names one of these
    float room;               // distance from the tile's mirror points, at least; not positive if one may be inside
    float r[kMaxOutlineFaces], g[kMaxOutlineFaces], b[kMaxOutlineFaces];  // by the face that a hit names
};

struct TileCover {
    static constexpr bool kCovers = true;
    CoveredSolid solids[kMaxCovered];
    std::int32_t count;
    bool smooth;          // their light, so that it can be interpolated from a few places of the tile (render/cover_grid.hpp)
    CandidateMask plain;  // solids that some lobe may meet and that are left to the lobe rays alone
};

/// Solids whose outline can be integrated. A tube's rim is cut into pieces not longer than the lobe is wide.
ZERKALO_INLINE bool can_be_covered(const Plan& plan, const TileLobe& lobe, int k, CoveredSolid& cover) {
    const SolidPlan& solid = plan.solids[k];
    cover.panels = 1;
    const Vec3<float> f = solid.bound_centre - lobe.p;
    const float room = sqrt(dot(f, f)) - solid.bound_radius - lobe.stray;
    cover.room = room;
    if (solid.shape == ShapeKind::half_spaces) return plan.outlines[k].edge_count > 0;
    if (!(room > 0)) return false;
    if (solid.shape == ShapeKind::sphere) return true;
    // A quarter of a rim's arc is at most pi / 4 of its radius long on either side; eight nodes serve twice the cone.
    const float needed = 0.8f * solid.bound_radius / (room * sqrt(plan.mirrors[0].profile.tangent2));
    if (!(needed <= float(kMostPanels))) return false;
    while (float(cover.panels) < needed) ++cover.panels;
    cover.few_nodes = needed <= 0.5f;
    return true;
}

/// Solids that other ones hide from more of the scouts, rays through the lobe from the middle of the tile, than not.
template <class R>
ZERKALO_INLINE CandidateMask hidden_solids(const Plan& plan, const TileLobe& lobe, CandidateMask solids) {
    if ((solids & (solids - 1)) == 0) return 0;
    const LatticeChunk& scouts = plan.mirrors[0].scouts;
    const Tangents<float> across = tangents_of(lobe.m);
    const Vec3<R> p = spread<R>(lobe.p);
    std::int32_t balance[kMaxSolids] = {};
    for (std::int32_t s = 0; s < kScouts; s += kWidth<R>) {
        const Vec3<R> d = lobe.m * load<R>(scouts.forward + s) + across.t * load<R>(scouts.side + s) +
                          across.b * load<R>(scouts.up + s);
        const Nearest<R> near = nearest_solid(plan, solids, PointOrigin<R>{p}, d);
        for (CandidateMask left = solids; left != 0; left &= left - 1) {
            const int k = first_of(left);
            with_span<Faces::none, R>(plan, k, PointOrigin<R>{p}, d,
                                      [&](const Span<FloatNumbers<R>>& span) ZERKALO_INLINE_LAMBDA {
                const auto met = (span.entry <= span.exit) & (span.entry > R(0));
                const auto first = near.id == R(plan.solids[k].id);
                balance[k] += static_cast<std::int32_t>(count_of(met & first)) -
                              static_cast<std::int32_t>(count_of(met & !first));
            });
        }
    }
    CandidateMask hidden = 0;
    for (CandidateMask left = solids; left != 0; left &= left - 1) {
        if (balance[first_of(left)] < 0) hidden |= CandidateMask{1} << first_of(left);
    }
    return hidden;
}

/// Where the tile's middle looks: its mirror point and mirror direction.
struct Glance {
    Vec3<float> p, m;
};

ZERKALO_INLINE void set_shade(CoveredSolid& cover, const Plan& plan, const Glance& from, Vec3<float> at, int face,
                              TileCounts& counts) {
    const Vec3<float> way = at - from.p;
    const Vec3<float> d = way * (1 / sqrt(dot(way, way)));
    const Rgb<float> light =
        light_of_solid<float>(plan, plan.solids[cover.k], at, float(face), d, true, counts) - plan.background;
    cover.r[face] = light.r, cover.g[face] = light.g, cover.b[face] = light.b;
}

constexpr float kWithin = 0.95f;  // of a solid's half-width: places for shades keep off its silhouette

/// The place of a ball nearest to where the axis goes.
ZERKALO_INLINE void shade_ball(CoveredSolid& cover, const Plan& plan, const Glance& from, TileCounts& counts) {
    const SphereData& ball = plan.solids[cover.k].sphere;
    const Vec3<float> f = from.p - ball.centre;
    const Vec3<float> off = f - from.m * dot(f, from.m);
    const float radius = ball.radius2 * ball.inverse_radius;
    const float length = sqrt(dot(off, off)), most = kWithin * radius;
    const float scale = length > most ? most / length : 1.0f;
    const Vec3<float> aside = off * scale;
    const Vec3<float> at = ball.centre + aside - from.m * sqrt(max(ball.radius2 - dot(aside, aside), 0.0f));
    set_shade(cover, plan, from, at, 0, counts);
}

/// Every face that looks to the tile: where the axis meets its plane, drawn towards its middle until it is inside.
ZERKALO_INLINE void shade_polyhedron(CoveredSolid& cover, const Plan& plan, const Glance& from, TileCounts& counts) {
    const HalfSpacesData& body = plan.solids[cover.k].half_spaces;
    const Outline& outline = plan.outlines[cover.k];
    const Slab* slabs = plan.slabs + body.first_slab;
    for (int f = 0; f < outline.face_count; ++f) {
        const OutlineFace& face = outline.faces[f];
        const Slab& own = slabs[face.slab];
        const auto seen_from = slab_seen_from<FloatNumbers<float>>(own, from.p - body.centre);
        if (face.low ? !(seen_from.lo > 0) : !(seen_from.hi < 0)) continue;
        const Vec3<float> middle = outline.middle[f];
        const float t = (face.low ? seen_from.lo : seen_from.hi) / dot(own.n, from.m);
        Vec3<float> way = from.p + from.m * t - middle;
        float share = t > 0 && t < 0x1p60f ? 1.0f : 0.0f;
        for (std::int32_t s = 0; s < body.slab_count; ++s) {
            if (s == face.slab) continue;
            const float along = dot(slabs[s].n, way), at = dot(slabs[s].n, middle - body.centre);
            const float room = along > 0 ? slabs[s].hi - at : at - slabs[s].lo;
            if (share * max(along, -along) > kWithin * room) share = kWithin * room / max(along, -along);
        }
        set_shade(cover, plan, from, share > 0 ? middle + way * share : middle, face.slab, counts);
    }
}

/// The side where the axis passes it, at most to its silhouette, and the cap that looks to the tile.
ZERKALO_INLINE void shade_tube(CoveredSolid& cover, const Plan& plan, const Glance& from, TileCounts& counts) {
    const TubeData& tube = plan.solids[cover.k].tube;
    const Vec3<float> o = tube_seen_from<FloatNumbers<float>>(tube, from.p);
    const Vec3<float> d = in_tube_axes(tube, from.m);
    const Vec3<float> foot = o - d * dot(o, d);
    const auto in_world = [&](Vec3<float> q) ZERKALO_INLINE_LAMBDA {
        return tube.centre + tube.axis_x * q.x + tube.axis_y * q.y + tube.axis_z * q.z;
    };
    const float across = sqrt(o.x * o.x + o.z * o.z);
    if (across > tube.mid_radius + tube.slope * o.y) {
        const float most_high = kWithin * tube.half_height;
        const float y = max(min(foot.y, most_high), -most_high);
        const float radius = tube.mid_radius + tube.slope * y, most = kWithin * radius;
        const float scale = across > 0 ? 1 / across : 0.0f;
        const float to_x = o.x * scale, to_z = o.z * scale;
        const float side = max(min(foot.z * to_x - foot.x * to_z, most), -most);
        const float near = sqrt(max(radius * radius - side * side, 0.0f));
        const Vec3<float> at{to_x * near - to_z * side, y, to_z * near + to_x * side};
        set_shade(cover, plan, from, in_world(at), kLateralFace, counts);
    }
    const float top = o.y > 0 ? tube.half_height : -tube.half_height;
    if (o.y * top <= tube.half_height * tube.half_height) return;
    // Where the axis meets the cap's plane, if it does, at most at the rim.
    const float t = (top - o.y) / d.y;
    const float most = kWithin * (tube.mid_radius + tube.slope * top);
    const float x = o.x + d.x * t, z = o.z + d.z * t;
    const float length = sqrt(x * x + z * z);
    const float scale = t > 0 && length > 0 && length < 0x1p60f ? min(most / length, 1.0f) : 0.0f;
    const Vec3<float> at = scale > 0 ? Vec3<float>{x * scale, top, z * scale} : Vec3<float>{0, top, 0};
    set_shade(cover, plan, from, in_world(at), kCapFace, counts);
}

/// Does the light of covered solids change so little over the tile that a polynomial of third degree in each direction
/// is good to 10^-4? By how much of the lobe's width the lobes move against the nearest solid.
ZERKALO_INLINE bool is_smooth(const TileCover& cover, const TileLobe& lobe, const LobeProfile& profile) {
    // The cone is sqrt(2 ln 2^12) = 4.08 standard deviations wide; the error is 0.046 (span / 4)^4 of a step.
    constexpr float kWidestSpan = 0.9f, kDeviations = 4.08f;
    float room = cover.solids[0].room;
    for (std::int32_t i = 1; i < cover.count; ++i) room = min(room, cover.solids[i].room);
    const float span = 1.42f * (lobe.turn + lobe.stray / room) * kDeviations;
    return room > 0 && span * span <= kWidestSpan * kWidestSpan * profile.tangent2;
}

/// Chooses the covered solids of a tile and computes their shades. Nothing here depends on the lobe rays.
template <class R>
ZERKALO_ONCE void cover_tile(TileCover& cover, const Plan& plan, const Rect& tile, TileCounts& counts) {
    cover.count = 0;
    cover.smooth = false;
    const TileLobe lobe = lobe_of_tile<R>(plan, tile);
    if (!lobe.bounded) {
        cover.plain = first_bits(plan.solid_count);
        return;
    }
    const CandidateMask solids = solids_in_reach<R>(plan, lobe);
    cover.plain = hidden_solids<R>(plan, lobe, solids);
    for (CandidateMask left = solids & ~cover.plain; left != 0; left &= left - 1) {
        const int k = first_of(left);
        const ShapeKind shape = plan.solids[k].shape;
        CoveredSolid& next = cover.solids[cover.count];
        if (cover.count == kMaxCovered || !can_be_covered(plan, lobe, k, next)) {
            cover.plain |= CandidateMask{1} << k;
            continue;
        }
        ++cover.count;
        next.k = k;
        next.face_count = shape == ShapeKind::half_spaces ? plan.solids[k].half_spaces.slab_count : 2;
        for (int f = 0; f < kMaxOutlineFaces; ++f) next.r[f] = next.g[f] = next.b[f] = 0;
        const Glance from{lobe.p, lobe.m};
        if (shape == ShapeKind::sphere) shade_ball(next, plan, from, counts);
        if (shape == ShapeKind::half_spaces) shade_polyhedron(next, plan, from, counts);
        if (shape == ShapeKind::tube) shade_tube(next, plan, from, counts);
    }
    cover.smooth = cover.count > 0 && is_smooth(cover, lobe, plan.mirrors[0].profile);
}

}  // namespace zerkalo::inline ZERKALO_ISA
