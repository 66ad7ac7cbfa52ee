#include "tests/statistics/chi_square.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "tests/statistics/distributions.h"

namespace candela::statistics {
namespace {

struct Cell {
  double observed = 0;
  double expected = 0;
};

// Cells of at least `least` expected counts: the small ones are pooled in order of expectation;
// what remains too small at the end joins the smallest cell that stands.
std::vector<Cell> merge_cells(std::span<const double> observed, std::span<const double> expected,
                              double least) {
  std::vector<std::size_t> order(observed.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
  std::vector<Cell> cells;
  Cell pool;
  for (const std::size_t i : order) {
    pool.observed += observed[i];
    pool.expected += expected[i];
    if (pool.expected < least) continue;
    cells.push_back(pool);
    pool = {};
  }
  if (!cells.empty()) {
    cells.front().observed += pool.observed;
    cells.front().expected += pool.expected;
  }
  return cells;
}

}  // namespace

ChiSquareResult chi_square_test(std::span<const double> observed, std::span<const double> expected,
                                double least_expected, bool fixed_total) {
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (!(expected[i] >= 0) || !std::isfinite(expected[i]))
      return {.p_value = 0, .message = fmt::format("cell {} expects {}", i, expected[i])};
    if (expected[i] == 0 && observed[i] != 0)
      return {.p_value = 0,
              .message = fmt::format("cell {} expects nothing and saw {}", i, observed[i])};
  }
  const std::vector<Cell> cells = merge_cells(observed, expected, least_expected);
  if (cells.size() < 2)
    return {.p_value = 0, .message = "fewer than two cells are left after merging"};
  ChiSquareResult result;
  for (const Cell& cell : cells) {
    const double difference = cell.observed - cell.expected;
    result.statistic += difference * difference / cell.expected;
  }
  result.degrees_of_freedom = static_cast<double>(cells.size()) - (fixed_total ? 1 : 0);
  result.p_value = gamma_q(result.degrees_of_freedom / 2, result.statistic / 2);
  return result;
}

}  // namespace candela::statistics
