// From the sums of a tile's lobe rays to the colours of its pixels, and to how sure these are.
#pragma once

#include "core/render/gloss_queue.hpp"
#include "core/render/spread.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Adds F K_r I to the colours of the pixels that waited, from the sums of their lobe rays. Other lanes read any sum.
template <class R>
ZERKALO_INLINE void settle(const GlossQueues& queues, std::uint64_t waited, const Plan& plan, const MirrorPlan& mirror,
                           TileColours& colours) {
    constexpr std::uint64_t kPacket = (std::uint64_t{1} << kWidth<R>)-1;
    const GlossQueue& sums = queues.of_class[0];
    const R rays = R(rays_in_all(plan.sampling.estimator, plan.samples)), zero = R(0);
    const Rgb<R> background = spread<R>(plan.background), tint = spread<R>(mirror.reflectance);
    for (int first = 0; first < kTilePixels; first += kWidth<R>) {
        const std::uint64_t bits = waited >> first & kPacket;
        if (bits == 0) continue;
        const std::uint8_t* slots = queues.slot + first;
        const R weight = mirror.lobe.max_phong ? gather<R>(sums.weight, slots) / rays : R(1);
        const Rgb<R> mean{gather<R>(sums.r, slots) / rays, gather<R>(sums.g, slots) / rays,
                          gather<R>(sums.b, slots) / rays};
        const Rgb<R> seen = tint * (scaled(background, weight) + mean);
        put(colours, first, select(lanes_of_bits<R>(bits), seen, Rgb<R>{zero, zero, zero}), true);
    }
}

/// Adds to the tile's spread what the parts of one class of pixels tell: see TileSpread.
template <class R, class Aids>
ZERKALO_ONCE void settle_spread(const GlossQueue& queue, const Aids& aids, int c, const Plan& plan,
                                  const MirrorPlan& mirror) {
    const GlossParts& parts = aids.parts;
    const float part_of_ray = 1.0f / rays_in_all(plan.sampling.estimator, plan.samples);
    const Rgb<R> background = spread<R>(plan.background), tint = spread<R>(scaled(mirror.reflectance, part_of_ray));
    for (std::int32_t at = 0; at < queue.count; at += kWidth<R>) {
        PartSums<R> sums;
        for (int part = 0; part < kSpreadParts; ++part) {
            Rgb<R> seen{load<R>((*parts.r)[c][part] + at), load<R>((*parts.g)[c][part] + at),
                        load<R>((*parts.b)[c][part] + at)};
            if (mirror.lobe.max_phong) seen = seen + scaled(background, load<R>((*parts.weight)[c][part] + at));
            sums.part[part] = scaled(seen, R(plan.part_scale[part]));
        }
        alignas(64) float variance[kWidth<R>];
        store(variance, variance_of(sums, tint));
        const std::uint8_t* pixels = queue.pixel + at;
        if (at + kWidth<R> <= queue.count) {
            for (int k = 0; k < kWidth<R>; ++k) aids.spread->variance[pixels[k]] += variance[k];
        } else {
            for (int k = 0; at + k < queue.count; ++k) aids.spread->variance[pixels[k]] += variance[k];
        }
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
