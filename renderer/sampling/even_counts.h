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
  const int power_below = 2 * std::ilogb(count);
  int level = power_below;
  while (level < power_below + 2 && count >= lower_end_of_level(level + 1)) ++level;
  return level;
}

}  // namespace candela
