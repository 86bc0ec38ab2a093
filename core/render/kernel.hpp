// The kernels of one instruction set, smallest first. Each covers what the ones before it cover, and more.
#pragma once

#include "core/render/render.hpp"

namespace zerkalo {

enum KernelKind : int { kKernelSharp, kKernelGlossy, kKernelCovered, kKernelGeneral, kKernelKinds };

struct KernelTable {
    TileFunction kernels[kKernelKinds];
    SpreadFunction spread_kernels[kKernelKinds];
};

// The kernel of every scene in fixed point, one for each translation unit of kernel_fixed.cpp. AVX-512 has two: 16
// lanes for at most one bounce, and 8 for scenes that need the general kernel, whose packets must fit into 24 KB.
extern const FixedTileFunction kFixedKernel_scalar, kFixedKernel_sse4_2, kFixedKernel_avx2, kFixedKernel_avx512,
    kFixedKernel_avx512_general, kFixedKernel_neon;

// One for each translation unit of kernel.cpp; those that this program was built without do not exist.
extern const KernelTable kKernels_scalar, kKernels_sse2, kKernels_sse4_2, kKernels_avx2, kKernels_avx512, kKernels_neon;

}  // namespace zerkalo
