// Quads: two emitting triangles that are one parallelogram, which random numbers that are well
// spread over the square are then well spread over. From afar their points are uniform by area;
// near rectangles, and triangles that may be near, go by near_place.h.
#pragma once

#include "renderer/light/near_place.h"

namespace candela {

[[nodiscard]] inline LightSample sample_quad_light(const Light& light, const SurfacePoint& from,
                                                   Vec2f u) {
  if (is_near(light, from.position)) return sample_near_light(light, from, u);
  return light_from_place(light, from, u);
}

// In solid angle, of what the unit wi meets at `distance`.
[[nodiscard]] inline float quad_light_pdf(const Light& light, const Vec3f& from,
                                          const Vec3f& normal, const Vec3f& wi, float distance) {
  if (is_near(light, from)) return near_place_pdf(light, from, normal, wi, distance);
  return triangle_light_pdf(light, wi, distance);
}

}  // namespace candela
