// Transcendental functions by polynomials: the same bits on every processor and in every
// instantiation of a kernel, where libm's differ by processor and may be folded at compile time in
// one place and not in another: a specialised kernel gives the bits of the general one. Only +, -,
// *, / and std::sqrt, which IEEE 754 fixes.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace candela {

struct SinCos {
  float sin;
  float cos;
};

// Sine and cosine for |x| <= pi/4, absolute error below 6.5e-8: the minimax polynomials of Cephes'
// sinf and cosf [Moshier89].
[[nodiscard]] inline SinCos sin_cos_of_octant(float x) {
  const float z = x * x;
  return {
      ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f) * z * x + x,
      ((2.443315711809948e-5f * z - 1.388731625493765e-3f) * z + 4.166664568298827e-2f) * z * z -
          0.5f * z + 1.0f};
}

// Exchanges two floats where `condition` holds, without a branch: for conditions that random
// numbers decide.
inline void swap_if(bool condition, float& a, float& b) {
  const auto a_bits = std::bit_cast<std::uint32_t>(a);
  const auto b_bits = std::bit_cast<std::uint32_t>(b);
  const std::uint32_t change = (a_bits ^ b_bits) & (0u - static_cast<std::uint32_t>(condition));
  a = std::bit_cast<float>(a_bits ^ change);
  b = std::bit_cast<float>(b_bits ^ change);
}

// Sine and cosine of quadrant * pi/2 + x, |x| <= pi/4, without branches.
[[nodiscard]] inline SinCos sin_cos_of_quadrant(std::uint32_t quadrant, float x) {
  SinCos result = sin_cos_of_octant(x);
  swap_if((quadrant & 1) != 0, result.sin, result.cos);
  const std::uint32_t sine_sign = (quadrant & 2) << 30;
  const std::uint32_t cosine_sign = ((quadrant + 1) & 2) << 30;
  return {std::bit_cast<float>(std::bit_cast<std::uint32_t>(result.sin) ^ sine_sign),
          std::bit_cast<float>(std::bit_cast<std::uint32_t>(result.cos) ^ cosine_sign)};
}

// Sine and cosine for |x| <= 1e4, absolute error below 1.2e-7. Reduction to [-pi/4, pi/4] in
// double.
[[nodiscard]] inline SinCos sin_cos(float x) {
  const double turns = static_cast<double>(x) * 0.63661977236758134308;  // 2 / pi
  const auto quadrant = static_cast<std::int64_t>(turns + (turns < 0 ? -0.5 : 0.5));
  const auto r =
      static_cast<float>((turns - static_cast<double>(quadrant)) * 1.57079632679489661923);
  return sin_cos_of_quadrant(static_cast<std::uint32_t>(quadrant), r);
}

// Sine and cosine of 2 pi u for u in [0, 1], absolute error below 1.2e-7. The reduction to an
// octant is exact. (Comparisons in place of a conversion, which would keep loops that call this
// from becoming vector code.)
[[nodiscard]] inline SinCos sin_cos_of_turns(float u) {
  const float quarters = 4 * u + 0.5f;
  const int quadrant =
      int{quarters >= 1} + int{quarters >= 2} + int{quarters >= 3} + int{quarters >= 4};
  const float r = u - 0.25f * static_cast<float>(quadrant);
  return sin_cos_of_quadrant(static_cast<std::uint32_t>(quadrant), r * 6.28318530717958647693f);
}

// The arc tangent of x in [0, 1], relative error below 2e-7: reduction to |x| <= tan(pi/8), then
// the minimax polynomial of Cephes' atanf [Moshier89].
[[nodiscard]] inline float arc_tangent_of_unit(float x) {
  const bool is_reduced = x > 0.4142135623730950f;
  const float r = is_reduced ? (x - 1) / (x + 1) : x;
  const float z = r * r;
  const float polynomial =
      ((8.05374449538e-2f * z - 1.38776856032e-1f) * z + 1.99777106478e-1f) * z - 3.33329491539e-1f;
  const float angle = polynomial * z * r + r;
  return is_reduced ? 0.78539816339744830962f + angle : angle;
}

// The angle of the finite point (x, y) in [-pi, pi], as atan2(y, x) gives it; (0, 0) gives +-0 or
// +-pi by the signs. Relative error below 4e-7.
[[nodiscard]] inline float arc_tangent(float y, float x) {
  const float a = std::abs(y);
  const float b = std::abs(x);
  // The smaller over the larger neither overflows nor divides by zero.
  const float larger = std::max(a, b);
  const float octant = larger > 0 ? arc_tangent_of_unit(std::min(a, b) / larger) : 0.0f;
  const float quadrant = a > b ? 1.57079632679489661923f - octant : octant;
  const float angle = std::signbit(x) ? 3.14159265358979323846f - quadrant : quadrant;
  return std::copysign(angle, y);
}

// The logarithm to base 2 of a normal x > 0, absolute error below 1e-10: x = 2^e m with m in
// [sqrt(1/2), sqrt(2)), then log m = 2 artanh((m - 1) / (m + 1)) by its series.
[[nodiscard]] inline double binary_logarithm(double x) {
  constexpr std::uint64_t sqrt_half_bits = 0x3FE6A09E667F3BCDu;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto exponent = static_cast<std::int64_t>(bits - sqrt_half_bits) >> 52;
  const auto m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(exponent) << 52));
  const double s = (m - 1) / (m + 1);
  const double z = s * s;
  const double series =
      1 + z * (1.0 / 3 + z * (1.0 / 5 + z * (1.0 / 7 + z * (1.0 / 9 + z * (1.0 / 11)))));
  return static_cast<double>(exponent) + s * series * 2.88539008177792681472;  // 2 / ln 2
}

// 2^x for |x| < 1000, relative error below 1e-9: 2^x = 2^k e^t with |t| <= ln(2) / 2 by its series.
[[nodiscard]] inline double binary_exponential(double x) {
  const auto k = static_cast<std::int64_t>(x + (x < 0 ? -0.5 : 0.5));
  const double t = (x - static_cast<double>(k)) * 0.693147180559945309417;  // ln 2
  const double upper =
      1.0 / 24 + t * (1.0 / 120 + t * (1.0 / 720 + t * (1.0 / 5040 + t * (1.0 / 40320))));
  const double series = 1 + t * (1 + t * (1.0 / 2 + t * (1.0 / 6 + t * upper)));
  return series * std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

// e^-x for x >= 0, relative error below 1e-7; 0 where that is below the normal floats.
[[nodiscard]] inline float decay(float x) {
  const double binary = double{x} * -1.44269504088896340736;  // 1 / ln 2
  if (!(binary > -126)) return 0;
  return static_cast<float>(binary_exponential(binary));
}

// base^exponent for a finite base and an exponent above 0, relative error below 1e-7; 1 stays 1.
// Negative bases and NaN count as 0. Results beyond the normal floats are infinity or 0, so that
// flushing of denormals changes nothing.
[[nodiscard]] inline float power(float base, double exponent) {
  if (!(base > 0)) return 0;
  const double binary = exponent * binary_logarithm(static_cast<double>(base));
  if (binary < -126) return 0;
  if (binary >= 128) return std::numeric_limits<float>::infinity();
  return static_cast<float>(binary_exponential(binary));
}

}  // namespace candela
