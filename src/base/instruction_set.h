// Which hot functions are compiled for several instruction sets, the widest of which is chosen when
// the program starts?
//
// RESECT_WIDEST before a function's definition: once for what every machine of the build has, once
// for AVX2 and its contemporaries (population counts among them). The same operations in the same
// order, never contracted, so the results are the same bits. Compilers without such clones, and the
// sanitizers, which do not bear the choice at load time, get the first only.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(RESECT_SANITIZED)
#define RESECT_WIDEST __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define RESECT_WIDEST
#endif

// RESECT_AVX2 before a function that is written in AVX2's own operations, beside a plain one: who
// calls it asks first whether the processor has them.
#if defined(__x86_64__)
#define RESECT_AVX2 __attribute__((target("avx2")))
#endif
