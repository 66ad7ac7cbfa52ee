// A metal by its complex index eta + i k: smooth, or GGX with Smith's masking.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/fresnel.h"
#include "renderer/bsdf/microfacet.h"
#include "renderer/bsdf/mirror.h"
#include "renderer/bsdf/specular_mixture.h"

namespace candela {

template <class Width>
[[nodiscard]] inline BsdfEvaluation evaluate_rough_conductor(const Bsdf& bsdf, Width a,
                                                             const Vec3f& wo, const Vec3f& wi) {
  MicrofacetReflection reflection = reflect_microfacets(GeometryTerm::Smith, a, wo, wi);
  return {fresnel_conductor(reflection.cos_half, bsdf.eta, bsdf.k) * reflection.value,
          reflection.pdf};
}

[[nodiscard]] inline BsdfEvaluation evaluate_conductor(const Bsdf& bsdf, const Vec3f& wo,
                                                       const Vec3f& wi) {
  if (bsdf.is_smooth) return {};
  return evaluate_rough_conductor(bsdf, ggx_width(bsdf.alpha), wo, wi);
}

[[nodiscard]] inline BsdfSample sample_conductor(const Bsdf& bsdf, const Vec3f& wo,
                                                 Vec2f direction) {
  if (bsdf.is_smooth) return mirror_sample(wo, fresnel_conductor(wo.z, bsdf.eta, bsdf.k));
  Vec3f wi = sample_ggx_reflection(wo, ggx_width(bsdf.alpha), direction);
  return to_sample(wi, evaluate_conductor(bsdf, wo, wi));
}

}  // namespace candela
