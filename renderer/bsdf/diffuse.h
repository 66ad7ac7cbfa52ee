// Lambert's BRDF: f = kd / pi, sampled by the cosine.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/sampling/warp.h"

namespace candela {

[[nodiscard]] inline BsdfEvaluation evaluate_diffuse(const Bsdf& bsdf, const Vec3f& /*wo*/,
                                                     const Vec3f& wi) {
  if (!(wi.z > 0)) return {};
  const float pdf = cosine_hemisphere_pdf(wi.z);
  return {bsdf.diffuse * pdf, pdf};
}

[[nodiscard]] inline BsdfSample sample_diffuse(const Bsdf& bsdf, const Vec3f& /*wo*/,
                                               Vec2f direction) {
  Vec3f wi = square_to_cosine_hemisphere(direction);
  if (!(wi.z > 0)) return {};
  return {.wi = wi, .weight = bsdf.diffuse, .pdf = cosine_hemisphere_pdf(wi.z)};
}

}  // namespace candela
