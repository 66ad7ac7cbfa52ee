// How much light comes from each cell of an environment map, and how fine the cells have to be.
//
// A table that is as fine as the map does not fit into a processor's caches, and all that is asked
// of it is at random places. Most skies are smooth: with cells that are merged as long as light
// samples get hardly noisier it takes a small part of the memory (docs/decisions.md).
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/sampling/distribution.h"

namespace candela {

struct GridSize {
  std::uint32_t columns = 1;
  std::uint32_t rows = 1;
};

struct CellWeights {
  explicit CellWeights(GridSize of) : size(of), values(std::size_t{of.columns} * of.rows) {}

  [[nodiscard]] double& at(std::uint32_t column, std::uint32_t row) {
    return values[std::size_t{row} * size.columns + column];
  }
  [[nodiscard]] double at(std::uint32_t column, std::uint32_t row) const {
    return values[std::size_t{row} * size.columns + column];
  }

  GridSize size;
  std::vector<double> values;  // row by row
};

[[nodiscard]] double total_weight(const CellWeights& cells);

// The second moment of (light from all over the map) / density where `side` x `side` cells share
// one density, over the squared integral: 1 for cells that are as they are. `side` divides both
// dimensions; cells count as of equal size and even within. 1 where there is no light.
[[nodiscard]] double second_moment(const CellWeights& cells, std::uint32_t side);

// How many cells a side to merge: as few as leave no more cells than caches hold easily, or the
// most for which the second moment stays below 1.02. A power of two; it divides the columns and the
// rows of each of `faces`, which lie one below the other.
[[nodiscard]] std::uint32_t merged_cells(const CellWeights& cells, std::uint32_t faces);

[[nodiscard]] GridDistribution distribution_of(const CellWeights& cells);

}  // namespace candela
