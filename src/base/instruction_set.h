// Macros that compile hot functions for several instruction sets.
//
// RESECT_WIDEST before a function's definition compiles the function twice: for the build's
// baseline, and for x86-64-v3 (AVX2, popcnt). When the program is loaded, one version is chosen:
// the version for x86-64-v3 if the processor can run it, otherwise the baseline. Both versions do
// the same operations in the same order, and never contract a multiplication and an addition into
// one operation. So their results have the same bits. Only the baseline is compiled for other
// processors, with compilers other than GCC, and in sanitizer builds, which cannot choose a version
// at load time.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(RESECT_SANITIZED)
#define RESECT_WIDEST __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define RESECT_WIDEST
#endif

// RESECT_AVX2 stands before a function that uses AVX2 intrinsics and has a plain counterpart. The
// caller must first check that the processor has AVX2.
#if defined(__x86_64__)
#define RESECT_AVX2 __attribute__((target("avx2")))
#endif
