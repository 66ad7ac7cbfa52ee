// Transcendental functions by polynomials: the same bits on every processor and in every
// instantiation of a kernel, where libm's differ by processor and may be folded at compile time in
// one place and not in another (invariant 2). Only +, -, *, / and std::sqrt, which IEEE 754 fixes.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace candela {

struct SinCos {
  float sin;
  float cos;
};

// Sine and cosine for |x| <= 1e4, absolute error below 1.2e-7. Reduction to [-pi/4, pi/4] in
// double, then the minimax polynomials of Cephes' sinf and cosf [Moshier89].
[[nodiscard]] inline SinCos sin_cos(float x) {
  const double turns = static_cast<double>(x) * 0.63661977236758134308;  // 2 / pi
  const auto quadrant = static_cast<std::int64_t>(turns + (turns < 0 ? -0.5 : 0.5));
  const auto r =
      static_cast<float>((turns - static_cast<double>(quadrant)) * 1.57079632679489661923);
  const float z = r * r;
  const float s = ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f) * z * r + r;
  const float c =
      ((2.443315711809948e-5f * z - 1.388731625493765e-3f) * z + 4.166664568298827e-2f) * z * z -
      0.5f * z + 1.0f;
  const bool is_swapped = (quadrant & 1) != 0;
  const float sine = is_swapped ? c : s;
  const float cosine = is_swapped ? s : c;
  return {(quadrant & 2) != 0 ? -sine : sine, ((quadrant + 1) & 2) != 0 ? -cosine : cosine};
}

}  // namespace candela
