#include "renderer/texture/sample_value.h"

#include "renderer/math/colour.h"
#include "renderer/math/lanes_power.h"

namespace candela {
namespace {

template <class Decode>
std::array<float, 256> decoded_bytes(const Decode& decode) {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = decode(static_cast<int>(i));
  return table;
}

}  // namespace

const std::array<float, 256> srgb_bytes =
    decoded_bytes([](int byte) { return static_cast<float>(srgb_to_linear(byte / 255.0)); });
// By the same power as bilinear lookups, whose bits it has.
const std::array<float, 256> gamma_bytes = decoded_bytes(
    [](int byte) { return power_2_2(Float4{static_cast<float>(byte)} / unit<SampleType::U8>)[0]; });

}  // namespace candela
