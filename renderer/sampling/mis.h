// Weights of multiple importance sampling for two strategies with one sample each.
#pragma once

namespace candela {

enum class Heuristic : unsigned char { Power, Balance };

// The power heuristic with exponent 2 [Veach97, eq. 9.13]: the weight of the strategy of `pdf`.
// Written by the ratio, so that densities whose squares overflow still work.
[[nodiscard]] inline float power_heuristic(float pdf, float other_pdf) {
  if (!(pdf > 0)) return 0;
  const float ratio = other_pdf / pdf;
  return 1 / (1 + ratio * ratio);
}

[[nodiscard]] inline float balance_heuristic(float pdf, float other_pdf) {
  if (!(pdf > 0)) return 0;
  return 1 / (1 + other_pdf / pdf);
}

}  // namespace candela
