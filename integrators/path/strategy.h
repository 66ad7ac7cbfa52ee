// How the estimators of a path are weighted: multiple importance sampling by the power heuristic,
// or what the options ask for in the kernels for comparisons (FeatureSet::strategies).
#pragma once

#include "integrators/path/feature_set.h"
#include "integrators/render_options.h"
#include "renderer/sampling/mis.h"

namespace candela {

[[nodiscard]] inline float heuristic_weight(Heuristic heuristic, float pdf, float other_pdf) {
  return heuristic == Heuristic::Power ? power_heuristic(pdf, other_pdf)
                                       : balance_heuristic(pdf, other_pdf);
}

// The weight of a light sample against the BSDF's density of its direction.
template <FeatureSet F>
[[nodiscard]] inline float light_sample_weight(const RenderOptions& options, float light_pdf,
                                               float bsdf_pdf) {
  if constexpr (F.strategies) {
    if (options.sampling != SamplingStrategy::Mis) return 1;
    return heuristic_weight(options.heuristic, light_pdf, bsdf_pdf);
  }
  return power_heuristic(light_pdf, bsdf_pdf);
}

// The weight of light that a path met, against the light sampler's density of its direction.
template <FeatureSet F>
[[nodiscard]] inline float met_light_weight(const RenderOptions& options, float bsdf_pdf,
                                            float light_pdf) {
  if constexpr (F.strategies) {
    if (options.sampling == SamplingStrategy::Bsdf) return 1;
    if (options.sampling != SamplingStrategy::Mis) return light_pdf > 0 ? 0.0f : 1.0f;
    return heuristic_weight(options.heuristic, bsdf_pdf, light_pdf);
  }
  return power_heuristic(bsdf_pdf, light_pdf);
}

[[nodiscard]] constexpr bool has_default_strategy(const RenderOptions& options) {
  return options.sampling == SamplingStrategy::Mis && options.heuristic == Heuristic::Power;
}

}  // namespace candela
