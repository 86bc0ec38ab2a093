// A tile of the fixed-point kernel: its colours until they are written, and the writing as float, by integers alone.
#pragma once

#include "core/render/tile.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Sums of camera samples: to 8e6, step 9e-13.
using PixelSum = Fixed<std::int64_t, 40>;

/// Where lane k of a packet of 64-bit numbers lies in memory: registers hold the even lanes, then the odd ones.
template <class R>
constexpr int place_of_long(int k) {
    return IntLaneTraits<MaskOf<R>>::kInVectors ? k % 2 * (kWidth<R> / 2) + k / 2 : k;
}
template <class R>
constexpr int place_of_pixel(int pixel) {
    return pixel / kWidth<R> * kWidth<R> + place_of_long<R>(pixel % kWidth<R>);
}

/// Linear colours of a tile's pixels, row-major over the full tile side, a packet's as place_of_pixel() says; padded for
/// whole packets.
struct FixedColours {
    std::int64_t r[kTilePixels], g[kTilePixels], b[kTilePixels];
};

template <class R>
struct TileColoursOf { using type = FloatingColours<UniformReal<R>>; };
template <int W, template <class, int> class I>
struct TileColoursOf<FixedNumbers<W, I>> { using type = FixedColours; };
template <class R>
using TileColoursFor = typename TileColoursOf<R>::type;

template <class A, Format F>
ZERKALO_INLINE void put_channel(std::int64_t* pixels, Fixed<A, F> c, bool add) {
    for (int k = 0; k < kLanesOf<A>; ++k) {
        const auto one = as<PixelSum>(with_format<F>(lane_of(c.raw, k)));
        pixels[k] = add ? (one + with_format<PixelSum::kFormat>(pixels[k])).raw : one.raw;
    }
}
template <class A, Format F>
ZERKALO_INLINE void put(FixedColours& colours, int first, Rgb<Fixed<A, F>> c, bool add) {
    put_channel(colours.r + first, c.r, add);
    put_channel(colours.g + first, c.g, add);
    put_channel(colours.b + first, c.b, add);
}

#if defined(ZERKALO_INT_VECTORS)
template <class A, Format F>
    requires InVectors<A>
ZERKALO_INLINE void put_channel(std::int64_t* pixels, Fixed<A, F> c, bool add) {
    // Light is never negative.
    constexpr int kShift = F.fraction - PixelSum::kFraction;
    static_assert(kShift > 0);
    const Longs one = each_part(
        [](Quads x) ZERKALO_INLINE_LAMBDA {
            return Quads((UnsignedQuads(x) + (std::uint64_t{1} << (kShift - 1))) >> kShift);
        },
        c.raw.v);
    store_longs(pixels, add ? held_sum(one, load_longs(pixels)) : one);
}

/// x 2^exponent of x >= 0 as floats in the order of the pixels, by the float unit: exact in double below 2^51, so
/// rounded once.
ZERKALO_INLINE void store_floats(float* target, const std::int64_t* x, double unit) {
    for (int i = 0; i < kTilePixels; i += kVectorWidth) {
        const auto narrow = each_part(
            [unit](Quads whole) ZERKALO_INLINE_LAMBDA {
                return __builtin_convertvector(double_of_small(whole) * unit, Vector<float, kPartLanes>);
            },
            load_longs(x + i));
        const Floats ordered = one_after_the_other(narrow.even, narrow.odd);
        __builtin_memcpy(target + i, &ordered, sizeof ordered);
    }
}

ZERKALO_INLINE bool all_below(const FixedColours& colours, std::int64_t limit) {
    Quads together{};
    for (const std::int64_t* x : {colours.r, colours.g, colours.b}) {
        for (int i = 0; i < kTilePixels; i += kPartLanes) {
            Quads whole;
            __builtin_memcpy(&whole, x + i, sizeof whole);
            together |= whole;
        }
    }
    std::int64_t bits = 0;
    for (int k = 0; k < kPartLanes; ++k) bits |= together[k];
    return bits >= 0 && bits < limit;
}
#endif

/// Divides the sums by the number of camera samples.
template <class R>
ZERKALO_INLINE void average(FixedColours& colours, std::int32_t antialias) {
    for (std::int32_t i = 0; i < kTilePixels; ++i) {
        colours.r[i] = rounded_quotient<std::int64_t, 0>(colours.r[i], antialias);
        colours.g[i] = rounded_quotient<std::int64_t, 0>(colours.g[i], antialias);
        colours.b[i] = rounded_quotient<std::int64_t, 0>(colours.b[i], antialias);
    }
}

/// The bits of the float nearest to x 2^exponent of x >= 0, ties to even.
ZERKALO_INLINE std::uint32_t float_bits_of(std::int64_t x, int exponent) {
    if (x <= 0) return 0;
    const auto size = static_cast<std::uint64_t>(x);
    const int zeros = leading_zeros(size);
    const std::uint64_t m = size << zeros;  // 2^63 <= m: 24 bits stay, 40 go
    constexpr std::uint64_t kHalf = std::uint64_t{1} << 39, kRest = (std::uint64_t{1} << 40) - 1;
    std::uint64_t kept = m >> 40;
    const std::uint64_t rest = m & kRest;
    kept += rest > kHalf || (rest == kHalf && (kept & 1)) ? 1u : 0u;
    // A carry into bit 24 raises the exponent by itself.
    const int biased = 127 + 63 - zeros + exponent;
    return (static_cast<std::uint32_t>(biased - 1) << 23) + static_cast<std::uint32_t>(kept);
}

/// One pixel of the tile, from the bits of its floats.
ZERKALO_INLINE void write_pixel(const Tile& tile, const LinearImage& image, int pixel, const std::uint32_t (&bits)[3]) {
    float* out = image.row(tile.top + pixel / kTileSide) + 3 * (tile.left + pixel % kTileSide);
    __builtin_memcpy(out, bits, sizeof bits);
}

/// The tile's part of the picture.
template <class R>
ZERKALO_INLINE void write_tile(const FixedPlan& plan, const FixedColours& colours, const Tile& tile,
                               const LinearImage& image) {
    const int exponent = plan.exposure - PixelSum::kFraction;
#if defined(ZERKALO_INT_VECTORS)
    if (IntLaneTraits<MaskOf<R>>::kInVectors && all_below(colours, std::int64_t{1} << 51)) {
        TileColours floats;
        const double unit = __builtin_bit_cast(double, std::int64_t{1023 + exponent} << 52);
        store_floats(floats.r, colours.r, unit);
        store_floats(floats.g, colours.g, unit);
        store_floats(floats.b, colours.b, unit);
        return write_rows<Real<kVectorWidth>>(floats, kTileSide, tile, image);
    }
#endif
    for (std::uint64_t left = tile.pixels; left != 0; left &= left - 1) {
        const int pixel = first_of(left);
        const int place = place_of_pixel<R>(pixel);
        const std::uint32_t bits[3] = {float_bits_of(colours.r[place], exponent),
                                       float_bits_of(colours.g[place], exponent),
                                       float_bits_of(colours.b[place], exponent)};
        write_pixel(tile, image, pixel, bits);
    }
}

/// A tile that sees nothing: the background, as pixels of rendered tiles have it.
template <class R>
ZERKALO_INLINE void fill_tile(const FixedPlan& plan, const Tile& tile, const LinearImage& image) {
    using W = Weight<FixedNumbers<1>>;
    const auto light = plan.background * Rgb<W>{W(1), W(1), W(1)};
    const int exponent = plan.exposure - PixelSum::kFraction;
    const std::uint32_t bits[3] = {float_bits_of(as<PixelSum>(light.r).raw, exponent),
                                   float_bits_of(as<PixelSum>(light.g).raw, exponent),
                                   float_bits_of(as<PixelSum>(light.b).raw, exponent)};
    if (tile.pixels == kWholeTile) {
        std::uint32_t row[3 * kTileSide];
        for (int x = 0; x < kTileSide; ++x) __builtin_memcpy(row + 3 * x, bits, sizeof bits);
        float* out = image.row(tile.top) + 3 * tile.left;
        for (int y = 0; y < kTileSide; ++y, out = image.below(out)) __builtin_memcpy(out, row, sizeof row);
        return;
    }
    for (std::uint64_t left = tile.pixels; left != 0; left &= left - 1) {
        write_pixel(tile, image, first_of(left), bits);
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
