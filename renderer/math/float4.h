// Four floats side by side. GCC's and clang's vector types bring arithmetic, comparison and
// selection; the few operations that they lack are here.
#pragma once

#include <bit>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace candela {

typedef float Float4 __attribute__((vector_size(16)));
typedef int Mask4 __attribute__((vector_size(16)));  // lanes 0 or -1

[[nodiscard]] inline Float4 broadcast(float x) {
  return Float4{x, x, x, x};
}

// At addresses that are multiples of 16.
[[nodiscard]] inline Float4 load_aligned(const float* address) {
  return *reinterpret_cast<const Float4*>(address);
}
inline void store_aligned(float* address, Float4 v) {
  *reinterpret_cast<Float4*>(address) = v;
}

// The second operand where either is NaN, as SSE's instructions have it.
[[nodiscard]] inline Float4 min(Float4 a, Float4 b) {
#if defined(__SSE2__)
  return _mm_min_ps(a, b);
#else
  return a < b ? a : b;
#endif
}
[[nodiscard]] inline Float4 max(Float4 a, Float4 b) {
#if defined(__SSE2__)
  return _mm_max_ps(a, b);
#else
  return a > b ? a : b;
#endif
}

// Bit i is set where lane i is true.
[[nodiscard]] inline int mask_of(Mask4 lanes) {
#if defined(__SSE2__)
  return _mm_movemask_ps(reinterpret_cast<Float4>(lanes));
#else
  return (lanes[0] & 1) | (lanes[1] & 2) | (lanes[2] & 4) | (lanes[3] & 8);
#endif
}

// For walking a mask: for (; mask != 0; mask &= mask - 1) ... lowest_lane(mask) ...
[[nodiscard]] inline int lowest_lane(int mask) {
  return std::countr_zero(static_cast<unsigned>(mask));
}

}  // namespace candela
