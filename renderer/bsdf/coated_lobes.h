// The two lobes of Lambert's surface under a rough coat (coated_diffuse.h), once the coat's table
// has been asked: arithmetic alone, which single paths and loops over lanes share.
#pragma once

#include "renderer/bsdf/fresnel.h"
#include "renderer/bsdf/microfacet.h"
#include "renderer/bsdf/specular_mixture.h"
#include "renderer/math/colour.h"

namespace candela {

// Of one direction wo. The shares are CoatTable's.
struct CoatedLobes {
  float eta = 1.5f;         // of the coat over the outside
  Vec2f widths{1};          // of its microfacets
  Rgb diffuse{0};           // Bsdf::diffuse
  float transmittance = 0;  // of light from wo
  float mean_transmittance = 0;
};

// What the surface below sends back of light from wo.
[[nodiscard]] inline Rgb albedo_below_coat(const Rgb& diffuse, float transmittance,
                                           float mean_transmittance) {
  return diffuse * (transmittance * mean_transmittance);
}

// f |cos_i| of the surface below; the shares of light from wo and from wi that cross the coat.
[[nodiscard]] inline Rgb value_below_coat(const Rgb& diffuse, float transmittance_o,
                                          float transmittance_i, float cos_i) {
  return diffuse * (transmittance_o * transmittance_i * cos_i * inverse_pi);
}

[[nodiscard]] inline float coat_probability(const CoatedLobes& lobes, float cos_o) {
  return specular_probability(
      fresnel_dielectric(cos_o, lobes.eta).reflectance,
      average(albedo_below_coat(lobes.diffuse, lobes.transmittance, lobes.mean_transmittance)));
}

// `transmittance_i`: of light from wi.
[[nodiscard]] inline BsdfEvaluation evaluate_coated_lobes(const CoatedLobes& lobes, const Vec3f& wo,
                                                          const Vec3f& wi, float transmittance_i) {
  if (!(wi.z > 0)) return {};
  const float p_coat = coat_probability(lobes, wo.z);
  MicrofacetReflection reflection = reflect_microfacets(GeometryTerm::Smith, lobes.widths, wo, wi);
  Rgb value = value_below_coat(lobes.diffuse, lobes.transmittance, transmittance_i, wi.z);
  value += fresnel_dielectric(reflection.cos_half, lobes.eta).reflectance * reflection.value;
  return {value, specular_mixture_pdf(p_coat, reflection.pdf, wi.z)};
}

[[nodiscard]] inline Vec3f sample_coated_lobes(const CoatedLobes& lobes, const Vec3f& wo,
                                               float lobe, Vec2f direction) {
  return sample_specular_mixture(coat_probability(lobes, wo.z), lobes.widths, wo, lobe, direction);
}

}  // namespace candela
