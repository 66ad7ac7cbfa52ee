// Lamps that are sampled by solid angle where they are near, warped by the cosine at the receiving
// surface [Hart20]: rectangles (near_rectangle.h) and triangles (near_triangle.h). Whether by solid
// angle or by area is a function of the light and the place alone, so that the density of what a
// path meets is known. Out of line: the kernels hold what is sampled by area.
#pragma once

#include "renderer/light/triangle_light.h"

namespace candela {

[[nodiscard]] inline bool is_near(const Light& light, const Vec3f& from) {
  Vec3f middle = light.position + (light.edge1 + light.edge2) * 0.5f;
  Vec3f to_middle = middle - from;
  return !(dot(to_middle, to_middle) > light.near_distance2);
}

struct NearPlace {
  Vec2f weights{0};     // of the edges
  float pdf = 0;        // in solid angle; 0: by area
  bool is_seen = true;  // false: all of it is below the receiver's horizon
};
// Of a Quad, or of a triangle that is sampled so. `normal`: SurfacePoint::receiving_normal.
[[nodiscard]] NearPlace sample_near_place(const Light& light, const Vec3f& from,
                                          const Vec3f& normal, Vec2f u);
// In solid angle, of the place that the unit wi meets at `distance`.
[[nodiscard]] float near_place_pdf(const Light& light, const Vec3f& from, const Vec3f& normal,
                                   const Vec3f& wi, float distance);

[[nodiscard]] inline bool is_on_lit_side(const Light& light, const Vec3f& from) {
  return light.emits_both_sides || dot(light.normal, from - light.position) > 0;
}

[[nodiscard]] inline LightSample light_from_near_place(const Light& light, const SurfacePoint& from,
                                                       const NearPlace& place) {
  if (!place.is_seen) return {};
  LightSample sample = light_from_place(light, from, place.weights);
  if (place.pdf > 0 && sample.is_valid()) sample.pdf = place.pdf;
  return sample;
}

[[nodiscard]] inline LightSample sample_near_light(const Light& light, const SurfacePoint& from,
                                                   Vec2f u) {
  if (!is_on_lit_side(light, from.position)) return {};
  return light_from_near_place(light, from,
                               sample_near_place(light, from.position, from.receiving_normal, u));
}

}  // namespace candela
