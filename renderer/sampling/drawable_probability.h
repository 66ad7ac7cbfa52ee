// Probabilities that random numbers can have exactly.
//
// Random numbers are multiples of 2^-24 (unit_float()): one is below p with the probability of p
// rounded up to such a multiple. What is then divided by p itself is too bright, twice as bright
// near p = 3e-8.
#pragma once

namespace candela {

// p rounded up to a multiple of 2^-24; in [0, 1]. No number stays none.
[[nodiscard]] inline float drawable_probability(float p) {
  const float nearest = p < 0.5f ? (0.5f + p) - 0.5f : p;  // from 1/2 on floats are such multiples
  return nearest < p ? nearest + 0x1p-24f : nearest;
}

}  // namespace candela
