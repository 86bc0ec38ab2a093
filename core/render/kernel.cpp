// Compiled once for each instruction set: ZERKALO_ISA names its namespace, ZERKALO_TABLE its table, ZERKALO_WIDTH its
// lanes.
#include "core/render/kernel.hpp"

#include "core/numeric/float_mode.hpp"
#include "core/render/general.hpp"
#include "core/render/one_bounce.hpp"

namespace zerkalo {

using R = Real<ZERKALO_WIDTH>;
// The general kernel keeps whole packets of rays on its stack, the others sums or outlines: at 16 lanes they would not fit
// into 24 KB.
using G = Real<(ZERKALO_WIDTH < 8 ? ZERKALO_WIDTH : 8)>;
template <Bounce bounce>
using LanesOf = std::conditional_t<bounce == Bounce::covered_lobe, G, R>;

namespace {

template <Bounce bounce>
void one_bounce(const Plan& plan, const Rect& tile, const LinearImage& image, RayCounts& counts) {
    const IeeeMode ieee;
    render_tile_one_bounce<LanesOf<bounce>, bounce>(plan, tile, image, counts);
}
void general(const Plan& plan, const Rect& tile, const LinearImage& image, RayCounts& counts) {
    const IeeeMode ieee;
    render_tile_general<G>(plan, tile, image, counts);
}

// The same with the spread; where no lobe is there is none.
void sharp_with_spread(const Plan& plan, const Rect& tile, const LinearImage& image, RayCounts& counts,
                       TileSpread& spread) {
    spread = {};
    one_bounce<Bounce::sharp>(plan, tile, image, counts);
}
template <Bounce bounce>
void lobe_with_spread(const Plan& plan, const Rect& tile, const LinearImage& image, RayCounts& counts,
                      TileSpread& spread) {
    const IeeeMode ieee;
    spread = {};
    render_tile_one_bounce<G, bounce, true>(plan, tile, image, counts, &spread);
}
void general_with_spread(const Plan& plan, const Rect& tile, const LinearImage& image, RayCounts& counts,
                         TileSpread& spread) {
    const IeeeMode ieee;
    spread = {};
    render_tile_general<G>(plan, tile, image, counts, &spread);
}

}  // namespace

extern const KernelTable ZERKALO_TABLE;
const KernelTable ZERKALO_TABLE = {
    {&one_bounce<Bounce::sharp>, &one_bounce<Bounce::lobe>, &one_bounce<Bounce::covered_lobe>, &general},
    {&sharp_with_spread, &lobe_with_spread<Bounce::lobe>, &lobe_with_spread<Bounce::covered_lobe>,
     &general_with_spread}};

}  // namespace zerkalo
