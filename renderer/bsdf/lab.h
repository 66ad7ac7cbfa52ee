// lab3's Blinn-Phong material as an energy-conserving one (docs/scene_format.md): GGX of width
// sqrt(2 / (n + 2)) with F0 = ks and Smith's masking, and a diffuse part that gets reciprocally
// what the specular one leaves: kd (1 - F(n.wi)) (1 - F(n.wo)) / pi [Shirley97b, eq. 5].
//
// At grazing angles F rises to 1, as Schlick has it, unless F0 is below 2 %, which no real surface
// has: a highlight that the artist dimmed or switched off (ks = 0 is Lambert's surface) must not
// return as a sheen. So F90 = min(1, 50 max F0) [Lagarde14, section 3.1.3].
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/fresnel.h"
#include "renderer/bsdf/microfacet.h"
#include "renderer/bsdf/specular_mixture.h"
#include "renderer/math/colour.h"
#include "renderer/math/reflectance.h"

namespace candela {

[[nodiscard]] inline Rgb lab_fresnel(const Rgb& f0, float cos_theta) {
  const float f90 = std::min(1.0f, 50 * max_component(f0));
  return f0 + (Rgb{f90} - f0) * schlick_weight(cos_theta);
}

[[nodiscard]] inline float lab_width(float exponent) {
  return ggx_width(width_of_exponent(exponent));
}

[[nodiscard]] inline float lab_specular_probability(const Bsdf& bsdf, float cos_o) {
  Rgb fresnel = lab_fresnel(bsdf.specular, cos_o);
  return specular_probability(average(fresnel), average(bsdf.diffuse * (Rgb{1} - fresnel)));
}

[[nodiscard]] inline BsdfEvaluation evaluate_lab(const Bsdf& bsdf, const Vec3f& wo,
                                                 const Vec3f& wi) {
  if (!(wi.z > 0)) return {};
  MicrofacetReflection reflection =
      reflect_microfacets(GeometryTerm::Smith, ggx_width(bsdf.alpha), wo, wi);
  Rgb diffuse = bsdf.diffuse * (Rgb{1} - lab_fresnel(bsdf.specular, wo.z)) *
                (Rgb{1} - lab_fresnel(bsdf.specular, wi.z)) * (wi.z * inverse_pi);
  return {diffuse + lab_fresnel(bsdf.specular, reflection.cos_half) * reflection.value,
          specular_mixture_pdf(lab_specular_probability(bsdf, wo.z), reflection.pdf, wi.z)};
}

[[nodiscard]] inline BsdfSample sample_lab(const Bsdf& bsdf, const Vec3f& wo, float lobe,
                                           Vec2f direction) {
  Vec3f wi = sample_specular_mixture(lab_specular_probability(bsdf, wo.z), ggx_width(bsdf.alpha),
                                     wo, lobe, direction);
  return to_sample(wi, evaluate_lab(bsdf, wo, wi));
}

}  // namespace candela
