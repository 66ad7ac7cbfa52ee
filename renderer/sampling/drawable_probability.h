// Probabilities that random numbers can have exactly.
//
// Random numbers are multiples of 2^-24 (unit_float()): one is below p with the probability of p
// rounded up to such a multiple. What is then divided by p itself is too bright, twice as bright
// near p = 3e-8.
#pragma once

#include <algorithm>

namespace candela {

// p rounded up to a multiple of 2^-24; in [0, 1]. No number stays none.
[[nodiscard]] inline float drawable_probability(float p) {
  const float nearest = p < 0.5f ? (0.5f + p) - 0.5f : p;  // from 1/2 on floats are such multiples
  return nearest < p ? nearest + 0x1p-24f : nearest;
}

// The probability of the first of two by their shares, 0 or 1 only where one of them has none; 1
// where neither has any.
[[nodiscard]] inline float drawable_share(float first, float second) {
  if (!(second > 0)) return 1;
  return std::min(drawable_probability(first / (first + second)), 1 - 0x1p-24f);
}

}  // namespace candela
