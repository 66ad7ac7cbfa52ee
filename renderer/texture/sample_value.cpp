#include "renderer/texture/sample_value.h"

#include "renderer/math/colour.h"

namespace candela {
namespace {

std::array<float, 256> decoded_bytes() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<float>(srgb_to_linear(static_cast<double>(i) / 255));
  return table;
}

}  // namespace

const std::array<float, 256> srgb_bytes = decoded_bytes();

}  // namespace candela
