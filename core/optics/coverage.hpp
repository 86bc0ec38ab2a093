// How much of a lobe a region of directions covers, by an integral along the region's outline:
//
//     coverage = 1/(2 pi) closed integral of (1 - cos^(n+1) theta) dphi
//              = [the axis is inside]  -  1/(2 pi) closed integral of cos^(n+1) theta dphi
//
// with theta, phi the polar angles about the lobe's axis m: one integration, in theta, of the density
// p = (n+1)/(2 pi) cos^n theta. Any real n >= 0. With v = sin^2 theta the power enters as D(v) = (1 - cos^(n+1)) / v,
// smooth at the axis: no singularity, however near the outline passes. D is a polynomial (LobeProfile).
// Beyond the cone that holds all but 2^-12 of the lobe the power counts as 0: only the parts of an outline inside that
// cone cost anything, and eight nodes of Gauss and Legendre serve any exponent.
// Places are in the lobe's frame: x, y across, z along the axis, seen from the lobe's apex; lengths do not matter.
// Source: Arvo, "Applications of Irradiance Tensors to the Simulation of Non-Lambertian Phenomena", SIGGRAPH 1995, has
// the boundary integral for whole n.
#pragma once

#include "core/geometry/algebra.hpp"
#include "core/optics/optics_data.hpp"

namespace zerkalo::inline ZERKALO_ISA {

constexpr int kNodePairs = 4;
constexpr float kNodes[kNodePairs] = {0.1834346424956498f, 0.5255324099163290f, 0.7966664774136267f,
                                      0.9602898564975363f};
constexpr float kNodeWeights[kNodePairs] = {0.3626837833783620f, 0.3137066458778873f, 0.2223810344533745f,
                                            0.1012285362903763f};
// Of four nodes, for pieces of an outline that are short against the lobe.
constexpr float kFewNodes[2] = {0.3399810435848563f, 0.8611363115940526f};
constexpr float kFewNodeWeights[2] = {0.6521451548625461f, 0.3478548451374538f};
constexpr float kInverseTurn = 0.15915494309189535f;  // 1 / (2 pi)

/// D(v) for 0 <= v <= profile.edge.
template <class R>
ZERKALO_INLINE R winding_density(const LobeProfile& profile, R v) {
    const R y = v * R(profile.to_unit) - R(1);
    R p = R(profile.powers[kProfileTerms - 1]);
    for (int k = kProfileTerms - 2; k >= 0; --k) p = p * y + R(profile.powers[k]);
    return p;
}

/// The angle of (x, y) as a share of a turn, -1/2..1/2; y >= 0, also -0, counts as the upper side. Error below 6e-7.
template <class R>
ZERKALO_INLINE R turn_of(R y, R x) {
    const R across = max(y, -y), along = max(x, -x);
    const R larger = max(across, along);
    const R ratio = min(across, along) / max(larger, R(0x1p-126f));
    const R z = ratio * ratio;
    // atan(r) / (2 pi r) in r^2, Chebyshev's fit.
    R p = R(-0x1.17ff30p-9f);
    p = p * z + R(0x1.2afd5cp-7f);
    p = p * z + R(-0x1.3bcdecp-6f);
    p = p * z + R(0x1.fe0456p-6f);
    p = p * z + R(-0x1.b22652p-5f);
    p = p * z + R(0x1.45f2a6p-3f);
    p = p * ratio;
    p = select(across > along, R(0.25f) - p, p);
    p = select(x < R(0), R(0.5f) - p, p);
    return select(y < R(0), -p, p);
}

/// x of a times y of b minus y of a times x of b: > 0 where the axis lies to the left of the way from a to b.
template <class R>
ZERKALO_INLINE R turning(Vec3<R> a, Vec3<R> b) {
    return a.x * b.y - a.y * b.x;
}

/// May the edge, a great circle from a to b, come into the profile's cone? `n` is a x b, or that of a longer edge of
/// which this one is a part.
template <class R>
ZERKALO_INLINE Mask<R> edge_comes_near(const LobeProfile& profile, Vec3<R> n, Vec3<R> a, Vec3<R> b) {
    return (n.z * n.z < R(profile.tangent2) * (n.x * n.x + n.y * n.y)) & ((a.z > R(0)) | (b.z > R(0)));
}

/// The part of such an edge that lies in the cone: in the plane at distance 1 before the apex the edge's line passes
/// the axis at `offset`, and positions on the line count from there. Lanes that do not cross the cone are meaningless.
template <class R>
struct EdgePart {
    Mask<R> crosses;
    R offset, from, to;
};

template <class R>
ZERKALO_INLINE EdgePart<R> part_in_cone(const LobeProfile& profile, Vec3<R> n, Vec3<R> a, Vec3<R> b, Mask<R> near) {
    const R inverse = R(1) / sqrt(n.x * n.x + n.y * n.y);
    const R offset = n.z * inverse;
    const R reach = sqrt(max(R(profile.tangent2) - offset * offset, R(0)));
    const R at_a = (a.x * n.y - a.y * n.x) * inverse / a.z, at_b = (b.x * n.y - b.y * n.x) * inverse / b.z;
    const R from = select(a.z > R(0), max(at_a, -reach), -reach), to = select(b.z > R(0), min(at_b, reach), reach);
    return {Mask<R>(near & (from < to)), offset, from, to};
}

/// 1/(2 pi) integral of cos^(n+1) dphi along the great circle from a to b; n as for edge_comes_near.
template <class R>
ZERKALO_INLINE R edge_share(const LobeProfile& profile, Vec3<R> n, Vec3<R> a, Vec3<R> b) {
    const Mask<R> near = edge_comes_near(profile, n, a, b);
    if (none(near)) return R(0);
    const EdgePart<R> part = part_in_cone(profile, n, a, b, near);
    if (none(part.crosses)) return R(0);
    const R offset = part.offset, from = part.from, to = part.to;

    // The way along the edge as an angle w from the place nearest to the axis, by u = tan(w / 2): dw = 2 du / (1 + u^2),
    // v = sin^2 g + cos^2 g sin^2 w, g the least angle to the axis; dphi = sin g dw / v.
    const R offset2 = offset * offset;
    const R cosine_g2 = R(1) / (R(1) + offset2);
    const R cosine_g = sqrt(cosine_g2), sine_g2 = offset2 * cosine_g2;
    const auto half_angle = [&](R at) ZERKALO_INLINE_LAMBDA {
        const R tangent = at * cosine_g;
        return tangent / (R(1) + sqrt(R(1) + tangent * tangent));
    };
    const R u_from = half_angle(from), u_to = half_angle(to);
    const R middle = (u_from + u_to) * R(0.5f), half = (u_to - u_from) * R(0.5f);
    const auto density = [&](R u) ZERKALO_INLINE_LAMBDA {
        const R u2 = u * u;
        const R scale = R(1) / (R(1) + u2);
        const R sine2 = R(4) * u2 * scale * scale;
        return winding_density(profile, sine_g2 + cosine_g2 * sine2) * scale;
    };
    R sum = R(0);
    for (int k = 0; k < kNodePairs; ++k) {
        const R step = half * R(kNodes[k]);
        sum = sum + (density(middle - step) + density(middle + step)) * R(kNodeWeights[k]);
    }
    const R along = offset * cosine_g * half * sum * R(2 * kInverseTurn);
    const R around = turn_of(select(n.z >= R(0), offset, -offset) * (to - from), offset2 + from * to);
    const R share = select(n.z >= R(0), around, -around) - along;
    return select(part.crosses, share, R(0));
}
template <class R>
ZERKALO_INLINE R edge_share(const LobeProfile& profile, Vec3<R> a, Vec3<R> b) {
    return edge_share(profile, cross(a, b), a, b);
}

/// A part of a conic section as a rational curve (1-t)^2 a + 2 t (1-t) c + t^2 b, 0 <= t <= 1.
template <class R>
struct ConicArc {
    Vec3<R> a, c, b;
};

template <class R>
ZERKALO_INLINE Vec3<R> place_on(const ConicArc<R>& arc, R t) {
    const R u = R(1) - t;
    return arc.a * (u * u) + arc.c * (R(2) * t * u) + arc.b * (t * t);
}

/// 1/(2 pi) integral of (1 - cos^(n+1)) dphi along the arc between parameters t0 < t1, by four nodes or by eight.
template <class R>
ZERKALO_INLINE R arc_integral(const LobeProfile& profile, const ConicArc<R>& arc, R t0, R t1, bool few_nodes) {
    const R middle = (t0 + t1) * R(0.5f), half = (t1 - t0) * R(0.5f);
    const auto winding = [&](R t) ZERKALO_INLINE_LAMBDA {
        const Vec3<R> q = place_on(arc, t);
        const R u = R(1) - t;
        const R d_x = (arc.c.x - arc.a.x) * u + (arc.b.x - arc.c.x) * t;
        const R d_y = (arc.c.y - arc.a.y) * u + (arc.b.y - arc.c.y) * t;
        const R across2 = q.x * q.x + q.y * q.y, all2 = across2 + q.z * q.z;
        // Outside of the cone the power is 0: D = 1 / v.
        const auto inside = (q.z > R(0)) & (across2 < R(profile.edge) * all2);
        const R inverse = R(1) / select(inside, all2, across2);
        const R density = select(inside, winding_density(profile, across2 * inverse), R(1));
        return (q.x * d_y - q.y * d_x) * (density * inverse);
    };
    const float* nodes = few_nodes ? kFewNodes : kNodes;
    const float* weights = few_nodes ? kFewNodeWeights : kNodeWeights;
    R sum = R(0);
    for (int k = 0; k < (few_nodes ? 2 : kNodePairs); ++k) {
        const R step = half * R(nodes[k]);
        sum = sum + (winding(middle - step) + winding(middle + step)) * R(weights[k]);
    }
    // q' is twice (d_x, d_y).
    return half * sum * R(2 * kInverseTurn);
}

/// A ball seen from outside fills a round cap of half-angle a, its middle at the angle g from the axis. A point of the
/// outline at the angle s around the middle, from the place nearest to the axis, with h = sin^2(s / 2):
///     x = sin(g - a) + 2 sin a cos g h,   y = 2 sin a sqrt(h (1 - h)),   z = cos(g - a) - 2 sin a sin g h
template <class R>
struct BallView {
    R sine_g, cosine_g, sine_a, cosine_a;
    R nearest, ahead;  // sine and cosine of g - a
    R edge2;           // h where the outline leaves the profile's cone: 1 if it does not, 0 if it passes the cone
};

/// Of a ball whose centre lies at (across, along) from the apex, across >= 0, its radius less than the distance.
template <class R>
ZERKALO_INLINE BallView<R> view_of_ball(const LobeProfile& profile, R across, R along, R radius) {
    const R distance2 = across * across + along * along;
    const R inverse = R(1) / sqrt(distance2);
    BallView<R> view;
    view.sine_g = across * inverse, view.cosine_g = along * inverse;
    view.sine_a = radius * inverse, view.cosine_a = sqrt(max((R(1) - view.sine_a) * (R(1) + view.sine_a), R(0)));
    view.nearest = view.sine_g * view.cosine_a - view.cosine_g * view.sine_a;
    view.ahead = view.cosine_g * view.cosine_a + view.sine_g * view.sine_a;
    // 1 - cos(g - a), also where that is tiny.
    const R from_axis =
        select(view.ahead > R(0), view.nearest * view.nearest / (R(1) + view.ahead), R(1) - view.ahead);
    const R room = R(profile.from_axis) - from_axis;
    const R span = R(2) * view.sine_a * view.sine_g;
    view.edge2 = select(room < span, max(room, R(0)) / span, R(1));
    return view;
}

/// Coverage by a ball; as for view_of_ball.
template <class R>
ZERKALO_INLINE R ball_coverage(const LobeProfile& profile, R across, R along, R radius) {
    const BallView<R> view = view_of_ball(profile, across, along, radius);
    const R sine_a = view.sine_a, nearest = view.nearest, edge2 = view.edge2;

    // tan(s / 4) runs from 0 to its end, at most 1: sin(s / 2) = 2 u / (1 + u^2), ds = 4 du / (1 + u^2).
    const R edge = sqrt(edge2), turned = sqrt(R(1) - edge2);
    const R end = edge / (R(1) + turned);
    const R slope = R(2) * sine_a * view.cosine_g, winding_slope = R(2) * view.cosine_a * view.sine_g;
    const auto winding = [&](float t) ZERKALO_INLINE_LAMBDA {
        const R u = end * R(t);
        const R scale = R(1) / (R(1) + u * u);
        const R root_h = R(2) * u * scale;
        const R h = root_h * root_h;
        const R side = nearest + slope * h;
        const R up = R(2) * sine_a * root_h * ((R(1) - u * u) * scale);
        return (winding_slope * h - nearest) * winding_density(profile, side * side + up * up) * scale;
    };
    R sum = R(0);
    if (any(edge2 > R(0))) {
        for (int k = 0; k < kNodePairs; ++k) {
            sum = sum + (winding((1 - kNodes[k]) / 2) + winding((1 + kNodes[k]) / 2)) * R(kNodeWeights[k]);
        }
    }
    // Both halves of the outline, the nodes' interval half as long as theirs.
    const R along_arc = sine_a * end * sum * R(4 * kInverseTurn);
    const R rest = turn_of(R(2) * sine_a * edge * turned, nearest + slope * edge2);
    // 0 has one sign, whether or not a neighbour in the packet is met.
    return rest * R(2) + along_arc + R(0);
}

}  // namespace zerkalo::inline ZERKALO_ISA
