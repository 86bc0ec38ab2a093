// A tile: what it can see, its colours until they are written, and the writing.
#pragma once

#include "core/geometry/algebra.hpp"
#include "core/numeric/shuffle.hpp"
#include "core/render/shade.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Conservative answers for all pixels of one tile.
struct TileView {
    CandidateMask seen;        // by camera rays
    CandidateMask in_mirror;   // solids whose images a camera ray can meet in the only, plane mirror
    CandidateMask in_lobe;     // the same for its lobe rays; filled in by the glossy kernel
    Blockers mirror_blockers;  // that can shade the visible part of that mirror
};

/// Bit k: the bounds of object k share a pixel with the tile.
template <class R, int n>
ZERKALO_INLINE CandidateMask overlapping(const PixelBoundsTable<n, UniformReal<R>>& bounds, std::int32_t count,
                                         const Rect& tile) {
    const R left = R(float(tile.left)), right = R(float(tile.left + tile.width));
    const R top = R(float(tile.top)), bottom = R(float(tile.top + tile.height));
    CandidateMask mask = 0;
    for (std::int32_t k = 0; k < count; k += kWidth<R>) {
        const Mask<R> begins_before = load<R>(bounds.left + k) < right, ends_after = left < load<R>(bounds.right + k);
        const Mask<R> begins_above = load<R>(bounds.top + k) < bottom, ends_below = top < load<R>(bounds.bottom + k);
        mask |= CandidateMask{bits_of(Mask<R>(begins_before & ends_after & begins_above & ends_below))} << k;
    }
    return mask & first_bits(count);
}

/// The same of bounds that are integers, one after the other.
template <class R, int n>
ZERKALO_INLINE CandidateMask overlapping(const PixelBoundsTable<n, std::int32_t>& bounds, std::int32_t count,
                                         const Rect& tile) {
    CandidateMask mask = 0;
    for (std::int32_t k = 0; k < count; ++k) {
        const bool shared = bounds.left[k] < tile.left + tile.width && tile.left < bounds.right[k] &&
                            bounds.top[k] < tile.top + tile.height && tile.top < bounds.bottom[k];
        mask |= CandidateMask{shared} << k;
    }
    return mask;
}

/// What camera rays can see.
template <class R, class F>
ZERKALO_INLINE CandidateMask seen_by_tile(const PlanOf<F>& plan, const Rect& tile) {
    return overlapping<R>(plan.solid_bounds, plan.solid_count, tile) |
           overlapping<R>(plan.mirror_bounds, plan.mirror_count, tile) << kMaxSolids;
}

/// What can shade the part of the only, plane mirror that the tile sees.
template <class R, class F>
ZERKALO_INLINE void fill_blockers(Blockers& blockers, const PlanOf<F>& plan, const Rect& tile) {
    for (std::int32_t j = 0; j < plan.light_count; ++j) {
        const CandidateMask shadows = overlapping<R>(plan.shadow_bounds[j], plan.solid_count, tile);
        blockers.of_light[j] = plan.mirrors[0].blockers.of_light[j] & (shadows | ~CandidateMask{0xffffffffu});
    }
}

template <class R>
ZERKALO_INLINE TileView view_of_tile(const Plan& plan, const Rect& tile) {
    TileView view;
    view.seen = seen_by_tile<R>(plan, tile);
    view.in_mirror = 0;
    view.in_lobe = 0;
    if (mirrors_in(view.seen) == 0) return view;
    view.in_mirror = overlapping<R>(plan.image_bounds, plan.solid_count, tile);
    fill_blockers<R>(view.mirror_blockers, plan, tile);
    return view;
}

/// What camera rays can see, without what only the kernels for at most one bounce ask.
template <class R, class F>
ZERKALO_INLINE TileView view_of_tile(const PlanOf<F>& plan, const Rect& tile) {
    TileView view{};
    view.seen = seen_by_tile<R>(plan, tile);
    if (mirrors_in(view.seen) != 0) fill_blockers<R>(view.mirror_blockers, plan, tile);
    return view;
}

ZERKALO_INLINE std::uint64_t camera_rays(const PlanHead& plan, const Tile& tile) {
    std::uint64_t pixels = tile.pixels == kWholeTile ? kTilePixels : 0;
    if (pixels == 0) {
        for (std::uint64_t left = tile.pixels; left != 0; left &= left - 1) ++pixels;
    }
    return pixels * static_cast<std::uint64_t>(plan.antialias);
}

/// Linear colours of a tile's pixels, row-major over the full tile side; padded for whole packets. T: float or double.
template <class T>
struct FloatingColours {
    alignas(64) T r[kTilePixels], g[kTilePixels], b[kTilePixels];
};
using TileColours = FloatingColours<float>;

template <class R, class T>
ZERKALO_INLINE void put(FloatingColours<T>& colours, int first, Rgb<R> c, bool add) {
    if (add) {
        c.r = c.r + load<R>(colours.r + first);
        c.g = c.g + load<R>(colours.g + first);
        c.b = c.b + load<R>(colours.b + first);
    }
    store(colours.r + first, c.r);
    store(colours.g + first, c.g);
    store(colours.b + first, c.b);
}

/// Divides the sums by the number of camera samples.
template <class R, class T>
ZERKALO_INLINE void average(FloatingColours<T>& colours, std::int32_t antialias) {
    const R count = R(float(antialias));
    for (std::int32_t i = 0; i < kTilePixels; i += kWidth<R>) {
        store(colours.r + i, load<R>(colours.r + i) / count);
        store(colours.g + i, load<R>(colours.g + i) / count);
        store(colours.b + i, load<R>(colours.b + i) / count);
    }
}

/// Writes one row of a whole tile; a double is rounded to float here.
template <class R, class T>
ZERKALO_INLINE void write_whole_row(const FloatingColours<T>& colours, int first, float* out) {
    constexpr int kRun = kWidth<R> < kTileSide ? kWidth<R> : kTileSide;
    for (int x = 0; x < kTileSide; x += kRun) {
        if constexpr (kRun > 1) {
            store_triples<kRun>(out + 3 * x, colours.r + first + x, colours.g + first + x, colours.b + first + x);
        } else {
            out[3 * x] = float(colours.r[first + x]);
            out[3 * x + 1] = float(colours.g[first + x]);
            out[3 * x + 2] = float(colours.b[first + x]);
        }
    }
}

/// Writes the tile's part of the picture from rows that lie `step` apart.
template <class R, class T>
ZERKALO_INLINE void write_rows(const FloatingColours<T>& colours, int step, const Tile& tile,
                               const LinearImage& image) {
    if (tile.pixels == kWholeTile) {
        float* out = image.row(tile.top) + 3 * tile.left;
        for (std::int32_t y = 0; y < kTileSide; ++y, out = image.below(out)) {
            write_whole_row<R>(colours, y * step, out);
        }
        return;
    }
    for (std::uint64_t left = tile.pixels; left != 0; left &= left - 1) {
        const int pixel = first_of(left), x = pixel % kTileSide, y = pixel / kTileSide;
        float* out = image.row(tile.top + y) + 3 * (tile.left + x);
        const int from = y * step + x;
        out[0] = float(colours.r[from]), out[1] = float(colours.g[from]), out[2] = float(colours.b[from]);
    }
}

template <class R, class T>
ZERKALO_INLINE void write_tile(const PlanOf<FloatingFormats<T>>&, const FloatingColours<T>& colours, const Tile& tile,
                               const LinearImage& image) {
    write_rows<R>(colours, kTileSide, tile, image);
}

/// A tile that sees nothing: the background, summed and divided as the samples of rendered pixels are.
template <class R, class T>
ZERKALO_INLINE void fill_tile(const PlanOf<FloatingFormats<T>>& plan, const Tile& tile, const LinearImage& image) {
    Rgb<T> c = plan.background;
    for (std::int32_t a = 1; a < plan.antialias; ++a) c = c + plan.background;
    if (plan.antialias > 1) {
        const T count = T(plan.antialias);
        c = {c.r / count, c.g / count, c.b / count};
    }
    FloatingColours<T> colours;
    for (int first = 0; first < kTileSide; first += kWidth<R>) put(colours, first, spread<R>(c), false);
    write_rows<R>(colours, 0, tile, image);
}

}  // namespace zerkalo::inline ZERKALO_ISA
