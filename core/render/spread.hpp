// How sure a lobe's average is, from its own rays: every fourth ray makes a small average of its own, and the four lie
// the farther from one another, the less the whole can be trusted.
//
// A lattice of N points is four lattices of N/4, interleaved. With m_k the average over one of them, by what its rays
// count for, and m over all,
//
//     variance of m  <  sum of (m_k - m)^2 / (R (R - 1)),  R = 4
//
// with equality for parts that are independent. These are not: together they are better placed than four independent
// lattices would be, and by how much follows from the rule that places the points (render/progressive.cpp).
#pragma once

#include "core/render/render.hpp"
#include "core/render/visibility.hpp"

#include <type_traits>

namespace zerkalo::inline ZERKALO_ISA {

/// What every kSpreadParts-th lobe ray of a packet's pixels adds to their colours.
template <class R>
struct PartSums {
    Rgb<R> part[kSpreadParts];
};

/// The variance of `tint` times the whole if the parts were independent, summed over the channels. Each counts for a
/// fourth of it.
template <class R>
ZERKALO_INLINE R variance_of(const PartSums<R>& sums, const Rgb<R>& tint) {
    Rgb<R> mean = sums.part[0];
    for (int k = 1; k < kSpreadParts; ++k) mean = mean + sums.part[k];
    mean = scaled(mean, R(1.0f / kSpreadParts));
    const Rgb<R> first = sums.part[0] - mean;
    Rgb<R> squares = first * first;
    for (int k = 1; k < kSpreadParts; ++k) {
        const Rgb<R> off = sums.part[k] - mean;
        squares = squares + off * off;
    }
    squares = squares * (tint * tint);
    // m_k is R times its part's sum.
    return (squares.r + squares.g + squares.b) * R(float(kSpreadParts) / float(kSpreadParts - 1));
}

/// Before the first camera ray. The working memory is cleared where it is used.
ZERKALO_INLINE void clear(TileSpread& spread) {
    for (float& variance : spread.variance) variance = 0;
}

/// The average over camera rays, whose lobes are placed independently.
ZERKALO_INLINE void average(TileSpread& spread, std::int32_t antialias) {
    if (antialias == 1) return;
    const float square = float(antialias) * float(antialias);
    for (float& variance : spread.variance) variance = variance / square;
}

/// Only the kernels in float tell.
template <class R>
constexpr bool kTells = std::is_same_v<Formats<R>, FloatFormats>;

/// The same of any scene's path trees.
template <class R, bool tells = kTells<R>>
struct LobeParts {};
template <class R>
struct LobeParts<R, true> : PartSums<R> {};

/// What lobe ray `sample` and all that came of it have added to the pixels.
template <class R>
ZERKALO_INLINE void note(LobeParts<R>& parts, std::int32_t sample, const Rgb<LightSum<R>>& sum,
                         const Rgb<LightSum<R>>& before) {
    if constexpr (kTells<R>) {
        Rgb<R>& part = parts.part[sample % kSpreadParts];
        part = part + (sum - before);
    }
}

template <class R>
ZERKALO_INLINE void add_variance(TileSpread& spread, int first, const PlanHead& plan, const LobeParts<R>& parts) {
    if constexpr (kTells<R>) {
        PartSums<R> equal;
        for (int k = 0; k < kSpreadParts; ++k) equal.part[k] = scaled(parts.part[k], R(plan.part_scale[k]));
        float* out = spread.variance + first;
        store(out, load<R>(out) + variance_of<R>(equal, {R(1), R(1), R(1)}));
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
