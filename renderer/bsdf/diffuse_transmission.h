// A thin sheet that scatters by Lambert's law on both sides: `diffuse` is what it reflects,
// `transmittance` what it lets through, together at most 1.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/math/colour.h"
#include "renderer/sampling/drawable_probability.h"
#include "renderer/sampling/warp.h"

namespace candela {

[[nodiscard]] inline float sheet_reflection_probability(const Bsdf& bsdf) {
  return drawable_share(average(bsdf.diffuse), average(bsdf.transmittance));
}

[[nodiscard]] inline BsdfEvaluation evaluate_diffuse_transmission(const Bsdf& bsdf,
                                                                  const Vec3f& wi) {
  const float p_reflect = sheet_reflection_probability(bsdf);
  const float lambert = cosine_hemisphere_pdf(std::abs(wi.z));
  if (wi.z > 0) return {bsdf.diffuse * lambert, p_reflect * lambert};
  return {bsdf.transmittance * lambert, (1 - p_reflect) * lambert};
}

[[nodiscard]] inline BsdfSample sample_diffuse_transmission(const Bsdf& bsdf, float lobe,
                                                            Vec2f direction) {
  const bool reflects = lobe < sheet_reflection_probability(bsdf);
  Vec3f wi = square_to_cosine_hemisphere(direction);
  if (!reflects) wi.z = -wi.z;
  BsdfEvaluation evaluation = evaluate_diffuse_transmission(bsdf, wi);
  if (!(evaluation.pdf > 0)) return {};
  return {.wi = wi, .weight = evaluation.value / evaluation.pdf, .pdf = evaluation.pdf};
}

}  // namespace candela
