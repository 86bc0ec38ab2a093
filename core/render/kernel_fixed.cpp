// The general kernel in fixed point: one lane of plain integers, or the lanes of an instruction set's vector registers.
#include "core/geometry/vector_algebra.hpp"
#include "core/render/general.hpp"
#include "core/render/kernel.hpp"

namespace zerkalo {

#if ZERKALO_WIDTH == 1
using R = FixedNumbers<1>;
#else
using R = FixedNumbers<ZERKALO_WIDTH, Vectors>;
#endif

extern const FixedTileFunction ZERKALO_TABLE;
const FixedTileFunction ZERKALO_TABLE = &render_tile_general<R>;

}  // namespace zerkalo
