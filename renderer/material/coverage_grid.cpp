#include "renderer/material/coverage_grid.h"

namespace candela {

CoverageGrid::CoverageGrid(const TextureStore& textures, TextureHandle texture, int channel,
                           bool is_lab) {
  const TextureStore::RangeGrid ranges = textures.range_grid(texture, channel, cell_side);
  width_ = ranges.width;
  height_ = ranges.height;
  columns_ = static_cast<std::size_t>((width_ + cell_side - 1) / cell_side);
  wrap_ = ranges.wrap;
  cells_.reserve(ranges.cells.size());
  for (const auto& [low, high] : ranges.cells)
    cells_.push_back(coverage_of_range(low, high, is_lab));
}

}  // namespace candela
