// Weights by which lights are picked, for those that would hardly ever be.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace candela {

// Nothing that shines is picked less often than every tenth of an equal share, nor than with
// `least_share`: what is dim may be all that lights the place where it stands.
inline void lift_dim_lights(std::vector<double>& weights, double least_share = 0) {
  double sum = 0;
  double count = 0;
  for (const double weight : weights)
    if (weight > 0) {
      sum += weight;
      ++count;
    }
  if (!(sum > 0) || !std::isfinite(sum)) return;
  const double least = std::max(0.1 * sum / count, least_share * sum);
  for (double& weight : weights)
    if (weight > 0) weight = std::max(weight, least);
}

}  // namespace candela
