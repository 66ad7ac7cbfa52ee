// Four floats side by side. GCC's and clang's vector types bring arithmetic, comparison and
// selection; the few operations that they lack are here.
#pragma once

#include <bit>
#include <cmath>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "renderer/math/vec.h"

namespace candela {

typedef float Float4 __attribute__((vector_size(16)));
typedef int Mask4 __attribute__((vector_size(16)));  // lanes 0 or -1

[[nodiscard]] inline Float4 broadcast(float x) {
  return Float4{x, x, x, x};
}

// Vectors of three as lanes; the fourth is 0. The same operations in the same order as GLM's, so
// that either way gives the same bits.
[[nodiscard]] inline Float4 to_lanes(const Vec3f& v) {
  return Float4{v.x, v.y, v.z, 0};
}
[[nodiscard]] inline Vec3f to_vec3(Float4 v) {
  return {v[0], v[1], v[2]};
}
[[nodiscard]] inline Float4 absolute(Float4 v) {
  constexpr int all_but_sign = 0x7fffffff;
  return reinterpret_cast<Float4>(reinterpret_cast<Mask4>(v) &
                                  Mask4{all_but_sign, all_but_sign, all_but_sign, all_but_sign});
}
[[nodiscard]] inline float dot3(Float4 a, Float4 b) {
  const Float4 product = a * b;
  return product[0] + product[1] + product[2];
}
[[nodiscard]] inline Float4 cross3(Float4 a, Float4 b) {
  const Float4 a_yzx = __builtin_shufflevector(a, a, 1, 2, 0, 3);
  const Float4 a_zxy = __builtin_shufflevector(a, a, 2, 0, 1, 3);
  const Float4 b_yzx = __builtin_shufflevector(b, b, 1, 2, 0, 3);
  const Float4 b_zxy = __builtin_shufflevector(b, b, 2, 0, 1, 3);
  return a_yzx * b_zxy - b_yzx * a_zxy;
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

// The same of plain vectors, for templates over both.
[[nodiscard]] inline Vec3f absolute(const Vec3f& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}
[[nodiscard]] inline float dot3(const Vec3f& a, const Vec3f& b) {
  return dot(a, b);
}
[[nodiscard]] inline Vec3f cross3(const Vec3f& a, const Vec3f& b) {
  return cross(a, b);
}
[[nodiscard]] inline Vec3f max(const Vec3f& a, const Vec3f& b) {
  return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}
[[nodiscard]] inline float largest3(Float4 v) {
  return std::max(std::max(v[0], v[1]), v[2]);
}
[[nodiscard]] inline float largest3(const Vec3f& v) {
  return std::max(std::max(v.x, v.y), v.z);
}

[[nodiscard]] inline Float4 square_root(Float4 v) {
#if defined(__SSE2__)
  return _mm_sqrt_ps(v);
#else
  return {std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
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
