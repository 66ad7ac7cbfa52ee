// A metal under a dielectric coat, either of them smooth or GGX-rough.
//
//   f = F D G / (4 cos_o cos_i) + S(o) S(i) T(o) T(i) / eta^2 * F' D' G' / (4 cos_o' cos_i')
//
// The first term is what the coat reflects. The second is the metal's reflection between the
// directions that the coat's mean surface refracts o and i to (dashed), with T, the share of light
// that crosses the coat (coat_table.h), and of a lobe as wide as the metal's and the coat's two
// crossings together. S makes its albedo that of light between the layers followed bounce by bounce
// (coated_metal_table.h), colour by colour; the shape of what bounces more than once is thus taken
// for that of one bounce. Where both are smooth, all of it goes one way, and the series of bounces
// is summed.
//
// bsdf.eta and bsdf.k are relative to the coat. Not inline: so that kernels stay as small as they
// are without it.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/coat_table.h"

namespace candela {

// Of a metal of width `metal` seen through a coat of width `coat`. Near normal incidence a
// microfacet's slope m turns what crosses it by (1 - 1 / eta) m, twice, and a metal's by 2 m.
[[nodiscard]] inline float coated_metal_width(float eta, float coat, float metal) {
  return std::sqrt(square(metal) + 0.5f * square((1 - 1 / eta) * coat));
}

// The metal's term alone, and a direction of its density; z <= 0 where none leaves the coat.
[[nodiscard]] BsdfEvaluation evaluate_coated_metal(const Bsdf& bsdf, const Vec3f& wo,
                                                   const Vec3f& wi);
[[nodiscard]] Vec3f sample_coated_metal(const Bsdf& bsdf, const Vec3f& wo, Vec2f direction);

// A rough value of the whole's albedo; exact where both are smooth.
[[nodiscard]] Rgb coated_conductor_albedo(const Bsdf& bsdf, float cos_o);

[[nodiscard]] BsdfEvaluation evaluate_coated_conductor(const Bsdf& bsdf, const Vec3f& wo,
                                                       const Vec3f& wi);
[[nodiscard]] BsdfSample sample_coated_conductor(const Bsdf& bsdf, const Vec3f& wo, float lobe,
                                                 Vec2f direction);

}  // namespace candela
