// What the pixels of a tile share about the coverage of their lobes: which solids are covered, and for each face what a
// hit brings beyond the background, c_f - b. Any value is right (gloss.hpp): the closer to what the lobe rays will see,
// the less error they leave. Flat faces are shaded at one place, round ones on average over scouts
// (render/cover_scouts.hpp).
#pragma once

#include "core/optics/overlap.hpp"
#include "core/render/cover_scouts.hpp"
#include "core/render/lobe_aim.hpp"

namespace zerkalo::inline ZERKALO_ISA {

constexpr int kMaxCovered = 8;    // solids a tile
constexpr int kMaxHiders = 8;     // solids a tile that are taken off the outlines of others
constexpr int kMostPanels = 32;   // of a quarter of a tube's rim

struct CoveredSolid {
    std::int32_t k;
    std::int32_t panels;      // into which each quarter of a tube's rims is cut
    bool few_nodes;           // four nodes serve each panel
    std::int32_t face_count;  // a hit names one of these
    float room;               // room_before() it
    CandidateMask hidden_by;  // solids that are taken off its outline: render/cover_hidden.hpp
    float r[kMaxOutlineFaces], g[kMaxOutlineFaces], b[kMaxOutlineFaces];  // by the face that a hit names
};

struct TileCover {
    static constexpr bool kCovers = true;
    CoveredSolid solids[kMaxCovered];
    std::int32_t count;
    CandidateMask hiders;  // all that are taken off the outlines of others
    CandidateMask noted;   // these and all that are covered
    bool smooth;           // their light, so that it can be interpolated (render/cover_grid.hpp)
    CandidateMask plain;   // solids that some lobe may meet and that are left to the lobe rays alone
    std::uint8_t panel[kMaxSolids];  // see panel_of(); only of those that hide or are hidden
};

/// From the tile's mirror points to the solid's bounding ball, at least; not positive if one may be inside.
ZERKALO_INLINE float room_before(const SolidPlan& solid, const TileLobe& lobe) {
    const Vec3<float> f = solid.bound_centre - lobe.p;
    return sqrt(dot(f, f)) - solid.bound_radius - lobe.stray;
}

/// Of the rim at that height: 0 at the point of a cone, whatever rounding has left there.
ZERKALO_INLINE float rim_radius(const TubeData& tube, float height) {
    const float widest = tube.mid_radius + max(tube.slope, -tube.slope) * tube.half_height;
    const float own = tube.mid_radius + tube.slope * height;
    return own > 0x1p-18f * widest ? own : 0.0f;
}

constexpr float kConeDeviations = 4.08f;  // of the lobe in the profile's cone: sqrt(2 ln 2^12)

/// The fewest sides of a quarter of an arc of a tube's rim that the lobes cannot tell from it; 0: more than are kept.
ZERKALO_INLINE int panel_of_rims(const TubeData& tube, const TileLobe& lobe, const LobeProfile& profile) {
    constexpr float kTurn = 6.2831853f;
    const Vec3<float> o = tube_seen_from<FloatNumbers<float>>(tube, lobe.p);
    const float across = sqrt(o.x * o.x + o.z * o.z), level = tube.mid_radius + tube.slope * o.y;
    const float cosine = across > 0 ? max(min(level / across, 1.0f), -1.0f) : 1.0f;
    const float half = turn_of(sqrt((1 - cosine) * (1 + cosine)), cosine) * kTurn;
    // Of a circle of r deviations, in steps of an angle d, the polygon's coverage is off by 6e-5 d^4 r^3 (measured).
    const float deviations = kConeDeviations / sqrt(profile.tangent2);
    float worst = 0;
    for (int top = 0; top < 2; ++top) {
        const float height = top ? tube.half_height : -tube.half_height, radius = rim_radius(tube, height);
        const float off = max(across - radius, 0.0f), outwards = top ? o.y - height : height - o.y;
        const float room = sqrt(off * off + outwards * outwards) - lobe.stray;
        if (!(room > 0)) return 0;
        float arc = 0;  // the near one, or where the cap is seen the far one; either, where both are
        if (outwards < lobe.stray) arc = 2 * half;
        if (outwards > -lobe.stray) arc = max(arc, kTurn - 2 * half);
        const float r = radius / room * deviations;
        worst = max(worst, arc * arc * arc * arc * r * r * r);
    }
    for (int panel = 2; panel <= kMostPanelSides; ++panel) {
        const auto count = float(kArcPanels * panel + 2);
        if (worst <= count * count * count * count) return panel;
    }
    return 0;
}

/// The same of any solid, 1 where it has no rims; 0 if its outline has no such polygon.
ZERKALO_INLINE int panel_of(const Plan& plan, const TileLobe& lobe, int k) {
    const SolidPlan& solid = plan.solids[k];
    if (solid.shape == ShapeKind::tube) return panel_of_rims(solid.tube, lobe, plan.mirrors[0].profile);
    if (solid.shape == ShapeKind::half_spaces) return plan.outlines[k].edge_count > 0 ? 1 : 0;
    return solid.shape == ShapeKind::sphere && room_before(solid, lobe) > 0 ? 1 : 0;
}

/// Notes which of the rivals are taken off the outline of solid k.
ZERKALO_INLINE CandidateMask chosen_hiders(TileCover& cover, const Plan& plan, const TileLobe& lobe, int k,
                                           const ScoutNotes& notes, CandidateMask rivals) {
    CandidateMask can = 0;
    for (CandidateMask left = rivals; left != 0; left &= left - 1) {
        const int other = first_of(left);
        if (notes.before[other] == 0) continue;
        cover.panel[other] = static_cast<std::uint8_t>(panel_of(plan, lobe, other));
        if (cover.panel[other] != 0) can |= left & (~left + 1);
    }
    if (can == 0) return 0;
    cover.panel[k] = static_cast<std::uint8_t>(panel_of(plan, lobe, k));
    if (cover.panel[k] == 0) return 0;
    const CandidateMask hiders = hiders_of(notes, can);
    int count = 0;  // a processor may have no instruction for it
    for (CandidateMask left = cover.hiders | hiders; left != 0; left &= left - 1) ++count;
    return count <= kMaxHiders ? hiders : 0;
}

/// Solids whose outline can be integrated. A tube's rim is cut into pieces not longer than the lobe is wide.
ZERKALO_INLINE bool can_be_covered(const Plan& plan, const TileLobe& lobe, int k, CoveredSolid& cover) {
    const SolidPlan& solid = plan.solids[k];
    cover.k = k;
    cover.panels = 1;
    cover.hidden_by = 0;
    const float room = cover.room = room_before(solid, lobe);
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

/// Where the tile's middle looks: its mirror point and mirror direction; how far from there the others' points lie.
struct Glance {
    Vec3<float> p, m;
    float stray;
};

ZERKALO_INLINE void set_shade(CoveredSolid& cover, const Plan& plan, const Glance& from, Vec3<float> at, int face,
                              TileCounts& counts) {
    const Vec3<float> way = at - from.p;
    const Vec3<float> d = way * (1 / sqrt(dot(way, way)));
    const Rgb<float> light =
        light_of_solid<float>(plan, plan.solids[cover.k], at, float(face), d, true, counts) - plan.background;
    cover.r[face] = light.r, cover.g[face] = light.g, cover.b[face] = light.b;
}

constexpr float kWithin = 0.95f;  // of a face's half-width: places for shades keep off its edges

/// The same from a point that a plane looks to, of which the tile's middle lies `behind` (if that is positive).
ZERKALO_INLINE Glance before_plane(const Glance& from, Vec3<float> outwards, float behind) {
    return behind < 0 ? from : Glance{from.p + outwards * (behind + from.stray), from.m, from.stray};
}

/// Every face that looks to some pixel of the tile: where the axis meets its plane, drawn towards its middle until it
/// is inside.
ZERKALO_INLINE void shade_polyhedron(CoveredSolid& cover, const Plan& plan, const Glance& from, TileCounts& counts) {
    const HalfSpacesData& body = plan.solids[cover.k].half_spaces;
    const Outline& outline = plan.outlines[cover.k];
    const Slab* slabs = plan.slabs + body.first_slab;
    for (int f = 0; f < outline.face_count; ++f) {
        const OutlineFace& face = outline.faces[f];
        const Slab& own = slabs[face.slab];
        const auto seen_from = slab_seen_from<FloatNumbers<float>>(own, from.p - body.centre);
        const float behind = face.low ? -seen_from.lo : seen_from.hi;
        if (!(behind < from.stray)) continue;
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
        set_shade(cover, plan, before_plane(from, face.low ? -own.n : own.n, behind),
                  share > 0 ? middle + way * share : middle, face.slab, counts);
    }
}

/// The cap of a tube that looks to some pixel of the tile: where the axis meets its plane, if it does, at most at the
/// rim.
ZERKALO_INLINE void shade_cap(CoveredSolid& cover, const Plan& plan, const Glance& from, TileCounts& counts) {
    const TubeData& tube = plan.solids[cover.k].tube;
    const Vec3<float> o = tube_seen_from<FloatNumbers<float>>(tube, from.p);
    const Vec3<float> d = in_tube_axes(tube, from.m);
    const float top = o.y > 0 ? tube.half_height : -tube.half_height;
    const float behind = tube.half_height - max(o.y, -o.y);
    if (!(behind < from.stray)) return;
    const float t = (top - o.y) / d.y;
    const float most = kWithin * (tube.mid_radius + tube.slope * top);
    const float x = o.x + d.x * t, z = o.z + d.z * t;
    const float length = sqrt(x * x + z * z);
    const float scale = t > 0 && length > 0 && length < 0x1p60f ? min(most / length, 1.0f) : 0.0f;
    const Vec3<float> q = scale > 0 ? Vec3<float>{x * scale, top, z * scale} : Vec3<float>{0, top, 0};
    set_shade(cover, plan, before_plane(from, o.y > 0 ? tube.axis_y : -tube.axis_y, behind),
              tube.centre + tube.axis_x * q.x + tube.axis_y * q.y + tube.axis_z * q.z, kCapFace, counts);
}

/// The shades of a solid of which the scouts see so much: of flat faces at one place, of a round one on average. What
/// is hidden brings nothing, and takes its share off every shade: the least error that one shade a face can leave.
ZERKALO_INLINE void shade_solid(CoveredSolid& cover, const Plan& plan, const Glance& from, const Report& report,
                                TileCounts& counts) {
    for (int f = 0; f < kMaxOutlineFaces; ++f) cover.r[f] = cover.g[f] = cover.b[f] = 0;
    const ShapeKind shape = plan.solids[cover.k].shape;
    if (shape == ShapeKind::half_spaces) shade_polyhedron(cover, plan, from, counts);
    if (shape == ShapeKind::tube) shade_cap(cover, plan, from, counts);
    const float visible = report.seen < report.met ? report.seen / report.met : 1.0f;
    if (visible < 1) {
        for (int f = 0; f < kMaxOutlineFaces; ++f) cover.r[f] *= visible, cover.g[f] *= visible, cover.b[f] *= visible;
    }
    if (shape == ShapeKind::half_spaces || !(report.face > 0)) return;
    const float inverse = 1 / report.face;
    cover.r[0] = report.light.r * inverse, cover.g[0] = report.light.g * inverse, cover.b[0] = report.light.b * inverse;
}

/// Does the light of covered solids change so little over the tile that a polynomial of third degree in each direction
/// is good to 10^-4? By how much of the lobe's width the lobes move against the nearest solid.
ZERKALO_INLINE bool is_smooth(const TileCover& cover, const Plan& plan, const TileLobe& lobe) {
    // The error is 0.046 (span / 4)^4 of a step.
    constexpr float kWidestSpan = 0.9f;
    float room = cover.solids[0].room;
    for (std::int32_t i = 1; i < cover.count; ++i) room = min(room, cover.solids[i].room);
    for (CandidateMask left = cover.hiders; left != 0; left &= left - 1) {
        room = min(room, room_before(plan.solids[first_of(left)], lobe));
    }
    const float span = 1.42f * (lobe.turn + lobe.stray / room) * kConeDeviations;
    return room > 0 && span * span <= kWidestSpan * kWidestSpan * plan.mirrors[0].profile.tangent2;
}

/// Chooses the covered solids of a tile and computes their shades. Nothing here depends on the lobe rays.
template <class R>
ZERKALO_ONCE void cover_tile(TileCover& cover, const Plan& plan, const Rect& tile, TileCounts& counts) {
    cover.count = 0;
    cover.smooth = false;
    cover.hiders = cover.noted = 0;
    const TileLobe lobe = lobe_of_tile<R>(plan, tile);
    if (!lobe.bounded) {
        cover.plain = first_bits(plan.solid_count);
        return;
    }
    const CandidateMask solids = solids_in_reach<R>(plan, lobe);
    cover.plain = 0;
    for (CandidateMask left = solids; left != 0; left &= left - 1) {
        const int k = first_of(left);
        const CandidateMask rivals = rivals_of(plan, lobe, solids, k);
        const bool round = plan.solids[k].shape != ShapeKind::half_spaces;
        CoveredSolid& next = cover.solids[cover.count];
        const bool can = cover.count < kMaxCovered && can_be_covered(plan, lobe, k, next);
        Report report{};
        if (can && (round || rivals != 0)) {
            ScoutNotes notes;
            // What is hidden near the lobe may be seen beyond, from the tile's other places.
            for (const bool all_of_it : {false, true}) {
                scout<R>(notes, plan, lobe, k, rivals, all_of_it, counts);
                next.hidden_by = chosen_hiders(cover, plan, lobe, k, notes, rivals);
                report = sum_of(notes, next.hidden_by);
                if (rivals == 0 || report.seen > 0) break;
            }
        }
        if (!can || (rivals != 0 && !(report.seen > 0))) {
            cover.plain |= CandidateMask{1} << k;
            continue;
        }
        ++cover.count;
        cover.hiders |= next.hidden_by;
        cover.noted |= CandidateMask{1} << k | next.hidden_by;
        next.face_count = round ? 2 : plan.solids[k].half_spaces.slab_count;
        shade_solid(next, plan, {lobe.p, lobe.m, lobe.stray}, report, counts);
    }
    cover.smooth = cover.count > 0 && is_smooth(cover, plan, lobe);
}

}  // namespace zerkalo::inline ZERKALO_ISA
