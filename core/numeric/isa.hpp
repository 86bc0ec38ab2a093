// Which instruction set this translation unit is compiled for.
//
// Everything that a kernel inlines lives in an inline namespace named after the instruction set, so that the linker can
// never merge a function compiled for AVX2 with its namesake for SSE2. Plain data (Scene, Plan, Vec3) lives outside.
#pragma once

#ifdef __FAST_MATH__
#error "zerkalo promises equal bits: -ffast-math breaks every one of them"
#endif

#ifndef ZERKALO_ISA
#define ZERKALO_ISA isa_baseline
#endif

// Forced inlining: structs of lanes passed to a function that is not inlined go through memory. Who compiles without
// optimisation, in a namespace of its own, may do without: there it only costs minutes.
#ifndef ZERKALO_INLINE
#define ZERKALO_INLINE inline __attribute__((always_inline))
#endif
#define ZERKALO_INLINE_LAMBDA __attribute__((always_inline))
// Once in a kernel: code that is too large to be repeated and not hot enough to need it.
#define ZERKALO_ONCE inline __attribute__((noinline))
