// What of the quantities in an instruction set's vector registers mixes. Data alone: any processor may read it.
#include "core/geometry/vector_algebra.hpp"
#include "tests/fixed/quantities.hpp"

namespace zerkalo::test {

extern const QuantityTable ZERKALO_QUANTITIES;
constinit const QuantityTable ZERKALO_QUANTITIES = quantity_table<FixedNumbers<ZERKALO_WIDTH, Vectors>>();

}  // namespace zerkalo::test
