// CookTorrance with Smith's masking and a further lobe for the light that is reflected more than
// once between microfacets, which one bounce loses: `energy_compensation: true`.
//
//   f = kd / pi + ks (F D G / (4 cos_o cos_i) + F_ms (1 - E(o)) (1 - E(i)) / (pi (1 - E_avg)))
//
// [Kulla17]. The lobe is reciprocal and returns all that is lost where F = 1. Else F_ms is what the
// series of bounces leaves, F_avg^2 E_avg (1 + F_avg (1 - E_avg) + ...), so colours saturate as on
// real metal. kd + ks <= 1 still keeps the energy, to the table's accuracy.
#pragma once

#include "renderer/bsdf/cook_torrance.h"
#include "renderer/bsdf/energy_loss.h"

namespace candela {

// F_avg, the cosine-weighted mean of the Fresnel term: exact for Schlick's, else Gauss' rule in
// cos^2, good to 1e-3.
[[nodiscard]] inline Rgb mean_fresnel(const Bsdf& bsdf) {
  if (bsdf.fresnel == FresnelTerm::Schlick) return bsdf.f0 + (Rgb{1} - bsdf.f0) / 21.0f;
  constexpr float cosines[] = {0.2634992f, 0.5744647f, 0.8185295f, 0.9646596f};
  constexpr float weights[] = {0.1739274f, 0.3260726f, 0.3260726f, 0.1739274f};
  Rgb sum{0};
  for (int i = 0; i < 4; ++i) sum += weights[i] * cook_torrance_fresnel(bsdf, cosines[i]);
  return sum;
}

// ks F_ms.
[[nodiscard]] inline Rgb multiple_reflectance(const Bsdf& bsdf, float mean_loss) {
  const Rgb mean = mean_fresnel(bsdf);
  return bsdf.specular * mean * mean * (1 - mean_loss) / (Rgb{1} - mean * mean_loss);
}

[[nodiscard]] inline float compensated_specular_probability(const Bsdf& bsdf, float cos_o) {
  const EnergyLossTable& table = energy_loss_table();
  const float a = ggx_width(bsdf.alpha);
  const float loss = table.loss(cos_o, a);
  const Rgb multiple = multiple_reflectance(bsdf, table.mean_loss(a)) * loss;
  return specular_probability(average(bsdf.specular * fresnel_schlick(bsdf.f0, cos_o)) * (1 - loss),
                              average(bsdf.diffuse + multiple));
}

[[nodiscard]] inline BsdfEvaluation evaluate_compensated(const Bsdf& bsdf, const Vec3f& wo,
                                                         const Vec3f& wi) {
  if (!(wi.z > 0)) return {};
  const EnergyLossTable& table = energy_loss_table();
  const float a = ggx_width(bsdf.alpha);
  const float mean_loss = table.mean_loss(a);
  const Rgb multiple = multiple_reflectance(bsdf, mean_loss) *
                       (table.loss(wo.z, a) * table.loss(wi.z, a) / mean_loss);
  const MicrofacetReflection reflection = reflect_microfacets(GeometryTerm::Smith, a, wo, wi);
  const Rgb fresnel = cook_torrance_fresnel(bsdf, reflection.cos_half);
  return {
      (bsdf.diffuse + multiple) * (wi.z * inverse_pi) + bsdf.specular * fresnel * reflection.value,
      specular_mixture_pdf(compensated_specular_probability(bsdf, wo.z), reflection.pdf, wi.z)};
}

[[nodiscard]] inline BsdfSample sample_compensated(const Bsdf& bsdf, const Vec3f& wo, float lobe,
                                                   Vec2f direction) {
  const Vec3f wi = sample_specular_mixture(compensated_specular_probability(bsdf, wo.z),
                                           ggx_width(bsdf.alpha), wo, lobe, direction);
  return to_sample(wi, evaluate_compensated(bsdf, wo, wi));
}

}  // namespace candela
