// One switch over the models for each question that integrators ask of a BSDF.
// Kernels pass the set of models their scene has; a model outside of it is never met.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/diffuse.h"

namespace candela {

// True where every lobe is a delta lobe: next-event estimation has nothing to add.
[[nodiscard]] inline bool is_only_delta(const Bsdf& bsdf) {
  return bsdf.model == BsdfModel::Mirror || bsdf.model == BsdfModel::ThinDielectric ||
         bsdf.is_smooth;
}

// The sum of the non-delta lobes. wo.z > 0 always holds.
template <ModelSet models = all_models>
[[nodiscard]] inline BsdfEvaluation evaluate_bsdf(const Bsdf& bsdf, const Vec3f& wo,
                                                  const Vec3f& wi) {
  return evaluate_diffuse(bsdf, wo, wi);
}

// `lobe` picks the lobe, `direction` a direction in it, all in [0, 1).
template <ModelSet models = all_models>
[[nodiscard]] inline BsdfSample sample_bsdf(const Bsdf& bsdf, const Vec3f& wo, float /*lobe*/,
                                            Vec2f direction) {
  return sample_diffuse(bsdf, wo, direction);
}

// Directional albedo, roughly: for AOVs. In [0, 1], never NaN.
[[nodiscard]] inline Rgb albedo_estimate(const Bsdf& bsdf, const Vec3f& /*wo*/) {
  return glm::clamp(bsdf.diffuse, 0.0f, 1.0f);
}

}  // namespace candela
