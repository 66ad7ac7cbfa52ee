// x^2.2 of four floats at once: the lab's gamma, in the inner loop of its textures.
#pragma once

#include <bit>
#include <cstdint>

#include "renderer/math/float4.h"

namespace candela {

// The whole number nearest to |x| < 2^22: a sum with to_whole has no room for a fraction.
[[nodiscard]] inline Float4 nearest_whole(Float4 x) {
  constexpr float to_whole = 0x1.8p23f;
  return (x + to_whole) - to_whole;
}

// By lane for x < 2^56, relative error below 1e-6; 0 and 1 are exact. What is negative, NaN or
// below 2^-56 gives 0, what is larger the power of 2^56.
//
// With x = 2^e m and m in [sqrt(1/2), sqrt(2)): x^2.2 = 2^(2 e + q) 2^(r/5 + 2.2 log2 m), where
// e = 5 q + r with small r keeps the second exponent small. Series as in transcendental.h.
[[nodiscard]] inline Float4 power_2_2(Float4 x) {
  using Bits = std::int32_t __attribute__((vector_size(16)));
  constexpr std::int32_t sqrt_half_bits = 0x3F3504F3;
  const Float4 bounded = max(min(x, broadcast(0x1p56f)), broadcast(0x1p-56f));
  const auto bits = std::bit_cast<Bits>(bounded);
  const Bits exponent = (bits - sqrt_half_bits) >> 23;
  const auto m = std::bit_cast<Float4>(bits - (exponent << 23));
  const Float4 s = (m - 1.0f) / (m + 1.0f);
  const Float4 z = s * s;
  const Float4 series = 1.0f + z * (1 / 3.0f + z * (1 / 5.0f + z * (1 / 7.0f + z * (1 / 9.0f))));
  const Float4 logarithm = s * series * 6.34785818f;  // 2.2 * 2 / ln 2
  const Float4 e = __builtin_convertvector(exponent, Float4);
  const Float4 fifths = nearest_whole(e * 0.2f);
  const Float4 y = (e - 5.0f * fifths) * 0.2f + logarithm;
  const Float4 whole = nearest_whole(y);
  const Float4 t = (y - whole) * 0.693147181f;  // ln 2
  const Float4 upper = 1 / 24.0f + t * (1 / 120.0f + t * (1 / 720.0f));
  const Float4 mantissa = 1.0f + t * (1.0f + t * (0.5f + t * (1 / 6.0f + t * upper)));
  const Bits power = exponent * 2 + __builtin_convertvector(fifths + whole, Bits);
  const Float4 result = mantissa * std::bit_cast<Float4>((power + 127) << 23);
  return x >= 0x1p-56f ? result : Float4{};
}

}  // namespace candela
