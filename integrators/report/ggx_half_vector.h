// The report's sampling of rough reflections: a half vector h by D(h) (n.h), mirrored about it.
// Local frame: z is the macroscopic normal n; wo.z > 0; a is the GGX width.
//
// Half vectors do not know wo, so some reflections go below the surface: those samples bring
// nothing, and the density integrates to the fraction above (docs/report.md, 3.9). The path
// integrator samples the normals that wo sees (renderer/bsdf/ggx.h), which is why it is less noisy.
#pragma once

#include "renderer/bsdf/ggx.h"

namespace candela {

// theta = arccos sqrt((1 - u) / (u (a^2 - 1) + 1)) [Walter07, eq. 35], by its sine and cosine; unit
// length, density D(h) (n.h).
[[nodiscard]] inline Vec3f sample_ggx_half_vector(float a, Vec2f u) {
  const float sine = a * std::sqrt(u.x);
  const float cosine = std::sqrt(1 - u.x);
  const float length = std::sqrt(sine * sine + cosine * cosine);
  const SinCos phi = sin_cos_of_turns(u.y);
  return Vec3f{sine * phi.cos, sine * phi.sin, cosine} / length;
}

[[nodiscard]] inline Vec3f reflect_about(const Vec3f& wo, const Vec3f& h) {
  return h * (2 * dot(wo, h)) - wo;
}

// In solid angle of wi: D(h) (n.h) / (4 (wo.h)) [Walter07, eqs. 14 and 24]; 0 below the surface.
[[nodiscard]] inline float ggx_half_vector_pdf(const Vec3f& wo, const Vec3f& wi, float a) {
  if (!(wi.z > 0)) return 0;
  const Vec3f sum = wo + wi;  // 2 (wo.h) h
  const float length2 = length_squared(sum);
  return length2 > 0 ? ggx_distribution(sum, a) * sum.z / (2 * length2) : 0;
}

}  // namespace candela
