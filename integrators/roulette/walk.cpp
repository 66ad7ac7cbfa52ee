#include "integrators/roulette/walk.h"

#include <algorithm>

#include "integrators/path/survival.h"

namespace candela {
namespace {

// Within media it is more, as a walk's own roulette tells where it was as high.
float highest_survival_at(const WalkStep& step) {
  return step.survival < 1 ? std::max(step.survival, highest_survival_on_surfaces)
                           : highest_survival_on_surfaces;
}

}  // namespace

RouletteOutcome expected_under(const Walk& walk, Roulette other) {
  RouletteOutcome outcome;
  double ratio = 1;  // P / Q, of the steps so far
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    const WalkStep& step = walk.steps[i];
    // Survivors' throughput is that without roulette over P here, over Q there.
    const float throughput = step.throughput * static_cast<float>(ratio);
    const float survival = survival_probability(static_cast<std::uint32_t>(i), throughput, other,
                                                highest_survival_at(step));
    if (!(survival > 0)) break;
    const double ratio_before = ratio;
    ratio *= static_cast<double>(step.survival / survival);
    const Vec3d rest(walk.radiance - step.radiance);
    outcome.variance += (ratio - ratio_before) * rest * rest;
    outcome.bounces += 1 / ratio;
  }
  return outcome;
}

}  // namespace candela
