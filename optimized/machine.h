/// @file Functions compiled for several machines; the one that runs is chosen when the program starts.
#pragma once

/// Wider registers where the machine has them. Nothing is contracted: each gives the same bits.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define TYPE21_FOR_EACH_MACHINE __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define TYPE21_FOR_EACH_MACHINE
#endif
#define TYPE21_INLINE inline __attribute__((always_inline))
