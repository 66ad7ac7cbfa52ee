// Four 16-bit floats to 32 bits at once: in the inner loop of textures.
#pragma once

#include <bit>
#include <cstdint>

#include "renderer/math/float4.h"

namespace candela {

typedef std::uint16_t Half4 __attribute__((vector_size(8)));

// By lane the bits of half_to_float(), for finite values. Where denormals are flushed to zero, too:
// those of 16 bits have the exponent of 2^-14 here, with a leading 1 that is then subtracted.
[[nodiscard]] inline Float4 half_to_float(Half4 half) {
  using Bits = std::uint32_t __attribute__((vector_size(16)));
  const Bits bits = __builtin_convertvector(half, Bits);
  const Bits magnitude = (bits & 0x7FFFu) << 13;
  const auto normal = magnitude + (112u << 23);
  const auto denormal =
      std::bit_cast<Bits>(std::bit_cast<Float4>(magnitude + (113u << 23)) - 0x1p-14f);
  // Signed comparisons, which plain x86-64 has for lanes.
  const Mask4 is_normal = std::bit_cast<Mask4>(magnitude) >= (1 << 23);
  const Bits chosen = is_normal ? normal : denormal;
  return std::bit_cast<Float4>(chosen | (bits & 0x8000u) << 16);
}

}  // namespace candela
