#include "renderer/light/cell_weights.h"

#include <numeric>

#include "renderer/base/parallel.h"

namespace candela {
namespace {

struct BlockSums {
  double weights = 0;
  double squares = 0;
};
BlockSums sums_of(const CellWeights& cells, std::uint32_t first_column, std::uint32_t first_row,
                  std::uint32_t side) {
  BlockSums sums;
  for (std::uint32_t row = first_row; row < first_row + side; ++row)
    for (std::uint32_t column = first_column; column < first_column + side; ++column) {
      const double w = cells.at(column, row);
      sums.weights += w;
      sums.squares += w * w;
    }
  return sums;
}

// Of one row of merged cells.
double second_moment_of_row(const CellWeights& cells, std::uint32_t first_row, std::uint32_t side) {
  double sum = 0;
  for (std::uint32_t column = 0; column < cells.size.columns; column += side) {
    const BlockSums block = sums_of(cells, column, first_row, side);
    if (block.weights > 0) sum += block.squares / block.weights;
  }
  return sum * side * side;
}

}  // namespace

double total_weight(const CellWeights& cells) {
  return std::accumulate(cells.values.begin(), cells.values.end(), 0.0);
}

double second_moment(const CellWeights& cells, std::uint32_t side) {
  const double total = total_weight(cells);
  if (!(total > 0)) return 1;
  std::vector<double> rows(cells.size.rows / side);
  parallel_for(rows.size(), [&](std::size_t i) {
    rows[i] = second_moment_of_row(cells, static_cast<std::uint32_t>(i) * side, side);
  });
  return std::accumulate(rows.begin(), rows.end(), 0.0) / total;
}

std::uint32_t merged_cells(const CellWeights& cells, std::uint32_t faces) {
  constexpr std::size_t few_cells = std::size_t{1} << 15;  // 160 kB
  constexpr double largest_moment = 1.02;
  const std::uint32_t face_rows = cells.size.rows / faces;
  std::uint32_t side = 1;
  while (cells.values.size() / side / side > few_cells && cells.size.columns % (2 * side) == 0 &&
         face_rows % (2 * side) == 0 && second_moment(cells, 2 * side) < largest_moment)
    side *= 2;
  return side;
}

GridDistribution distribution_of(const CellWeights& cells) {
  const std::size_t columns = cells.size.columns;
  GridDistributionBuilder grid(cells.size.columns, cells.size.rows);
  parallel_for(cells.size.rows, [&](std::size_t row) {
    grid.set_row(static_cast<std::uint32_t>(row),
                 std::span(cells.values).subspan(row * columns, columns));
  });
  return std::move(grid).build();
}

}  // namespace candela
