// A pane: both interfaces and all reflections between them at once, straight through.
// bsdf.eta.x is the pane's index over that of both sides; each crossing of an interface is tinted
// by `transmittance`.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/dielectric.h"
#include "renderer/bsdf/fresnel.h"
#include "renderer/bsdf/mirror.h"
#include "renderer/math/colour.h"
#include "renderer/sampling/drawable_probability.h"

namespace candela {

struct PaneReflectance {
  Rgb reflected{0};
  Rgb transmitted{0};
};

// With one interface's F and the tint t of two crossings, the geometric series
//   R = F + t (1-F)^2 F (1 + F^2 + ...), T = t (1-F)^2 (1 + F^2 + ...), 1 / (1 - F^2) in sum.
[[nodiscard]] inline PaneReflectance pane_reflectance(const Bsdf& bsdf, float cos_theta) {
  const float f = fresnel_dielectric(cos_theta, bsdf.eta.x).reflectance;
  Rgb transmitted = bsdf.transmittance * bsdf.transmittance * ((1 - f) / (1 + f));
  return {Rgb{f} + transmitted * f, transmitted};
}

[[nodiscard]] inline BsdfSample sample_thin_dielectric(const Bsdf& bsdf, const Vec3f& wo,
                                                       float lobe) {
  const PaneReflectance pane = pane_reflectance(bsdf, wo.z);
  const float reflected = average(pane.reflected);
  const float transmitted = average(pane.transmitted);
  if (!(reflected + transmitted > 0)) return {};
  const float p_reflect = drawable_share(reflected, transmitted);
  if (lobe < p_reflect) return mirror_sample(wo, pane.reflected / p_reflect);
  return refraction_sample(-wo, pane.transmitted / (1 - p_reflect), 1);
}

}  // namespace candela
