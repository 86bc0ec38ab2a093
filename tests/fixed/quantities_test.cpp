// Two quantities never mix, whether or not they have the same bits: lengths and curvatures, directions and weights.
#include "tests/fixed/fixed_values.hpp"
#include "tests/fixed/quantities.hpp"

#include <ostream>
#include <vector>

namespace zerkalo::test {

extern const QuantityTable kQuantities_sse4_2, kQuantities_avx2, kQuantities_avx512, kQuantities_neon;

namespace {

struct NamedTable {
    const char* lanes;
    QuantityTable table;
};
void PrintTo(const NamedTable& named, std::ostream* out) { *out << named.lanes; }

class Quantities : public testing::TestWithParam<NamedTable> {};

TEST_P(Quantities, AddCompareSelectAndAssignOnlyAmongThemselves) {
    const QuantityTable& table = GetParam().table;
    for (int i = 0; i < kQuantities; ++i) {
        EXPECT_TRUE(table.works[i]) << kQuantityNames[i] << " with itself";
        EXPECT_FALSE(table.with_plain[i]) << kQuantityNames[i] << " with float, double, int or long";
        for (int k = 0; k < kQuantities; ++k) {
            EXPECT_EQ(table.with[i] >> k & 1, i == k) << kQuantityNames[i] << " with " << kQuantityNames[k];
            EXPECT_EQ(table.with_uniform[i] >> k & 1, i == k)
                << kQuantityNames[i] << " with " << kQuantityNames[k] << " of all lanes";
        }
    }
}

std::vector<NamedTable> tables() {
    std::vector<NamedTable> all{{"1", quantity_table<FixedNumbers<1>>()},
                                {"4", quantity_table<FixedNumbers<4>>()},
                                {"8", quantity_table<FixedNumbers<8>>()}};
#if defined(ZERKALO_HAS_sse4_2)
    all.push_back({"sse4_2", kQuantities_sse4_2});
#endif
#if defined(ZERKALO_HAS_avx2)
    all.push_back({"avx2", kQuantities_avx2});
#endif
#if defined(ZERKALO_HAS_avx512)
    all.push_back({"avx512", kQuantities_avx512});
#endif
#if defined(ZERKALO_HAS_neon)
    all.push_back({"neon", kQuantities_neon});
#endif
    return all;
}
INSTANTIATE_TEST_SUITE_P(Lanes, Quantities, testing::ValuesIn(tables()), testing::PrintToStringParamName());

}  // namespace
}  // namespace zerkalo::test
