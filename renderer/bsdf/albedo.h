// Estimates of the directional albedo, for AOVs and denoisers: exact for Diffuse, Mirror and smooth
// surfaces; for rough reflection own fits to integrals of D G, good to about 0.1; glass counts what
// crosses it as its own (1 for clear glass). Energy, so without the 1 / eta^2 of radiance.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/coated_conductor.h"
#include "renderer/bsdf/coated_diffuse.h"
#include "renderer/bsdf/compensated_cook_torrance.h"
#include "renderer/bsdf/conductor.h"
#include "renderer/bsdf/cook_torrance.h"
#include "renderer/bsdf/dielectric.h"
#include "renderer/bsdf/lab.h"
#include "renderer/bsdf/thin_dielectric.h"

namespace candela {

// The share of light that leaves microfacets of reflectance 1 after one bounce: 1 - ln 2 at normal
// incidence for a = 1, 1 for a smooth surface.
[[nodiscard]] inline float microfacet_albedo(GeometryTerm geometry, float a, float cos_o) {
  const float a2 = a * a;
  const float kept = 1 - 1.386f * a2 / (1 + a2) * std::sqrt(cos_o);
  if (geometry == GeometryTerm::Smith) return kept;
  const float k = square(a + 1) * 0.125f;
  const float c = smith_root(cos_o, std::min(a, 0.5f));
  const float g = c / (c * (1 - k) + k);
  return kept * g * (g + a * (1 - g));
}

// A rough surface's mean reflectance lies nearer to that of normal incidence.
[[nodiscard]] inline Rgb rough_reflectance(const Rgb& normal, const Rgb& at_angle, float a) {
  return normal + (at_angle - normal) / (1 + 20 * a);
}

[[nodiscard]] inline Rgb cook_torrance_albedo(const Bsdf& bsdf, float cos_o) {
  const float a = ggx_width(bsdf.alpha);
  Rgb fresnel =
      rough_reflectance(cook_torrance_fresnel(bsdf, 1), cook_torrance_fresnel(bsdf, cos_o), a);
  return bsdf.diffuse + bsdf.specular * fresnel * microfacet_albedo(bsdf.geometry, a, cos_o);
}

[[nodiscard]] inline Rgb lab_albedo(const Bsdf& bsdf, float cos_o) {
  const float a = ggx_width(bsdf.alpha);
  Rgb at_angle = lab_fresnel(bsdf.specular, cos_o);
  // The cosine-weighted mean of (1 - cos)^5 over the hemisphere is 1 / 21.
  const float f90 = std::min(1.0f, 50 * max_component(bsdf.specular));
  Rgb mean = bsdf.specular + (Rgb{f90} - bsdf.specular) / 21.0f;
  return bsdf.diffuse * (Rgb{1} - at_angle) * (Rgb{1} - mean) +
         rough_reflectance(bsdf.specular, at_angle, a) *
             microfacet_albedo(GeometryTerm::Smith, a, cos_o);
}

[[nodiscard]] inline Rgb conductor_albedo(const Bsdf& bsdf, float cos_o) {
  Rgb at_angle = fresnel_conductor(cos_o, bsdf.eta, bsdf.k);
  if (bsdf.is_smooth) return at_angle;
  const float a = ggx_width(bsdf.alpha);
  return rough_reflectance(fresnel_conductor(1, bsdf.eta, bsdf.k), at_angle, a) *
         microfacet_albedo(GeometryTerm::Smith, a, cos_o);
}

[[nodiscard]] inline Rgb dielectric_albedo(const Bsdf& bsdf, float cos_o) {
  const float reflectance = fresnel_dielectric(cos_o, bsdf.eta.x).reflectance;
  return Rgb{reflectance} + bsdf.transmittance * (1 - reflectance);
}

// What the coat reflects, by a fit, and the rest exactly.
[[nodiscard]] inline Rgb coated_diffuse_whole_albedo(const Bsdf& bsdf, float cos_o) {
  const float eta = bsdf.coat->eta();
  const Rgb at_angle{fresnel_dielectric(cos_o, eta).reflectance};
  const Rgb below = coated_diffuse_albedo(bsdf, cos_o);
  if (has_smooth_coat(bsdf)) return at_angle + below;
  const float a = ggx_width(mean_coat_width(bsdf));
  return rough_reflectance(Rgb{normal_reflectance(eta)}, at_angle, a) *
             microfacet_albedo(GeometryTerm::Smith, a, cos_o) +
         below;
}

[[nodiscard]] inline Rgb unclamped_albedo(const Bsdf& bsdf, float cos_o) {
  switch (bsdf.model) {
    case BsdfModel::Diffuse:
    case BsdfModel::Mirror:
      return bsdf.diffuse;
    case BsdfModel::CookTorrance:
      return cook_torrance_albedo(bsdf, cos_o);
    case BsdfModel::Lab:
      return lab_albedo(bsdf, cos_o);
    case BsdfModel::Conductor:
      return conductor_albedo(bsdf, cos_o);
    case BsdfModel::Dielectric:
      return dielectric_albedo(bsdf, cos_o);
    case BsdfModel::ThinDielectric: {
      const PaneReflectance pane = pane_reflectance(bsdf, cos_o);
      return pane.reflected + pane.transmitted;
    }
    case BsdfModel::CompensatedCookTorrance:
      return cook_torrance_albedo(bsdf, cos_o) + multiple_albedo(bsdf, cos_o);
    case BsdfModel::DiffuseTransmission:
      return bsdf.diffuse + bsdf.transmittance;
    case BsdfModel::CoatedDiffuse:
      return coated_diffuse_whole_albedo(bsdf, cos_o);
    case BsdfModel::CoatedConductor:
      return coated_conductor_albedo(bsdf, cos_o);
    case BsdfModel::AnisotropicConductor: {
      Bsdf mean = bsdf;
      mean.alpha = std::sqrt(bsdf.alpha * bsdf.alpha_across);
      return conductor_albedo(mean, cos_o);
    }
    case BsdfModel::AnisotropicDielectric:
      return dielectric_albedo(bsdf, cos_o);
  }
  return Rgb{0};
}

// In [0, 1], never NaN.
[[nodiscard]] inline Rgb albedo_estimate(const Bsdf& bsdf, const Vec3f& wo) {
  return clamp_unit(unclamped_albedo(bsdf, clamp_unit(wo.z)));
}

}  // namespace candela
