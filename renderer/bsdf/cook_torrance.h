// f = kd / pi + ks F(wi.h) D G / (4 cos_o cos_i): REPORT section 2.2 with its corrections. One
// width a in D, in the geometry term and in the sampler; kd + ks <= 1 keeps the energy.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/fresnel.h"
#include "renderer/bsdf/microfacet.h"
#include "renderer/bsdf/specular_mixture.h"
#include "renderer/math/colour.h"

namespace candela {

[[nodiscard]] inline Rgb cook_torrance_fresnel(const Bsdf& bsdf, float cos_half) {
  switch (bsdf.fresnel) {
    case FresnelTerm::Schlick:
      return fresnel_schlick(bsdf.f0, cos_half);
    case FresnelTerm::Dielectric:
      return Rgb{fresnel_dielectric(cos_half, bsdf.eta.x).reflectance};
    case FresnelTerm::Conductor:
      return fresnel_conductor(cos_half, bsdf.eta, bsdf.k);
  }
  return Rgb{0};
}

// By Schlick's term at the macroscopic normal, whichever term the model has: it only steers.
[[nodiscard]] inline float cook_torrance_specular_probability(const Bsdf& bsdf, float cos_o) {
  return specular_probability(average(bsdf.specular * fresnel_schlick(bsdf.f0, cos_o)),
                              average(bsdf.diffuse));
}

[[nodiscard]] inline BsdfEvaluation evaluate_cook_torrance(const Bsdf& bsdf, const Vec3f& wo,
                                                           const Vec3f& wi) {
  if (!(wi.z > 0)) return {};
  MicrofacetReflection reflection =
      reflect_microfacets(bsdf.geometry, ggx_width(bsdf.alpha), wo, wi);
  Rgb fresnel = cook_torrance_fresnel(bsdf, reflection.cos_half);
  return {
      bsdf.diffuse * (wi.z * inverse_pi) + bsdf.specular * fresnel * reflection.value,
      specular_mixture_pdf(cook_torrance_specular_probability(bsdf, wo.z), reflection.pdf, wi.z)};
}

[[nodiscard]] inline BsdfSample sample_cook_torrance(const Bsdf& bsdf, const Vec3f& wo, float lobe,
                                                     Vec2f direction) {
  Vec3f wi = sample_specular_mixture(cook_torrance_specular_probability(bsdf, wo.z),
                                     ggx_width(bsdf.alpha), wo, lobe, direction);
  return to_sample(wi, evaluate_cook_torrance(bsdf, wo, wi));
}

}  // namespace candela
