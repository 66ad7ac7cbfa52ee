// The luminance of an environment's texels, filtered and gathered into the cells that sampling
// uses.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/texture/texture.h"

namespace candela {

// Decoded, row 0 at the file's top.
struct LuminanceMap {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<float> values;
  std::uint64_t invalid_count = 0;  // texels that are not finite or below 0 in a channel

  [[nodiscard]] float at(std::uint32_t x, std::uint32_t y) const {
    return values[std::size_t{y} * width + x];
  }
};

[[nodiscard]] LuminanceMap decode_luminance(const TextureStore& textures, TextureHandle texture);

// The mean over each texel's square of the bilinear interpolation between texel centres: positive
// wherever any point of the square is. Columns wrap or are clamped; rows are clamped.
[[nodiscard]] LuminanceMap bilinear_means(const LuminanceMap& map, bool columns_wrap);

// The mean over the texels that cell (column, row) of a columns x rows grid touches: positive
// wherever one of them is.
[[nodiscard]] double cell_mean(const LuminanceMap& map, std::uint32_t column, std::uint32_t row,
                               std::uint32_t columns, std::uint32_t rows);

}  // namespace candela
