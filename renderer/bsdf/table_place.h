// Where a number of [0, 1] falls into a table of equal intervals.
#pragma once

#include <algorithm>
#include <cstddef>

namespace candela {

struct TablePlace {
  std::size_t index;  // of the interval
  float fraction;     // of the way through it
};

[[nodiscard]] inline TablePlace table_place(float x, std::size_t intervals) {
  const float scaled = x * static_cast<float>(intervals);
  const std::size_t index = std::min(static_cast<std::size_t>(scaled), intervals - 1);
  return {index, scaled - static_cast<float>(index)};
}

}  // namespace candela
