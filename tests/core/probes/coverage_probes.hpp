// Probes of the coverage of lobes.
#pragma once

#include "core/render/cover_solids.hpp"
#include "tests/core/probes/shape_probes.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <class R>
void probe_polygon(const LobeProfile& profile, const probes::Points* corners, int corner_count, float* out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        auto inside = Mask<R>(true);
        R share = R(0);
        for (int c = 0; c < corner_count; ++c) {
            const Vec3<R> a = load_point<R>(corners[c], k), b = load_point<R>(corners[(c + 1) % corner_count], k);
            inside = inside & (turning(a, b) >= R(0));
            share = share + edge_share(profile, a, b);
        }
        store(out + k, as_number<R>(inside) - share);
    }
}

template <class R>
void probe_ball_cover(const LobeProfile& profile, const float* across, const float* along, const float* radius,
                      float* out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        store(out + k, ball_coverage(profile, load<R>(across + k), load<R>(along + k), load<R>(radius + k)));
    }
}

template <class R>
void probe_rim_cover(const LobeProfile& profile, const float* across, const float* along, const float* radius,
                     std::int32_t panels, float* out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) {
        // The circle in which the ball touches its tangents, about the way to its centre, and a direction across both.
        const R x = load<R>(across + k), z = load<R>(along + k), r = load<R>(radius + k);
        const R distance2 = x * x + z * z, inverse = R(1) / sqrt(distance2);
        const R nearer = R(1) - r * r / distance2;
        const R rim_radius = r * sqrt(nearer);
        const Rim<R> rim{{x * nearer, R(0), z * nearer},
                         {z * inverse * rim_radius, R(0), -x * inverse * rim_radius}, {R(0), rim_radius, R(0)}};
        const auto exists = Mask<R>(true);
        const OutlineWay<R> around = along_rim(profile, rim, R(-1), exists, panels, panels > 12);
        store(out + k, as_number<R>(around.left) - around.share);
    }
}

template <class R>
void probe_turn(const float* y, const float* x, float* out, int count) {
    for (int k = 0; k < count; k += kWidth<R>) store(out + k, turn_of(load<R>(y + k), load<R>(x + k)));
}

template <class R>
constexpr probes::CoverageProbes coverage_probes() {
    return {&probe_polygon<R>, &probe_ball_cover<R>, &probe_rim_cover<R>, &probe_turn<R>};
}

}  // namespace zerkalo::inline ZERKALO_ISA
