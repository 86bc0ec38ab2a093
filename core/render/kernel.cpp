// Compiled once for each instruction set: ZERKALO_ISA names its namespace, ZERKALO_TABLE its table, ZERKALO_WIDTH its
// lanes.
#include "core/render/kernel.hpp"

#include "core/numeric/float_mode.hpp"
#include "core/render/general.hpp"
#include "core/render/one_bounce.hpp"

namespace zerkalo {

using R = Real<ZERKALO_WIDTH>;
// The general kernel keeps whole packets of rays on its stack: at 16 lanes they would not fit into 24 KB.
using G = Real<(ZERKALO_WIDTH < 8 ? ZERKALO_WIDTH : 8)>;

namespace {

template <TileFunction render_tile>
void in_ieee_mode(const Plan& plan, const Rect& tile, const LinearImage& image, RayCounts& counts) {
    const IeeeMode ieee;
    render_tile(plan, tile, image, counts);
}

}  // namespace

extern const KernelTable ZERKALO_TABLE;
const KernelTable ZERKALO_TABLE = {{&in_ieee_mode<&render_tile_one_bounce<R, Bounce::sharp>>,
                                    &in_ieee_mode<&render_tile_one_bounce<R, Bounce::lobe>>,
                                    &in_ieee_mode<&render_tile_one_bounce<R, Bounce::covered_lobe>>,
                                    &in_ieee_mode<&render_tile_general<G>>}};

}  // namespace zerkalo
