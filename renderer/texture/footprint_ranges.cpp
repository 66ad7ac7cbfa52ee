#include "renderer/texture/footprint_ranges.h"

#include <algorithm>

#include "renderer/base/parallel.h"

namespace candela {
namespace {

// The last texel's neighbour is the first one or itself.
int texel_at(int i, int size, Wrap wrap) {
  if (i < size) return i;
  return wrap == Wrap::Repeat ? 0 : size - 1;
}

}  // namespace

std::vector<ValueRange> footprint_ranges(const TexelArray& texels, int channel, Wrap wrap,
                                         int cell_side) {
  const auto cells_along = [&](int size) {
    return static_cast<std::size_t>((size + cell_side - 1) / cell_side);
  };
  const std::size_t columns = cells_along(texels.width);
  std::vector<ValueRange> ranges(columns * cells_along(texels.height));
  const auto extend_by_texels = [&](int x_begin, int y_begin, ValueRange& range) {
    const int x_last = std::min(x_begin + cell_side, texels.width);
    const int y_last = std::min(y_begin + cell_side, texels.height);
    for (int y = y_begin; y <= y_last; ++y)
      for (int x = x_begin; x <= x_last; ++x) {
        const float value = stored_value(texels, texel_at(x, texels.width, wrap),
                                         texel_at(y, texels.height, wrap), channel);
        range.extend({value, value});
      }
  };
  parallel_for(cells_along(texels.height), [&](std::size_t row) {
    for (std::size_t column = 0; column < columns; ++column)
      extend_by_texels(static_cast<int>(column) * cell_side, static_cast<int>(row) * cell_side,
                       ranges[row * columns + column]);
  });
  return ranges;
}

}  // namespace candela
