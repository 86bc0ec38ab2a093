// Compiled once for each instruction set, like core/render/kernel.cpp: ZERKALO_PROBES names the unit's table.
#include "tests/core/probes/coverage_probes.hpp"
#include "tests/core/probes/lane_probes.hpp"
#include "tests/core/probes/optics_probes.hpp"
#include "tests/core/probes/shape_probes.hpp"

namespace zerkalo::inline ZERKALO_ISA {

template <int W>
constexpr probes::Probes probes_of_width() {
    return {W, lane_probes<Real<W>>(), shape_probes<Real<W>>(), optics_probes<Real<W>>(), coverage_probes<Real<W>>()};
}

}  // namespace zerkalo::inline ZERKALO_ISA

namespace zerkalo::probes {

extern const ProbePair ZERKALO_PROBES;
constexpr ProbePair ZERKALO_PROBES = {probes_of_width<1>(), probes_of_width<ZERKALO_WIDTH>()};

}  // namespace zerkalo::probes
