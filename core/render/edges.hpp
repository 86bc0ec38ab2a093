// Camera rays where they are needed: at silhouettes, the edges of shadows and of what mirrors show. A pixel whose centre
// looks like its neighbours' needs one camera ray and spends its lobe rays on it; one that does not gets several camera
// rays and each of them a part of the lobe rays, which together are one lattice (lattice_part in optics/estimator.hpp).
//
//     begin_pass(plan, centre_pass(samples, rotation));            then every tile
//     edges[i] = edge_pixels(image, tile_at(plan, i));              for every tile, of the whole picture
//     begin_pass(plan, edge_pass(samples, rotation, antialias));    then Tile(tile_at(plan, i), edges[i]) for every i
#pragma once

#include "core/render/plan.hpp"

namespace zerkalo {

constexpr std::int32_t kEdgeAntialias = 16;  // camera rays of a pixel at an edge, if nothing else is asked for

/// One camera ray a pixel.
constexpr Pass centre_pass(std::int32_t samples, std::int32_t rotation) { return {samples, rotation, false, 1}; }

/// So many camera rays a pixel, and no fewer lobe rays for all of them than `samples`.
constexpr Pass edge_pass(std::int32_t samples, std::int32_t rotation, std::int32_t antialias) {
    return {(samples + antialias - 1) / antialias, rotation, false, antialias};
}

/// The pixels of a tile, bit p for pixel p, that differ from one of the four beside them, in the tile or outside of it:
/// in some channel by more than 1/16 in the square root of linear light, about 16 steps of 8 bits, with 0 and 1 as its
/// ends. Both sides of an edge are named. A pure function of the picture: call it when all tiles are painted with one
/// camera ray a pixel, and before any is painted again.
std::uint64_t edge_pixels(const LinearImage& image, const Rect& tile);

}  // namespace zerkalo
