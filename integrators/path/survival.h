// Russian roulette: with which probability a path goes on.
#pragma once

#include <algorithm>
#include <cstdint>

#include "integrators/path_plan.h"
#include "renderer/sampling/drawable_probability.h"

namespace candela {

// It stays below 1 so that paths end in closed white scenes too, by little: light that leaves a
// trap (total reflection) in shares smaller than what roulette takes would have no variance.
inline constexpr float highest_survival_on_surfaces = 0.998f;

// `roulette_throughput`: the eta^2 of refraction is taken out, since it comes back when the path
// leaves the glass [Pharr23, section 14.5.4]; so is what a guide takes of the throughput where it
// sends most paths: it ends none of them sooner than the BSDF would.
[[nodiscard]] inline float survival_probability(std::uint32_t bounce, float roulette_throughput,
                                                Roulette roulette, float highest) {
  if (bounce < roulette.first_bounce) return 1;
  return drawable_probability(std::min(roulette_throughput * roulette.inverse_threshold, highest));
}

}  // namespace candela
