// Functions that are loops over lanes are compiled once for each width of vectors; the processor's
// is chosen when the program starts. Without contraction to fma, which is off everywhere, all of
// them give the same bits.
#pragma once

// Sanitizers would instrument the choice itself, which runs before they are set up.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !defined(__clang__)
#define CANDELA_EACH_VECTOR_WIDTH \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define CANDELA_EACH_VECTOR_WIDTH
#endif

// A loop becomes vector code only as a whole, with all that it calls.
#define CANDELA_LANES CANDELA_EACH_VECTOR_WIDTH [[gnu::flatten]]
