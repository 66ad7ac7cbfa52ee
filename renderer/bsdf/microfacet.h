// Reflection by GGX microfacets without its Fresnel term, which the models multiply in.
#pragma once

#include "renderer/bsdf/bsdf.h"
#include "renderer/bsdf/ggx.h"

namespace candela {

// The widths along x and y of models that tell them apart.
[[nodiscard]] inline Vec2f widths_of(const Bsdf& bsdf) {
  return {bsdf.alpha, bsdf.alpha_across};
}

struct MicrofacetReflection {
  float value = 0;     // D G / (4 cos_o): f |cos_i| / F
  float pdf = 0;       // of sample_ggx_reflection()
  float cos_half = 0;  // wo.h = wi.h
};

// G / (4 cos_o cos_i) * cos_i of the two geometry terms, both cosines > 0. Neither blows up at
// grazing angles: cos_i is divided out by hand.
//   Schlick-GGX: G1(c) = c / (c (1 - k) + k), k = (a + 1)^2 / 8 [Karis13, eq. 4]
//   Smith, height-correlated: [Heitz14, eq. 99]
[[nodiscard]] inline float masking_over_cosines(GeometryTerm geometry, float cos_o, float cos_i,
                                                float a) {
  if (geometry == GeometryTerm::SchlickGgx) {
    const float k = square(a + 1) * 0.125f;
    return cos_i / (4 * (cos_o * (1 - k) + k) * (cos_i * (1 - k) + k));
  }
  const float denominator = 2 * (cos_o * smith_root(cos_i, a) + cos_i * smith_root(cos_o, a));
  return denominator > 0 ? cos_i / denominator : 0;
}

[[nodiscard]] inline float masking_over_cosines(GeometryTerm geometry, const Vec3f& wo,
                                                const Vec3f& wi, float a) {
  return masking_over_cosines(geometry, wo.z, wi.z, a);
}
// Smith's alone knows of two widths.
[[nodiscard]] inline float masking_over_cosines(GeometryTerm /*geometry*/, const Vec3f& wo,
                                                const Vec3f& wi, Vec2f a) {
  const float denominator = 2 * (wo.z * smith_root(wi, a) + wi.z * smith_root(wo, a));
  return denominator > 0 ? wi.z / denominator : 0;
}

// wo.h = wi.h = |wo + wi| / 2 of unit vectors: the same bits from both sides.
[[nodiscard]] inline float cosine_to_half_vector(float length2_of_sum) {
  return std::min(1.0f, 0.5f * std::sqrt(length2_of_sum));
}

// `Width`: one number, or two along the frame's x and y.
template <class Width>
[[nodiscard]] inline MicrofacetReflection reflect_microfacets(GeometryTerm geometry, Width a,
                                                              const Vec3f& wo, const Vec3f& wi) {
  if (!(wi.z > 0)) return {};
  Vec3f sum = wo + wi;
  const float length2 = length_squared(sum);
  if (!(length2 > 0)) return {};
  const float distribution = ggx_distribution(sum, a);
  const float value = distribution * masking_over_cosines(geometry, wo, wi, a);
  return {value, ggx_reflection_pdf(distribution, wo, a), cosine_to_half_vector(length2)};
}

}  // namespace candela
