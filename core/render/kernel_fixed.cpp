// The kernels in fixed point: one lane of plain integers, or the lanes of an instruction set's vector registers.
#include "core/render/kernel.hpp"

#include "core/geometry/unrounded.hpp"
#include "core/geometry/vector_algebra.hpp"
#include "core/numeric/vector_elementary.hpp"
#include "core/render/fixed_bounce.hpp"
#if ZERKALO_WIDTH > 1
#include "core/numeric/float_mode.hpp"
#endif

namespace zerkalo {
namespace {

#if defined(ZERKALO_GENERAL_ALONE)
constexpr bool kGeneralAlone = true;
#else
constexpr bool kGeneralAlone = false;
#endif

#if ZERKALO_WIDTH > 1
using R = FixedNumbers<ZERKALO_WIDTH, Vectors>;

void in_ieee_mode(const FixedPlan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts) {
    const IeeeMode ieee;
    render_tile_fixed<R, kGeneralAlone>(plan, tile, image, counts);
}
constexpr FixedTileFunction kRenderTile = &in_ieee_mode;
#else
void render_tile(const FixedPlan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts) {
    render_tile_fixed<FixedNumbers<1>, kGeneralAlone>(plan, tile, image, counts);
}
constexpr FixedTileFunction kRenderTile = &render_tile;
#endif

}  // namespace

extern const FixedTileFunction ZERKALO_TABLE;
const FixedTileFunction ZERKALO_TABLE = kRenderTile;

}  // namespace zerkalo
