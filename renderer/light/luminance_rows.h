// The luminance of an environment's texels, filtered and gathered into the cells that sampling
// uses. A stretch of rows at a time: the whole map in floats may be larger than its texels.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/texture/texture.h"

namespace candela {

// Rows begin .. end - 1 of a map, row 0 at the file's top.
struct RowRange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  [[nodiscard]] std::uint32_t count() const { return end - begin; }
};

struct LuminanceRows {
  std::uint32_t width = 0;
  RowRange rows;
  std::vector<float> values;

  [[nodiscard]] float at(std::uint32_t x, std::uint32_t y) const { return row(y)[x]; }
  [[nodiscard]] const float* row(std::uint32_t y) const {
    return values.data() + std::size_t{y - rows.begin} * width;
  }
};

// The mean over each texel's square of the bilinear interpolation between texel centres: positive
// wherever any point of the square is. Columns wrap or are clamped; the map's rows are clamped.
[[nodiscard]] LuminanceRows filtered_luminance(const TextureStore& textures, TextureHandle texture,
                                               RowRange rows, bool columns_wrap);

// The texel rows that `cells` of `cell_rows` rows of cells touch in a map of `texel_rows`.
[[nodiscard]] RowRange touched_rows(RowRange cells, std::uint32_t cell_rows,
                                    std::uint32_t texel_rows);

// The mean over columns of `texels`, all of its rows, that cell `column` of `columns` touches:
// positive wherever one of them is.
[[nodiscard]] double cell_mean(const LuminanceRows& map, RowRange texels, std::uint32_t column,
                               std::uint32_t columns);

}  // namespace candela
