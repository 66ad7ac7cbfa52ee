// x^2.2, the lab's gamma: of four floats at once in the inner loop of its textures, and of one, for
// loops over lanes. The same bits either way.
#pragma once

#include <bit>
#include <cstdint>

#include "renderer/math/float4.h"

namespace candela {

namespace lanes_power_detail {

using Int4 = std::int32_t __attribute__((vector_size(16)));

[[nodiscard]] inline Int4 bits_of(Float4 x) {
  return std::bit_cast<Int4>(x);
}
[[nodiscard]] inline std::int32_t bits_of(float x) {
  return std::bit_cast<std::int32_t>(x);
}
[[nodiscard]] inline Float4 of_bits(Int4 bits) {
  return std::bit_cast<Float4>(bits);
}
[[nodiscard]] inline float of_bits(std::int32_t bits) {
  return std::bit_cast<float>(bits);
}
[[nodiscard]] inline Float4 to_float(Int4 i) {
  return __builtin_convertvector(i, Float4);
}
[[nodiscard]] inline float to_float(std::int32_t i) {
  return static_cast<float>(i);
}
[[nodiscard]] inline Int4 to_int(Float4 x) {
  return __builtin_convertvector(x, Int4);
}
[[nodiscard]] inline std::int32_t to_int(float x) {
  return static_cast<std::int32_t>(x);
}
[[nodiscard]] inline Float4 bounded(Float4 x, float least, float most) {
  return max(min(x, broadcast(most)), broadcast(least));
}
[[nodiscard]] inline float bounded(float x, float least, float most) {
  const float below = x < most ? x : most;
  return below > least ? below : least;
}

}  // namespace lanes_power_detail

// The whole number nearest to |x| < 2^22: a sum with to_whole has no room for a fraction.
template <class Value>
[[nodiscard]] inline Value nearest_whole(Value x) {
  constexpr float to_whole = 0x1.8p23f;
  return (x + to_whole) - to_whole;
}

// Value: Float4, by lane, or float. For x < 2^56, relative error below 1e-6; 0 and 1 are exact.
// What is negative, NaN or below 2^-56 gives 0, what is larger the power of 2^56.
//
// With x = 2^e m and m in [sqrt(1/2), sqrt(2)): x^2.2 = 2^(2 e + q) 2^(r/5 + 2.2 log2 m), where
// e = 5 q + r with small r keeps the second exponent small. Series as in transcendental.h.
template <class Value>
[[nodiscard]] inline Value power_2_2(Value x) {
  using namespace lanes_power_detail;
  constexpr std::int32_t sqrt_half_bits = 0x3F3504F3;
  const auto bits = bits_of(bounded(x, 0x1p-56f, 0x1p56f));
  const auto exponent = (bits - sqrt_half_bits) >> 23;
  const Value m = of_bits(bits - (exponent << 23));
  const Value s = (m - 1.0f) / (m + 1.0f);
  const Value z = s * s;
  const Value series = 1.0f + z * (1 / 3.0f + z * (1 / 5.0f + z * (1 / 7.0f + z * (1 / 9.0f))));
  const Value logarithm = s * series * 6.34785818f;  // 2.2 * 2 / ln 2
  const Value e = to_float(exponent);
  const Value fifths = nearest_whole(e * 0.2f);
  const Value y = (e - 5.0f * fifths) * 0.2f + logarithm;
  const Value whole = nearest_whole(y);
  const Value t = (y - whole) * 0.693147181f;  // ln 2
  const Value upper = 1 / 24.0f + t * (1 / 120.0f + t * (1 / 720.0f));
  const Value mantissa = 1.0f + t * (1.0f + t * (0.5f + t * (1 / 6.0f + t * upper)));
  const auto power = exponent * 2 + to_int(fifths + whole);
  const Value result = mantissa * of_bits((power + 127) << 23);
  return x >= 0x1p-56f ? result : Value{};
}

}  // namespace candela
