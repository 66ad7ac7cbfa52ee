#include "integrators/roulette/walk.h"

#include "integrators/path/survival.h"

namespace candela {

RouletteToll toll_of(const Walk& walk, Roulette other) {
  RouletteToll toll;
  double ratio = 1;  // P / Q, of the steps so far
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    const WalkStep& step = walk.steps[i];
    // Survivors' throughput is that without roulette over P here, over Q there.
    const float throughput = step.throughput * static_cast<float>(ratio);
    const float survival = survival_probability(static_cast<std::uint32_t>(i), throughput, other,
                                                highest_survival_on_surfaces);
    if (!(survival > 0)) break;
    const double ratio_before = ratio;
    ratio *= static_cast<double>(step.survival / survival);
    const Vec3d rest(walk.radiance - step.radiance);
    toll.variance += (ratio - ratio_before) * rest * rest;
    toll.bounces += 1 / ratio;
  }
  return toll;
}

}  // namespace candela
