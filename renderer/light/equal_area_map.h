// Sampling of the cells of an equal-area octahedral map (sampling/equal_area.h): every cell has the
// same solid angle, so the density is the cell's probability times a constant.
#pragma once

#include "renderer/light/map_sample.h"
#include "renderer/math/constants.h"
#include "renderer/sampling/distribution.h"
#include "renderer/sampling/equal_area.h"

namespace candela {

[[nodiscard]] inline float equal_area_cells_over_sphere(const GridDistribution& grid) {
  return static_cast<float>(grid.columns()) * static_cast<float>(grid.rows()) *
         (0.25f * inverse_pi);
}

[[nodiscard]] inline MapSample sample_equal_area(const GridDistribution& grid, Vec2f u) {
  const GridDistribution::Cell cell = grid.sample(u);
  Vec2f st{(static_cast<float>(cell.column) + cell.offset.x) / static_cast<float>(grid.columns()),
           (static_cast<float>(cell.row) + cell.offset.y) / static_cast<float>(grid.rows())};
  return {square_to_equal_area_sphere(st), cell.probability * equal_area_cells_over_sphere(grid)};
}

// The density of sample_equal_area() at the point of a direction.
[[nodiscard]] inline float equal_area_pdf(const GridDistribution& grid, Vec2f st) {
  const auto index = [](float x, std::uint32_t count) {
    return std::min(static_cast<std::uint32_t>(x * static_cast<float>(count)), count - 1);
  };
  return grid.probability(index(st.x, grid.columns()), index(st.y, grid.rows())) *
         equal_area_cells_over_sphere(grid);
}

}  // namespace candela
