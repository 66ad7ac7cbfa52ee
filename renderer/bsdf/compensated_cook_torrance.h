// CookTorrance with Smith's masking and a further lobe for the light that is reflected more than
// once between microfacets, which one bounce loses: `energy_compensation: true`.
//
//   f = kd / pi + ks (F D G / (4 cos_o cos_i) + F_ms (1 - E(o)) (1 - E(i)) / (pi (1 - E_avg)))
//
// [Kulla17]. The lobe is reciprocal and returns all that is lost where F = 1. Else F_ms is what the
// series of bounces leaves, F_avg^2 E_avg (1 + F_avg (1 - E_avg) + ...), so colours saturate as on
// real metal. kd + ks <= 1 still keeps the energy, to the table's accuracy.
//
// Not inline: so that kernels stay as small as they are without it.
#pragma once

#include "renderer/bsdf/bsdf.h"

namespace candela {

// The share of directions that follow the GGX lobe; the others are cosine-weighted.
[[nodiscard]] float compensated_specular_probability(const Bsdf& bsdf, float cos_o);

// What the further lobe gives back of the light from cos_o.
[[nodiscard]] Rgb multiple_albedo(const Bsdf& bsdf, float cos_o);

[[nodiscard]] BsdfEvaluation evaluate_compensated(const Bsdf& bsdf, const Vec3f& wo,
                                                  const Vec3f& wi);
[[nodiscard]] BsdfSample sample_compensated(const Bsdf& bsdf, const Vec3f& wo, float lobe,
                                            Vec2f direction);

}  // namespace candela
