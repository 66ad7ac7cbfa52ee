// The GGX distribution of microfacet normals of width a, Smith's masking, and the sampling of
// visible normals. Local frame: z is the macroscopic normal; wo.z > 0.
//
// a lies in [smallest_ggx_width, 1]. Half vectors are recomputed from pairs of float directions,
// whose rounding (about 1e-7) moves them by that share of the lobe's width: at a = 1e-4 the density
// is good to 0.3 %, below it float breaks. A lobe of 1e-4 is 0.01 degrees wide, a fiftieth of the
// sun; materials with less are smooth (material/bsdf_at.h), models without a smooth form take the
// smallest width. The width is a pure number, so this holds at every scale of scene.
#pragma once

#include "renderer/math/constants.h"
#include "renderer/math/transcendental.h"
#include "renderer/math/vec.h"

namespace candela {

inline constexpr float smallest_ggx_width = 1e-4f;

[[nodiscard]] inline float ggx_width(float alpha) {
  return std::min(1.0f, std::max(smallest_ggx_width, alpha));
}

// D(h) [Walter07, eq. 33] of a vector of any length along h, h.z > 0, written by sin^2 / a^2 so
// that neither end cancels or underflows.
[[nodiscard]] inline float ggx_distribution(const Vec3f& h, float a) {
  const float a2 = a * a;
  const float scaled = h.z * h.z + (h.x * h.x + h.y * h.y) / a2;
  const float ratio = length_squared(h) / scaled;
  return ratio * ratio / (pi * a2);
}

// sqrt(a^2 + (1 - a^2) c^2): Smith's Lambda is (root / c - 1) / 2 [Heitz14, eq. 72].
[[nodiscard]] inline float smith_root(float cos_theta, float a) {
  const float a2 = a * a;
  return std::sqrt(a2 + (1 - a2) * square(cos_theta));
}
[[nodiscard]] inline float smith_g1(float cos_theta, float a) {
  return 2 * cos_theta / (cos_theta + smith_root(cos_theta, a));
}

// A visible normal from the sphere's cap seen along wo, z in (-bound, 1]: the full cap (bound =
// z of the stretched wo) gives D(m) G1(wo) (wo.m) / wo.z [Dupuy23, listing 3]. Zero where float
// leaves no direction.
[[nodiscard]] inline Vec3f sample_ggx_cap(const Vec3f& stretched_wo, float bound, Vec2f a,
                                          Vec2f u) {
  const float z = (1 - u.y) * (1 + bound) - bound;
  const float r = std::sqrt(std::max(0.0f, 1 - z * z));
  SinCos phi = sin_cos_of_turns(u.x);
  Vec3f m = stretched_wo + Vec3f{r * phi.cos, r * phi.sin, z};
  Vec3f normal{a.x * m.x, a.y * m.y, m.z};
  const float length2 = length_squared(normal);
  if (!(length2 > 0) || !(normal.z > 0)) return Vec3f{0};
  return normal / std::sqrt(length2);
}
[[nodiscard]] inline Vec3f sample_ggx_cap(const Vec3f& stretched_wo, float bound, float a,
                                          Vec2f u) {
  return sample_ggx_cap(stretched_wo, bound, Vec2f(a), u);
}

[[nodiscard]] inline Vec3f sample_ggx_visible_normal(const Vec3f& wo, float a, Vec2f u) {
  Vec3f stretched = normalize(Vec3f{a * wo.x, a * wo.y, wo.z});
  return sample_ggx_cap(stretched, stretched.z, a, u);
}
// In solid angle of m, given D(m) and (wo.m) > 0: D G1 (wo.m) / wo.z.
[[nodiscard]] inline float ggx_visible_normal_pdf(float distribution, float cos_half,
                                                  float cos_theta_o, float a) {
  return 2 * distribution * cos_half / (cos_theta_o + smith_root(cos_theta_o, a));
}

// False in programs that measure what the bound is worth (cmake/CompilerOptions.cmake).
#ifdef CANDELA_WITHOUT_GGX_BOUNDS
inline constexpr bool bounds_ggx_caps = false;
#else
inline constexpr bool bounds_ggx_caps = true;
#endif

// The bounded cap leaves out most normals whose reflections go below the surface: k of
// [Eto23, eq. 6] for isotropic a.
[[nodiscard]] inline float ggx_reflection_bound(const Vec3f& wo, float a) {
  if constexpr (!bounds_ggx_caps) return 1;
  const float a2 = a * a;
  const float s2 = square(1 + std::sqrt(wo.x * wo.x + wo.y * wo.y));
  return (1 - a2) * s2 / (s2 + a2 * wo.z * wo.z);
}
// A reflection by the bounded cap. It may still go below the surface: reject it then.
[[nodiscard]] inline Vec3f sample_ggx_reflection(const Vec3f& wo, float a, Vec2f u) {
  Vec3f stretched = normalize(Vec3f{a * wo.x, a * wo.y, wo.z});
  Vec3f m = sample_ggx_cap(stretched, ggx_reflection_bound(wo, a) * stretched.z, a, u);
  return m * (2 * dot(wo, m)) - wo;
}
// In solid angle of wi, given D(h) [Eto23, eq. 8].
[[nodiscard]] inline float ggx_reflection_pdf(float distribution, const Vec3f& wo, float a) {
  return distribution / (2 * (ggx_reflection_bound(wo, a) * wo.z + smith_root(wo.z, a)));
}

// --- of widths that differ: a.x along the frame's x, a.y along y ---
//
// Overloads by directions for both kinds, so that models are written once.

[[nodiscard]] inline Vec2f ggx_width(Vec2f alpha) {
  return {ggx_width(alpha.x), ggx_width(alpha.y)};
}

[[nodiscard]] inline float ggx_distribution(const Vec3f& h, Vec2f a) {
  const float scaled = h.z * h.z + square(h.x / a.x) + square(h.y / a.y);
  const float ratio = length_squared(h) / scaled;
  return ratio * ratio / (pi * a.x * a.y);
}

// [Heitz14], of a unit direction on either side.
[[nodiscard]] inline float smith_root(const Vec3f& w, float a) {
  return smith_root(w.z, a);
}
[[nodiscard]] inline float smith_root(const Vec3f& w, Vec2f a) {
  return std::sqrt(square(a.x * w.x) + square(a.y * w.y) + square(w.z));
}
[[nodiscard]] inline float smith_g1(const Vec3f& w, float a) {
  return smith_g1(std::abs(w.z), a);
}
[[nodiscard]] inline float smith_g1(const Vec3f& w, Vec2f a) {
  const float cos_theta = std::abs(w.z);
  return 2 * cos_theta / (cos_theta + smith_root(w, a));
}

[[nodiscard]] inline Vec3f sample_ggx_visible_normal(const Vec3f& wo, Vec2f a, Vec2f u) {
  Vec3f stretched = normalize(Vec3f{a.x * wo.x, a.y * wo.y, wo.z});
  return sample_ggx_cap(stretched, stretched.z, a, u);
}
[[nodiscard]] inline float ggx_visible_normal_pdf(float distribution, float cos_half,
                                                  const Vec3f& wo, float a) {
  return ggx_visible_normal_pdf(distribution, cos_half, wo.z, a);
}
[[nodiscard]] inline float ggx_visible_normal_pdf(float distribution, float cos_half,
                                                  const Vec3f& wo, Vec2f a) {
  return 2 * distribution * cos_half / (wo.z + smith_root(wo, a));
}

// By the smaller width [Eto23].
[[nodiscard]] inline float ggx_reflection_bound(const Vec3f& wo, Vec2f a) {
  return ggx_reflection_bound(wo, std::min(a.x, a.y));
}
[[nodiscard]] inline Vec3f sample_ggx_reflection(const Vec3f& wo, Vec2f a, Vec2f u) {
  Vec3f stretched = normalize(Vec3f{a.x * wo.x, a.y * wo.y, wo.z});
  Vec3f m = sample_ggx_cap(stretched, ggx_reflection_bound(wo, a) * stretched.z, a, u);
  return m * (2 * dot(wo, m)) - wo;
}
[[nodiscard]] inline float ggx_reflection_pdf(float distribution, const Vec3f& wo, Vec2f a) {
  return distribution / (2 * (ggx_reflection_bound(wo, a) * wo.z + smith_root(wo, a)));
}

}  // namespace candela
