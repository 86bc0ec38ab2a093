#include "core/render/cpu.hpp"
#include "core/render/kernel.hpp"

#include <initializer_list>

namespace zerkalo {
namespace {

struct IsaRow {
    const char* name;
    int lanes;
    const KernelTable* table = nullptr;  // null where this build has no kernel of it
    int fixed_lanes = 1;
    const FixedTileFunction* fixed = nullptr;  // null where the kernel of one lane serves
    const FixedTileFunction* fixed_general = nullptr;
};

// ZERKALO_HAS_...: what CMakeLists.txt has built.
constexpr IsaRow kRows[kIsaCount] = {
    {"scalar", 1, &kKernels_scalar, 1, &kFixedKernel_scalar, &kFixedKernel_scalar},
#if defined(ZERKALO_HAS_sse2)
    {"sse2", 4, &kKernels_sse2},
#else
    {"sse2", 4},
#endif
#if defined(ZERKALO_HAS_sse4_2)
    {"sse4.2", 4, &kKernels_sse4_2, 4, &kFixedKernel_sse4_2, &kFixedKernel_sse4_2},
#else
    {"sse4.2", 4},
#endif
#if defined(ZERKALO_HAS_avx2)
    {"avx2", 8, &kKernels_avx2, 8, &kFixedKernel_avx2, &kFixedKernel_avx2},
#else
    {"avx2", 8},
#endif
#if defined(ZERKALO_HAS_avx512)
    {"avx512", 16, &kKernels_avx512, 16, &kFixedKernel_avx512, &kFixedKernel_avx512_general},
#else
    {"avx512", 16},
#endif
#if defined(ZERKALO_HAS_neon)
    {"neon", 4, &kKernels_neon, 4, &kFixedKernel_neon, &kFixedKernel_neon}};
#else
    {"neon", 4}};
#endif

const IsaRow& row_of(Isa isa) { return kRows[static_cast<int>(isa)]; }

struct FeatureName {
    std::uint32_t bit;
    const char* name;
};
constexpr FeatureName kFeatureNames[] = {
    {kFeatureSphere, "sphere"},
    {kFeatureHalfSpaces, "half_spaces"},
    {kFeatureTube, "tube"},
    {kFeatureMesh, "mesh"},
    {kFeatureMirror, "mirror"},
    {kFeatureGlossy, "glossy"},
    {kFeatureMaxPhong, "max_phong"},
    {kFeatureGgx, "ggx"},
    {kFeatureCurved, "curved_mirror"},
    {kFeatureChain, "chain"},
    {kFeatureBranch, "branch"},
    {kFeatureFresnel, "fresnel"},
    {kFeatureShadow, "shadow"},
    {kFeatureFalloff, "inverse_square"},
    {kFeatureFar, "far"},
    {kFeatureInside, "inside"},
    {kFeatureAntialias, "antialias"},
    {kFeatureFlush, "flush"},
    {kFeatureCoverage, "coverage"},
};

KernelKind kind_of(const Plan& plan) {
    if (plan.features & kNeedsGeneral) return kKernelGeneral;
    if (plan.features & kFeatureCoverage) return kKernelCovered;
    return plan.features & kFeatureGlossy ? kKernelGlossy : kKernelSharp;
}

std::int32_t tiles_across(const PlanHead& plan) { return (plan.width + kTileSide - 1) / kTileSide; }
std::int32_t tiles_down(const PlanHead& plan) { return (plan.height + kTileSide - 1) / kTileSide; }

}  // namespace

const char* name_of(Isa isa) { return row_of(isa).name; }

int lanes_of(Isa isa) { return row_of(isa).lanes; }

Isa fixed_isa_of(Isa isa) { return row_of(isa).fixed != nullptr ? isa : Isa::scalar; }

int fixed_lanes_of(Isa isa) { return row_of(isa).fixed_lanes; }

bool available(Isa isa) {
    if (row_of(isa).table == nullptr) return false;
#if defined(__x86_64__)
    const CpuFeatures cpu = cpu_features();
    switch (isa) {
        case Isa::sse4_2: return cpu.sse4_2;
        case Isa::avx2: return cpu.avx2;
        case Isa::avx512: return cpu.avx512;
        default: break;
    }
#endif
    return true;
}

Isa best_isa() {
    for (const Isa isa : {Isa::avx512, Isa::avx2, Isa::sse4_2, Isa::sse2, Isa::neon}) {
        if (available(isa)) return isa;
    }
    return Isa::scalar;
}

TileFunction kernel_for(const Plan& plan, Isa isa) { return row_of(isa).table->kernels[kind_of(plan)]; }

SpreadFunction spread_kernel_for(const Plan& plan, Isa isa) {
    return row_of(isa).table->spread_kernels[kind_of(plan)];
}

FixedTileFunction kernel_for(const FixedPlan& plan, Isa isa) {
    const IsaRow& row = row_of(fixed_isa_of(isa));
    return plan.features & kNeedsGeneral ? *row.fixed_general : *row.fixed;
}

int tile_count(const PlanHead& plan) { return tiles_across(plan) * tiles_down(plan); }

Rect tile_at(const PlanHead& plan, int index) {
    const std::int32_t left = index % tiles_across(plan) * kTileSide;
    const std::int32_t top = index / tiles_across(plan) * kTileSide;
    const std::int32_t width = plan.width - left, height = plan.height - top;
    return {left, top, width < kTileSide ? width : kTileSide, height < kTileSide ? height : kTileSide};
}

int feature_names(const PlanHead& plan, const char** names, int capacity) {
    int count = 0;
    for (const FeatureName& feature : kFeatureNames) {
        if ((plan.features & feature.bit) && count < capacity) names[count++] = feature.name;
    }
    return count;
}

}  // namespace zerkalo
