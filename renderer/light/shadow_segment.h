// The ray between a surface and a point of a light.
#pragma once

#include "renderer/geometry/surface_point.h"

namespace candela {

inline constexpr float shadow_segment_end = 1 - gamma_bound(16);

// From just off the surface to `end`; `to_light` tells on which side. The last few ulps are left
// out, since the intersector's own t is rounded too.
[[nodiscard]] inline Ray shadow_segment(const SurfacePoint& from, const Vec3f& to_light,
                                        const Vec3f& end) {
  Vec3f origin = offset_origin(from.position, from.geometric_normal, from.offset, to_light);
  return {origin, end - origin, shadow_segment_end};
}

// The rest of a shadow ray, to the same end, from behind a surface that it met; t_max 0 where that
// lies past the end.
[[nodiscard]] inline Ray shadow_ray_behind(const Ray& ray, const SurfacePoint& met) {
  const Vec3f origin = offset_origin(met.position, met.geometric_normal, met.offset, ray.direction);
  if (ray.t_max == infinity) return {origin, ray.direction, infinity};
  const Vec3f to_end = ray.origin + ray.direction - origin;
  return {origin, to_end, dot(to_end, ray.direction) <= 0 ? 0.0f : ray.t_max};
}

}  // namespace candela
