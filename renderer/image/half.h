// 16-bit floats (IEEE 754 binary16) to 32 bits.
#pragma once

#include <bit>
#include <cstdint>

namespace candela {

// Exact. Goes by integers alone, since workers run with denormals flushed to zero, which the usual
// trick (one multiplication of a denormal float) does not survive.
[[nodiscard]] inline float half_to_float(std::uint16_t half) {
  const std::uint32_t sign = static_cast<std::uint32_t>(half & 0x8000u) << 16;
  const std::uint32_t exponent = (half >> 10) & 31u;
  const std::uint32_t mantissa = half & 0x3FFu;
  if (exponent == 0) {
    const float magnitude = static_cast<float>(mantissa) * 0x1p-24f;
    return sign != 0 ? -magnitude : magnitude;
  }
  const std::uint32_t wide = exponent == 31 ? 255u : exponent + 112u;
  return std::bit_cast<float>(sign | (wide << 23) | (mantissa << 13));
}

}  // namespace candela
