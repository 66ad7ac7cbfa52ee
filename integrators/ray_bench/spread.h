// What several rounds of one measurement say.
#pragma once

#include <algorithm>
#include <vector>

namespace candela {

struct Spread {
  double median = 0;  // the mean of the two in the middle of an even number
  double least = 0;
  double most = 0;
};

// All 0 of no values.
[[nodiscard]] inline Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const double upper = values[values.size() / 2];
  const double lower = values[(values.size() - 1) / 2];
  return {(lower + upper) / 2, values.front(), values.back()};
}

}  // namespace candela
