// What the lane library does not offer, or not with the same answer everywhere, in the processors' own registers.
//
// The smaller and the larger of two registers of floats, lane by lane: a < b ? a : b and a > b ? a : b.
// So b where either is NaN and where both are zeros. The x86 instructions say exactly this, with operands in this
// order; the lane library turned its order round in version 14, and NEON's own minimum says something else.
#pragma once

#include "core/numeric/isa.hpp"

#include <cstdint>

#if defined(__aarch64__)
#include <arm_neon.h>
#elif defined(__SSE2__)
#include <immintrin.h>
#endif

namespace zerkalo::inline ZERKALO_ISA {

#if defined(__aarch64__)
ZERKALO_INLINE float32x4_t native_min(float32x4_t a, float32x4_t b) { return vbslq_f32(vcltq_f32(a, b), a, b); }
ZERKALO_INLINE float32x4_t native_max(float32x4_t a, float32x4_t b) { return vbslq_f32(vcgtq_f32(a, b), a, b); }
#endif
#if defined(__SSE2__)
ZERKALO_INLINE __m128 native_min(__m128 a, __m128 b) { return _mm_min_ps(a, b); }
ZERKALO_INLINE __m128 native_max(__m128 a, __m128 b) { return _mm_max_ps(a, b); }
#endif
#if defined(__AVX2__)
ZERKALO_INLINE __m256 native_min(__m256 a, __m256 b) { return _mm256_min_ps(a, b); }
ZERKALO_INLINE __m256 native_max(__m256 a, __m256 b) { return _mm256_max_ps(a, b); }
ZERKALO_INLINE __m256 native_pick(__m256 table, __m256 index) {
    return _mm256_permutevar8x32_ps(table, _mm256_cvttps_epi32(index));
}
/// source[index[k]] for the eight lanes k.
ZERKALO_INLINE __m256 native_gather_8(const float* source, const std::uint8_t* index) {
    return _mm256_i32gather_ps(source, _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(index))), 4);
}
#endif
#if defined(__AVX512F__)
// With a full mask: GCC 12 warns about the plain form in its own header (bug 105593). The instruction is the same.
ZERKALO_INLINE __m512 native_min(__m512 a, __m512 b) { return _mm512_maskz_min_ps(0xffff, a, b); }
ZERKALO_INLINE __m512 native_max(__m512 a, __m512 b) { return _mm512_maskz_max_ps(0xffff, a, b); }
ZERKALO_INLINE __m512 native_pick(__m512 table, __m512 index) {
    return _mm512_maskz_permutexvar_ps(0xffff, _mm512_maskz_cvttps_epi32(0xffff, index), table);
}
/// source[index[k]] for the sixteen lanes k.
ZERKALO_INLINE __m512 native_gather_16(const float* source, const std::uint8_t* index) {
    const __m512i lanes = _mm512_maskz_cvtepu8_epi32(0xffff, _mm_loadu_si128(reinterpret_cast<const __m128i*>(index)));
    return _mm512_mask_i32gather_ps(_mm512_setzero_ps(), 0xffff, lanes, source, 4);
}
#endif

}  // namespace zerkalo::inline ZERKALO_ISA
