// Directions that know nothing of the BSDF: uniform or by the cosine, for comparison.
#pragma once

#include "integrators/sampling_strategy.h"
#include "renderer/bsdf/dispatch.h"
#include "renderer/bsdf/specular_mixture.h"  // to_sample
#include "renderer/sampling/warp.h"

namespace candela {

// Over the hemisphere on the side of wo, or over both where light goes through: `side` chooses.
// Blind to delta lobes.
template <ModelSet models = all_models>
[[nodiscard]] inline BsdfSample sample_plain_direction(SamplingStrategy strategy, const Bsdf& bsdf,
                                                       const Vec3f& wo, float side, Vec2f u) {
  const bool is_uniform = strategy == SamplingStrategy::Uniform;
  Vec3f wi = is_uniform ? square_to_uniform_hemisphere(u) : square_to_cosine_hemisphere(u);
  float pdf = is_uniform ? 0.5f * inverse_pi : cosine_hemisphere_pdf(wi.z);
  const bool has_two_sides = bsdf.model == BsdfModel::Dielectric ||
                             bsdf.model == BsdfModel::AnisotropicDielectric ||
                             bsdf.model == BsdfModel::DiffuseTransmission;
  if (has_two_sides) {
    pdf *= 0.5f;
    if (side < 0.5f) wi.z = -wi.z;
  }
  BsdfSample sample = to_sample(wi, {evaluate_bsdf<models>(bsdf, wo, wi).value, pdf});
  if (wi.z < 0) sample.eta = bsdf.eta.x;
  return sample;
}

}  // namespace candela
