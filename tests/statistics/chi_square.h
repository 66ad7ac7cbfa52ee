// Pearson's chi-square test of counts against expectations, with cells merged until each expects
// enough for the distribution to hold.
#pragma once

#include <span>
#include <string>

namespace candela::statistics {

struct ChiSquareResult {
  double statistic = 0;
  double degrees_of_freedom = 0;
  double p_value = 1;
  std::string message;  // why p_value is 0 where no statistic is behind it
};

// `observed` and `expected` are counts, cell by cell. Cells that expect less than `least_expected`
// are pooled, least first; a cell that expects nothing and saw something makes the p-value 0.
// `fixed_total`: the expectations were scaled to the observed sum, which costs one degree of
// freedom. Otherwise (a sampler that rejects some samples) give the rejected ones a cell.
[[nodiscard]] ChiSquareResult chi_square_test(std::span<const double> observed,
                                              std::span<const double> expected,
                                              double least_expected = 5, bool fixed_total = true);

}  // namespace candela::statistics
