// Lanes in vector registers give one lane's integers, operation by operation: at the ends of the formats and at random.
#include "core/render/render.hpp"
#include "tests/fixed/vector_laws.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace zerkalo::test {

extern const VectorLaws kLaws_sse4_2, kLaws_avx2, kLaws_avx512, kLaws_avx512_general, kLaws_neon;

namespace {

struct NamedLaws {
    const char* lanes;
    Isa isa;
    VectorLaws laws;
};
void PrintTo(const NamedLaws& named, std::ostream* out) { *out << named.lanes; }

class VectorLanes : public testing::TestWithParam<NamedLaws> {};

TEST_P(VectorLanes, GiveTheIntegersOfOneLane) {
    if (!available(GetParam().isa)) GTEST_SKIP() << "this CPU lacks " << name_of(GetParam().isa);
    const VectorLaws& laws = GetParam().laws;
    for (int i = 0; i < laws.count; ++i) {
        const auto seed = static_cast<std::uint64_t>(i) * 7919 + 1;
        EXPECT_EQ(laws.laws[i].differing(seed, 20000), 0) << laws.laws[i].operation;
    }
}

std::vector<NamedLaws> all_laws() {
    std::vector<NamedLaws> all;
#if defined(ZERKALO_HAS_sse4_2)
    all.push_back({"sse4_2", Isa::sse4_2, kLaws_sse4_2});
#endif
#if defined(ZERKALO_HAS_avx2)
    all.push_back({"avx2", Isa::avx2, kLaws_avx2});
#endif
#if defined(ZERKALO_HAS_avx512)
    all.push_back({"avx512", Isa::avx512, kLaws_avx512});
    all.push_back({"avx512_general", Isa::avx512, kLaws_avx512_general});
#endif
#if defined(ZERKALO_HAS_neon)
    all.push_back({"neon", Isa::neon, kLaws_neon});
#endif
    return all;
}
INSTANTIATE_TEST_SUITE_P(Lanes, VectorLanes, testing::ValuesIn(all_laws()), testing::PrintToStringParamName());
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(VectorLanes);

}  // namespace
}  // namespace zerkalo::test
