// When cells of an environment map are merged, and into what.
#include "renderer/light/cell_weights.h"

#include <gtest/gtest.h>

#include "renderer/sampling/hash.h"

namespace candela {
namespace {

template <class Weight>
CellWeights cells_of(std::uint32_t columns, std::uint32_t rows, const Weight& weight) {
  CellWeights cells({columns, rows});
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column)
      cells.at(column, row) = weight(column, row);
  return cells;
}

double random_weight(std::uint32_t column, std::uint32_t row) {
  const std::uint64_t bits = hash_combine(column, row);
  return bits % 3 == 0 ? 0 : static_cast<double>(bits >> 40);
}

// The second moment of an estimate of all weights where each cell's density is its block's mean.
double moment_of_estimates(const CellWeights& cells, std::uint32_t side) {
  CellWeights blocks({cells.size.columns / side, cells.size.rows / side});
  for (std::uint32_t row = 0; row < cells.size.rows; ++row)
    for (std::uint32_t column = 0; column < cells.size.columns; ++column)
      blocks.at(column / side, row / side) += cells.at(column, row);
  const GridDistribution table = distribution_of(blocks);
  double sum = 0;
  for (std::uint32_t row = 0; row < cells.size.rows; ++row)
    for (std::uint32_t column = 0; column < cells.size.columns; ++column) {
      const double w = cells.at(column, row);
      const double share =
          static_cast<double>(table.probability(column / side, row / side)) / (side * side);
      if (w > 0) sum += w * w / share;
    }
  return sum / (total_weight(cells) * total_weight(cells));
}

TEST(Unit_CellWeights, SecondMomentIsThatOfTheTablesEstimates) {
  const CellWeights cells = cells_of(48, 16, random_weight);
  for (const std::uint32_t side : {1u, 2u, 4u, 8u, 16u})
    EXPECT_NEAR(second_moment(cells, side), moment_of_estimates(cells, side), 1e-4) << side;
  EXPECT_GT(second_moment(cells, 2), 1.2);  // or nothing was compared
}

TEST(Unit_CellWeights, SecondMomentOfASpotIsTheAreaThatSharesItsDensity) {
  const auto spot = [](std::uint32_t column, std::uint32_t row) {
    return column == 5 && row == 9 ? 3.0 : 0.0;
  };
  const CellWeights cells = cells_of(16, 32, spot);
  EXPECT_EQ(second_moment(cells, 1), 1);
  EXPECT_EQ(second_moment(cells, 8), 64);
  EXPECT_EQ(second_moment(cells_of(4, 4, [](auto, auto) { return 0.0; }), 2), 1);
}

TEST(Unit_CellWeights, ADistributionHasTheSharesOfItsCells) {
  const CellWeights cells = cells_of(6, 3, random_weight);
  const GridDistribution table = distribution_of(cells);
  ASSERT_EQ(table.columns(), 6u);
  ASSERT_EQ(table.rows(), 3u);
  for (std::uint32_t row = 0; row < 3; ++row)
    for (std::uint32_t column = 0; column < 6; ++column)
      EXPECT_NEAR(table.probability(column, row), cells.at(column, row) / total_weight(cells),
                  1e-6);
}

double even(std::uint32_t /*column*/, std::uint32_t /*row*/) {
  return 1;
}

TEST(Unit_CellWeights, EvenMapsAreMergedUntilTheyAreSmall) {
  EXPECT_EQ(merged_cells(cells_of(1024, 1024, even), 1), 8u);  // 2^14
  EXPECT_EQ(merged_cells(cells_of(256, 128, even), 1), 1u);    // small as they are
}

TEST(Unit_CellWeights, WhatIsUnevenIsLeftAlone) {
  EXPECT_EQ(merged_cells(cells_of(512, 512, random_weight), 1), 1u);
  // Two halves of different light, which each cell but those at the crease is all of.
  const auto halves = [](std::uint32_t column, std::uint32_t) { return column < 255 ? 1.0 : 9.0; };
  EXPECT_EQ(merged_cells(cells_of(512, 512, halves), 1), 4u);
}

// Of six faces of 90 rows pairs of rows fit into each, fours do not, though they fit into all 540.
TEST(Unit_CellWeights, CellsOfTwoFacesAreNeverMerged) {
  EXPECT_EQ(merged_cells(cells_of(512, 540, even), 6), 2u);
  EXPECT_EQ(merged_cells(cells_of(512, 540, even), 1), 4u);
}

}  // namespace
}  // namespace candela
