// The general kernel in fixed point.
#include "core/render/general.hpp"
#include "core/render/kernel.hpp"

namespace zerkalo {

extern const FixedTileFunction ZERKALO_TABLE;
const FixedTileFunction ZERKALO_TABLE = &render_tile_general<FixedNumbers<1>>;

}  // namespace zerkalo
