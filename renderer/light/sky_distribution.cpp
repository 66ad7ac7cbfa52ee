#include "renderer/light/sky_distribution.h"

#include "renderer/base/parallel.h"
#include "renderer/light/sky_cells.h"

namespace candela {

SkyDistribution compensated(const SkyDistribution& sky) {
  constexpr double taken_off = 0.5, least_left = 0.1;
  const GridDistribution& cells = sky.cells();
  GridDistributionBuilder grid(cells.columns(), cells.rows());
  parallel_for(cells.rows(), [&](std::size_t i) {
    const auto row = static_cast<std::uint32_t>(i);
    std::vector<double> weights;
    for (std::uint32_t column = 0; column < cells.columns(); ++column) {
      const double even =
          sky_cell_solid_angle({cells.columns(), cells.rows()}, column, row) / (4 * pi_double);
      const double probability = cells.probability(column, row);
      weights.push_back(std::max(probability - taken_off * even, least_left * probability));
    }
    grid.set_row(row, weights);
  });
  return SkyDistribution(std::move(grid).build());
}

}  // namespace candela
