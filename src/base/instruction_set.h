// Macros that compile hot functions for several instruction sets; the widest that the machine has
// is chosen when the program starts.
//
// RESECT_WIDEST before a function's definition compiles it twice: for the build's baseline, and for
// x86-64-v3 (AVX2, popcnt). Both do the same operations in the same order, never contracted, so
// results are the same bits. Compilers without target_clones, and sanitizer builds, which cannot
// resolve them at load time, get the baseline only.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(RESECT_SANITIZED)
#define RESECT_WIDEST __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define RESECT_WIDEST
#endif

// RESECT_AVX2 before a function that uses AVX2 intrinsics and has a plain counterpart: the caller
// checks first that the processor has AVX2.
#if defined(__x86_64__)
#define RESECT_AVX2 __attribute__((target("avx2")))
#endif
