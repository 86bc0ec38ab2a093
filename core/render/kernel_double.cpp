// The general kernel in double, one lane: the same for every instruction set. It has no place in a table, so that a
// program without double does not link it.
#include "core/numeric/float_mode.hpp"
#include "core/render/general.hpp"

namespace zerkalo {
namespace {

void render_tile_in_double(const DoublePlan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts) {
    const IeeeMode ieee;
    render_tile_general<double>(plan, tile, image, counts);
}

}  // namespace

DoubleTileFunction kernel_for(const DoublePlan&, Isa) { return &render_tile_in_double; }

}  // namespace zerkalo
