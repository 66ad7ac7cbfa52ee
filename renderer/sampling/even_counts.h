// Numbers of a sequence's first points that are evenly spread: powers of two, and those and half as
// many again: 1, 1.5, 2, 3, 4, 6, 8 ..., level by level. In smooth parts of a picture Sobol points
// of a number between two levels often have no less noise than those of the lower one
// (docs/decisions.md).
#pragma once

#include <cmath>

namespace candela {

// Level 0 is one point; whole from level 2 on.
[[nodiscard]] inline double even_count(int level) {
  return std::ldexp(level % 2 == 0 ? 1 : 1.5, level / 2);
}

// From which count on, from level 1 on, the level is the nearest one by ratio.
[[nodiscard]] inline double lower_end_of_level(int level) {
  return std::sqrt(even_count(level - 1) * even_count(level));
}

// The nearest by ratio of a count from 1 on.
[[nodiscard]] inline int nearest_level(double count) {
  constexpr double root_of_1_5 = 1.2247448713915890;  // lower ends over the power of two below them
  constexpr double root_of_3 = 1.7320508075688772;
  int power = 0;
  const double over_power = 2 * std::frexp(count, &power);  // in [1, 2)
  return 2 * (power - 1) + (over_power >= root_of_1_5 ? 1 : 0) + (over_power >= root_of_3 ? 1 : 0);
}

}  // namespace candela
