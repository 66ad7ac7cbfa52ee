// A small picture of where an opacity map is wholly clear or wholly opaque, one byte for 4x4
// texels.
//
// Rays that search a tree's leaves ask for opacities all over the maps. Most answers lie in this
// grid, which stays in the processor's caches where the maps themselves do not.
#pragma once

#include <vector>

#include "renderer/material/coverage.h"
#include "renderer/texture/footprint.h"
#include "renderer/texture/texture.h"

namespace candela {

class CoverageGrid {
 public:
  // Of a channel of the texture (0..2 colour, 3: alpha), thresholds as in coverage_of_range().
  // Decodes the texture.
  CoverageGrid(const TextureStore& textures, TextureHandle texture, int channel, bool is_lab);

  // Coverage by the bilinear lookup at uv. Partial: the lookup must tell.
  [[nodiscard]] Coverage at(Vec2f uv) const {
    if (cells_.empty()) return Coverage::Partial;  // Wrap::Black, or no image
    const auto& [column, row] = footprint_of(uv, width_, height_, wrap_);
    return cells_[static_cast<std::size_t>(row.first / cell_side) * columns_ +
                  static_cast<std::size_t>(column.first / cell_side)];
  }

 private:
  static constexpr std::int32_t cell_side = 4;

  std::int32_t width_;
  std::int32_t height_;
  std::size_t columns_;
  Wrap wrap_;
  std::vector<Coverage> cells_;  // by the first column and row of the lookup's footprint
};

}  // namespace candela
