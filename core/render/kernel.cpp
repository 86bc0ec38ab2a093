// Compiled once for each instruction set: ZERKALO_ISA names its namespace, ZERKALO_TABLE its table, ZERKALO_WIDTH its
// lanes.
#include "core/render/kernel.hpp"

#include "core/numeric/float_mode.hpp"
#include "core/render/general.hpp"
#include "core/render/one_bounce.hpp"

namespace zerkalo {

using R = Real<ZERKALO_WIDTH>;
// The general kernel keeps whole packets of rays on its stack, aided lobe rays what is known before them: at 16 lanes they
// would not fit into 24 KB.
using G = Real<(ZERKALO_WIDTH < 8 ? ZERKALO_WIDTH : 8)>;

namespace {

void sharp(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts) {
    const IeeeMode ieee;
    render_tile_sharp<R>(plan, tile, image, counts);
}
void lobe(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts) {
    const IeeeMode ieee;
    render_tile_lobe<R>(plan, tile, image, counts);
}
void covered(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts) {
    const IeeeMode ieee;
    render_tile_aided<R, G>(plan, tile, image, counts, nullptr);
}
void general(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts) {
    const IeeeMode ieee;
    render_tile_general<G>(plan, tile, image, counts);
}

// The same with the spread; where no lobe is there is none.
void sharp_with_spread(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts,
                       TileSpread& spread) {
    clear(spread);
    sharp(plan, tile, image, counts);
}
void lobe_with_spread(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts,
                      TileSpread& spread) {
    const IeeeMode ieee;
    clear(spread);
    render_tile_telling<R>(plan, tile, image, counts, spread);
}
void covered_with_spread(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts,
                         TileSpread& spread) {
    const IeeeMode ieee;
    clear(spread);
    render_tile_aided<R, G>(plan, tile, image, counts, &spread);
}
void general_with_spread(const Plan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts,
                         TileSpread& spread) {
    const IeeeMode ieee;
    clear(spread);
    render_tile_general<G>(plan, tile, image, counts, &spread);
}

}  // namespace

extern const KernelTable ZERKALO_TABLE;
const KernelTable ZERKALO_TABLE = {
    {&sharp, &lobe, &covered, &general},
    {&sharp_with_spread, &lobe_with_spread, &covered_with_spread, &general_with_spread}};

}  // namespace zerkalo
