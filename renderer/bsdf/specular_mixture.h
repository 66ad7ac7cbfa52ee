// A GGX reflection over a cosine lobe: the sampling that models of two lobes share. Directions
// come from the lobe that `lobe` picks; value and density are always those of both together.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/ggx.h"
#include "renderer/sampling/drawable_probability.h"
#include "renderer/sampling/warp.h"

namespace candela {

// From rough albedos of the two lobes, >= 0. All specular where both are black.
[[nodiscard]] inline float specular_probability(float specular_albedo, float diffuse_albedo) {
  return drawable_share(specular_albedo, diffuse_albedo);
}

template <class Width>
[[nodiscard]] inline Vec3f sample_specular_mixture(float probability_specular, Width a,
                                                   const Vec3f& wo, float lobe, Vec2f direction) {
  if (lobe < probability_specular) return sample_ggx_reflection(wo, a, direction);
  return square_to_cosine_hemisphere(direction);
}

[[nodiscard]] inline float specular_mixture_pdf(float probability_specular, float specular_pdf,
                                                float cos_theta_i) {
  return probability_specular * specular_pdf +
         (1 - probability_specular) * cosine_hemisphere_pdf(cos_theta_i);
}

// The sample of a direction whose value and density evaluate() gave.
[[nodiscard]] inline BsdfSample to_sample(const Vec3f& wi, const BsdfEvaluation& evaluation) {
  if (!(evaluation.pdf > 0)) return {};
  return {.wi = wi, .weight = evaluation.value / evaluation.pdf, .pdf = evaluation.pdf};
}

}  // namespace candela
