// The kernels in fixed point: one lane of plain integers, or the lanes of an instruction set's vector registers.
#include "core/render/kernel.hpp"

#include "core/geometry/vector_algebra.hpp"
#include "core/render/fixed_bounce.hpp"
#include "core/render/general.hpp"
#if ZERKALO_WIDTH > 1
#include "core/numeric/float_mode.hpp"
#endif

namespace zerkalo {
namespace {

template <class R>
ZERKALO_INLINE void render(const FixedPlan& plan, const Rect& tile, const LinearImage& image, RayCounts& counts) {
    if (plan.features & kNeedsGeneral) {
        render_tile_general<R>(plan, tile, image, counts);
    } else {
        render_tile_one_bounce_fixed<R>(plan, tile, image, counts);
    }
}

#if ZERKALO_WIDTH > 1
using R = FixedNumbers<ZERKALO_WIDTH, Vectors>;

void in_ieee_mode(const FixedPlan& plan, const Rect& tile, const LinearImage& image, RayCounts& counts) {
    const IeeeMode ieee;
    render<R>(plan, tile, image, counts);
}
constexpr FixedTileFunction kRenderTile = &in_ieee_mode;
#else
void render_tile(const FixedPlan& plan, const Rect& tile, const LinearImage& image, RayCounts& counts) {
    render<FixedNumbers<1>>(plan, tile, image, counts);
}
constexpr FixedTileFunction kRenderTile = &render_tile;
#endif

}  // namespace

extern const FixedTileFunction ZERKALO_TABLE;
const FixedTileFunction ZERKALO_TABLE = kRenderTile;

}  // namespace zerkalo
