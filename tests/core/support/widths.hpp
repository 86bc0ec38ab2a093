// The list of instruction sets and widths over which the lane tests run, and the scalar one they are compared with.
#pragma once

#include "core/render/render.hpp"
#include "tests/core/probes/probes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace zerkalo::test {

struct Width {
    Isa isa;
    const probes::Probes* probes;
};

inline std::string text(const Width& width) {
    std::string isa = name_of(width.isa);
    for (char& c : isa) c = c == '.' ? '_' : c;
    return isa + "_" + std::to_string(width.probes->width) + "_lanes";
}
/// How GoogleTest prints the parameter.
inline void PrintTo(const Width& width, std::ostream* out) { *out << text(width); }

inline std::vector<Width> all_widths() {
    using namespace probes;
    std::vector<Width> widths{{Isa::scalar, &kProbes_scalar.wide}};
    [[maybe_unused]] const auto add = [&](Isa isa, const ProbePair& of) {
        widths.push_back({isa, &of.serial});
        widths.push_back({isa, &of.wide});
    };
#if defined(ZERKALO_HAS_sse2)
    add(Isa::sse2, kProbes_sse2);
#endif
#if defined(ZERKALO_HAS_sse4_2)
    add(Isa::sse4_2, kProbes_sse4_2);
#endif
#if defined(ZERKALO_HAS_avx2)
    add(Isa::avx2, kProbes_avx2);
#endif
#if defined(ZERKALO_HAS_avx512)
    add(Isa::avx512, kProbes_avx512);
#endif
#if defined(ZERKALO_HAS_neon)
    add(Isa::neon, kProbes_neon);
#endif
    return widths;
}

/// A law over all widths. Where the CPU lacks the instruction set, the test is skipped and says so.
class Widths : public testing::TestWithParam<Width> {
protected:
    void SetUp() override {
        if (!available(GetParam().isa)) GTEST_SKIP() << "this CPU lacks " << name_of(GetParam().isa);
    }
    static const probes::LaneProbes& lanes() { return GetParam().probes->lanes; }
    static const probes::ShapeProbes& shapes() { return GetParam().probes->shapes; }
    static const probes::OpticsProbes& optics() { return GetParam().probes->optics; }
    static const probes::CoverageProbes& coverage() { return GetParam().probes->coverage; }
    static int width() { return GetParam().probes->width; }
    static const probes::Probes& scalar() { return probes::kProbes_scalar.wide; }
};

#define ZERKALO_OVER_ALL_WIDTHS(suite)                                    \
    INSTANTIATE_TEST_SUITE_P(All, suite, testing::ValuesIn(all_widths()), \
                             [](const testing::TestParamInfo<Width>& info) { return text(info.param); })

using Floats = std::vector<float>;

inline std::uint32_t bits_of_float(float x) { return std::bit_cast<std::uint32_t>(x); }

/// Bit patterns, for comparing whole arrays and for printing the place where they differ.
inline void expect_same_bits(const Floats& got, const Floats& wanted, const char* what) {
    ASSERT_EQ(got.size(), wanted.size());
    for (std::size_t k = 0; k < got.size(); ++k) {
        ASSERT_EQ(bits_of_float(got[k]), bits_of_float(wanted[k]))
            << what << " at element " << k << ": " << got[k] << " instead of " << wanted[k];
    }
}

}  // namespace zerkalo::test
