// What this processor and its system offer, asked of the processor itself: the compiler's own check needs its run-time.
// Source: Intel 64 and IA-32 Architectures Software Developer's Manual, volume 2A (CPUID) and volume 1, 13.3 (XGETBV).
#pragma once

#if defined(__x86_64__)

#include <cpuid.h>
#include <cstdint>

namespace zerkalo {

/// The bits that choose a kernel. Wide registers count only when the system saves them (XCR0).
struct CpuFeatures {
    bool sse4_2, avx2, avx512;
};

inline CpuFeatures cpu_features() {
    unsigned a = 0, b = 0, c = 0, d = 0;
    if (__get_cpuid(1, &a, &b, &c, &d) == 0) return {};
    const bool sse4_2 = (c & bit_SSE4_2) && (c & bit_POPCNT);
    if (!(c & bit_OSXSAVE)) return {sse4_2, false, false};

    std::uint32_t saved = 0, high = 0;
    asm volatile("xgetbv" : "=a"(saved), "=d"(high) : "c"(0));
    constexpr std::uint32_t kYmm = 0x06, kZmm = 0xe6;  // XMM and YMM; and the masks, ZMM 0-15, ZMM 16-31
    if (__get_cpuid_count(7, 0, &a, &b, &c, &d) == 0) return {sse4_2, false, false};
    constexpr unsigned kAvx512 = bit_AVX512F | bit_AVX512CD | bit_AVX512DQ | bit_AVX512BW | bit_AVX512VL;
    const bool avx2 = sse4_2 && (saved & kYmm) == kYmm && (b & bit_AVX2);
    return {sse4_2, avx2, avx2 && (saved & kZmm) == kZmm && (b & kAvx512) == kAvx512};
}

}  // namespace zerkalo

#endif
