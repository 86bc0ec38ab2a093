// A tile: what it can see, its colours until they are written, and the writing.
#pragma once

#include "core/geometry/algebra.hpp"
#include "core/render/shade.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// Conservative answers for all pixels of one tile.
struct TileView {
    CandidateMask seen;        // by camera rays
    CandidateMask in_mirror;   // solids whose images a camera ray can meet in the only, plane mirror
    CandidateMask in_lobe;     // the same for its lobe rays; filled in by the glossy kernel
    Blockers mirror_blockers;  // that can shade the visible part of that mirror
};

ZERKALO_INLINE bool overlap(const PixelBounds& bounds, const Rect& tile) {
    return bounds.left < tile.left + tile.width && tile.left < bounds.right && bounds.top < tile.top + tile.height &&
           tile.top < bounds.bottom;
}

ZERKALO_INLINE CandidateMask overlapping(const PixelBounds* bounds, std::int32_t count, const Rect& tile) {
    CandidateMask mask = 0;
    for (std::int32_t k = 0; k < count; ++k) mask |= CandidateMask{overlap(bounds[k], tile)} << k;
    return mask;
}

ZERKALO_INLINE TileView view_of_tile(const Plan& plan, const Rect& tile) {
    TileView view;
    const CandidateMask mirrors = overlapping(plan.mirror_bounds, plan.mirror_count, tile);
    view.seen = overlapping(plan.solid_bounds, plan.solid_count, tile) | mirrors << kMaxSolids;
    view.in_mirror = 0;
    view.in_lobe = 0;
    if (mirrors == 0) return view;
    view.in_mirror = overlapping(plan.image_bounds, plan.solid_count, tile);
    for (std::int32_t j = 0; j < plan.light_count; ++j) {
        const CandidateMask shadows = overlapping(plan.shadow_bounds[j], plan.solid_count, tile);
        view.mirror_blockers.of_light[j] =
            plan.blockers_of_mirror[0].of_light[j] & (shadows | ~CandidateMask{0xffffffffu});
    }
    return view;
}

/// Linear colours of a tile's pixels, row-major over the full tile side; padded for whole packets.
struct TileColours {
    alignas(64) float r[kTilePixels], g[kTilePixels], b[kTilePixels];
};

template <class R>
ZERKALO_INLINE void put(TileColours& colours, int first, Rgb<R> c, bool add) {
    if (add) {
        c.r = c.r + load<R>(colours.r + first);
        c.g = c.g + load<R>(colours.g + first);
        c.b = c.b + load<R>(colours.b + first);
    }
    store(colours.r + first, c.r);
    store(colours.g + first, c.g);
    store(colours.b + first, c.b);
}

/// Writes the tile's part of the picture, each pixel divided by the number of camera samples.
ZERKALO_INLINE void write_tile(const TileColours& colours, const Rect& tile, std::int32_t antialias,
                               const LinearImage& image) {
    const float count = float(antialias);
    for (std::int32_t y = 0; y < tile.height; ++y) {
        float* out = image.row(tile.top + y) + 3 * tile.left;
        const std::int32_t first = y * kTileSide;
        if (antialias == 1) {
            for (std::int32_t x = 0; x < tile.width; ++x) {
                out[3 * x] = colours.r[first + x];
                out[3 * x + 1] = colours.g[first + x];
                out[3 * x + 2] = colours.b[first + x];
            }
        } else {
            for (std::int32_t x = 0; x < tile.width; ++x) {
                out[3 * x] = colours.r[first + x] / count;
                out[3 * x + 1] = colours.g[first + x] / count;
                out[3 * x + 2] = colours.b[first + x] / count;
            }
        }
    }
}

/// A tile that sees nothing: the background, summed and divided as the samples of rendered pixels are.
ZERKALO_INLINE void fill_tile(Rgb<float> background, std::int32_t antialias, const Rect& tile,
                              const LinearImage& image) {
    Rgb<float> c = background;
    for (std::int32_t a = 1; a < antialias; ++a) c = c + background;
    if (antialias > 1) {
        const float count = float(antialias);
        c = {c.r / count, c.g / count, c.b / count};
    }
    for (std::int32_t y = 0; y < tile.height; ++y) {
        float* out = image.row(tile.top + y) + 3 * tile.left;
        for (std::int32_t x = 0; x < tile.width; ++x) {
            out[3 * x] = c.r;
            out[3 * x + 1] = c.g;
            out[3 * x + 2] = c.b;
        }
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
