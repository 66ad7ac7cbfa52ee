// Light from one point, in all directions alike or within a cone.
// Irradiance on a facing surface is I(w) / distance^2, with I the radiant intensity.
#pragma once

#include "renderer/light/light.h"
#include "renderer/light/shadow_segment.h"

namespace candela {

// The share of the axial intensity that a spot light sends towards the unit direction `w`:
// 1 within the inner angle, 0 outside the outer one, Hermite's 3t^2 - 2t^3 of the cosine between.
[[nodiscard]] inline float spot_falloff(const Light& light, const Vec3f& w) {
  // For unit vectors 1 - cos = |a - b|^2 / 2, without the cancellation of 1 - dot(a, b).
  Vec3f difference = w - light.edge1;
  const float versine = 0.5f * dot(difference, difference);
  if (versine <= light.versine_inner) return 1;
  if (!(versine < light.versine_outer)) return 0;
  const float t = (light.versine_outer - versine) / (light.versine_outer - light.versine_inner);
  return t * t * (3 - 2 * t);
}

// `share(w)`: of the intensity, towards the unit direction w.
template <class Share>
[[nodiscard]] inline LightSample sample_from_point(const Light& light, const SurfacePoint& from,
                                                   const Share& share) {
  Vec3f to_light = light.position - from.position;
  const float distance2 = dot(to_light, to_light);
  if (!(distance2 > 0)) return {};
  Vec3f wi = to_light / std::sqrt(distance2);
  Rgb irradiance = light.emission * (share(-wi) / distance2);
  // Nothing outside of the cone; and nearer than floats can tell, the irradiance has no value.
  if (is_black(irradiance) || !is_finite(irradiance)) return {};
  return {.wi = wi,
          .radiance = irradiance,
          .pdf = 1,
          .is_delta = true,
          .shadow_ray = shadow_segment(from, to_light, light.position)};
}

[[nodiscard]] inline LightSample sample_point_light(const Light& light, const SurfacePoint& from) {
  return sample_from_point(light, from, [&](const Vec3f& w) {
    return light.kind == LightKind::Spot ? spot_falloff(light, w) : 1.0f;
  });
}

}  // namespace candela
