// An interface of two transparent media, smooth or GGX-rough [Walter07]: reflection, refraction,
// total internal reflection. bsdf.eta.x is the index below the surface over that above (wo's side).
//
// Values are for radiance: refraction carries 1 / eta^2, which shrinks or widens the solid angle
// [Veach97, eq. 5.11]; the tint `transmittance` multiplies each refraction. Reflections use Smith's
// height-correlated masking, refractions the separable one (both reciprocal).
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/fresnel.h"
#include "renderer/bsdf/microfacet.h"
#include "renderer/bsdf/mirror.h"
#include "renderer/sampling/drawable_probability.h"

namespace candela {

// Below this spread of the refracted lobe float cannot tell it from straight on (see ggx.h): the
// half vector of a refraction is divided by (eta - 1). Alike on both sides: eta or 1 / eta.
inline constexpr float smallest_refraction_spread = 1e-5f;
[[nodiscard]] inline bool is_smooth_dielectric(float alpha, float eta) {
  return !(alpha >= smallest_ggx_width) ||
         !(alpha * std::abs(eta - 1) >= smallest_refraction_spread * std::max(1.0f, eta));
}

// The probability to follow the reflection at a microfacet of this reflectance.
[[nodiscard]] inline float reflection_probability(float reflectance, const Rgb& transmittance) {
  return drawable_share(reflectance, (1 - reflectance) * max_component(transmittance));
}

// Snell's law at a microfacet m [Walter07, eq. 40]. Normalised, since 1 / eta amplifies rounding.
[[nodiscard]] inline Vec3f refract(const Vec3f& wo, const Vec3f& m, float cos_half,
                                   float cos_transmitted, float eta) {
  return normalize(m * (cos_half / eta - cos_transmitted) - wo / eta);
}

[[nodiscard]] inline BsdfSample refraction_sample(const Vec3f& wi, const Rgb& weight, float eta) {
  return {.wi = wi, .weight = weight, .eta = eta, .is_delta = true};
}

[[nodiscard]] inline BsdfSample sample_smooth_dielectric(const Bsdf& bsdf, const Vec3f& wo,
                                                         float lobe) {
  const float eta = bsdf.eta.x;
  DielectricFresnel fresnel = fresnel_dielectric(wo.z, eta);
  const float p_reflect = reflection_probability(fresnel.reflectance, bsdf.transmittance);
  if (lobe < p_reflect) return mirror_sample(wo, Rgb{fresnel.reflectance / p_reflect});
  Vec3f wi = refract(wo, {0, 0, 1}, wo.z, fresnel.cos_transmitted, eta);
  const float weight = (1 - fresnel.reflectance) / ((1 - p_reflect) * square(eta));
  return refraction_sample(wi, bsdf.transmittance * weight, eta);
}

template <class Width>
[[nodiscard]] inline BsdfEvaluation evaluate_rough_reflection(const Bsdf& bsdf, Width a,
                                                              const Vec3f& wo, const Vec3f& wi) {
  Vec3f sum = wo + wi;
  const float length2 = length_squared(sum);
  if (!(length2 > 0)) return {};
  const float cos_half = cosine_to_half_vector(length2);
  const float distribution = ggx_distribution(sum, a);
  const float reflectance = fresnel_dielectric(cos_half, bsdf.eta.x).reflectance;
  const float value =
      reflectance * distribution * masking_over_cosines(GeometryTerm::Smith, wo, wi, a);
  // The normal's density over 4 (wo.h), by which (wo.h) cancels.
  const float pdf = distribution / (2 * (wo.z + smith_root(wo, a)));
  return {Rgb{value}, reflection_probability(reflectance, bsdf.transmittance) * pdf};
}

// [Walter07, eqs. 16, 17 and 21], all divided by the squared index of wo's side.
template <class Width>
[[nodiscard]] inline BsdfEvaluation evaluate_rough_refraction(const Bsdf& bsdf, Width a,
                                                              const Vec3f& wo, const Vec3f& wi) {
  const float eta = bsdf.eta.x;
  Vec3f across = wo + wi * eta;
  Vec3f half = across.z < 0 ? -across : across;
  const float length2 = length_squared(half);
  if (!(length2 > 0) || !(half.z > 0)) return {};
  Vec3f h = half / std::sqrt(length2);
  const float cos_o = dot(wo, h);
  const float cos_i = -dot(wi, h);
  if (!(cos_o > 0) || !(cos_i > 0)) return {};
  const float transmitted = fresnel_transmittance(cos_o, cos_i, eta);
  const float p_refract = 1 - reflection_probability(1 - transmitted, bsdf.transmittance);
  const float distribution = ggx_distribution(h, a);
  const float solid_angles = cos_i / length2;  // dh / dwi over eta^2: |across| = |cos_o + eta wi.h|
  const float normal_pdf = ggx_visible_normal_pdf(distribution, cos_o, wo, a);
  const float value = transmitted * normal_pdf * smith_g1(wi, a) * solid_angles;
  return {bsdf.transmittance * value, p_refract * normal_pdf * solid_angles * square(eta)};
}

template <class Width>
[[nodiscard]] inline BsdfEvaluation evaluate_rough_dielectric(const Bsdf& bsdf, Width a,
                                                              const Vec3f& wo, const Vec3f& wi) {
  if (wi.z > 0) return evaluate_rough_reflection(bsdf, a, wo, wi);
  if (wi.z < 0) return evaluate_rough_refraction(bsdf, a, wo, wi);
  return {};
}
[[nodiscard]] inline BsdfEvaluation evaluate_dielectric(const Bsdf& bsdf, const Vec3f& wo,
                                                        const Vec3f& wi) {
  if (bsdf.is_smooth) return {};
  return evaluate_rough_dielectric(bsdf, ggx_width(bsdf.alpha), wo, wi);
}

template <class Width>
[[nodiscard]] inline BsdfSample sample_rough_dielectric(const Bsdf& bsdf, Width a, const Vec3f& wo,
                                                        float lobe, Vec2f direction) {
  const float eta = bsdf.eta.x;
  Vec3f m = sample_ggx_visible_normal(wo, a, direction);
  const float cos_half = dot(wo, m);
  if (!(cos_half > 0)) return {};
  DielectricFresnel fresnel = fresnel_dielectric(cos_half, eta);
  const bool reflects = lobe < reflection_probability(fresnel.reflectance, bsdf.transmittance);
  Vec3f wi =
      reflects ? m * (2 * cos_half) - wo : refract(wo, m, cos_half, fresnel.cos_transmitted, eta);
  if (reflects != (wi.z > 0)) return {};
  BsdfEvaluation evaluation = evaluate_rough_dielectric(bsdf, a, wo, wi);
  if (!(evaluation.pdf > 0)) return {};
  return {.wi = wi,
          .weight = evaluation.value / evaluation.pdf,
          .pdf = evaluation.pdf,
          .eta = reflects ? 1 : eta};
}

[[nodiscard]] inline BsdfSample sample_dielectric(const Bsdf& bsdf, const Vec3f& wo, float lobe,
                                                  Vec2f direction) {
  if (bsdf.is_smooth) return sample_smooth_dielectric(bsdf, wo, lobe);
  return sample_rough_dielectric(bsdf, ggx_width(bsdf.alpha), wo, lobe, direction);
}

}  // namespace candela
