// Quads: two emitting triangles that are one parallelogram, which random numbers that are well
// spread over the square are then well spread over. From afar their points are uniform by area.
// Near a rectangle, whose parts are then seen at very different sizes, they are uniform in solid
// angle, warped by the cosine at the receiving surface [Hart20]. Which of both is a function of the
// light and the place alone, so that the density of what a path meets is known.
#pragma once

#include "renderer/light/triangle_light.h"

namespace candela {

[[nodiscard]] inline bool is_near(const Light& light, const Vec3f& from) {
  Vec3f middle = light.position + (light.edge1 + light.edge2) * 0.5f;
  Vec3f to_middle = middle - from;
  return dot(to_middle, to_middle) < light.near_distance2;
}

// `normal`: SurfacePoint::receiving_normal.
struct NearQuadSample {
  Vec2f weights{0};     // of the edges
  float pdf = 0;        // in solid angle; 0: by area, since the quad is seen nearly edge on
  bool is_seen = true;  // false: all of it is below the receiver's horizon
};
[[nodiscard]] NearQuadSample sample_near_place(const Light& light, const Vec3f& from,
                                               const Vec3f& normal, Vec2f u);
// In solid angle, of the place that the unit wi meets at `distance`.
[[nodiscard]] float near_quad_pdf(const Light& light, const Vec3f& from, const Vec3f& normal,
                                  const Vec3f& wi, float distance);

[[nodiscard]] inline LightSample sample_near_quad(const Light& light, const SurfacePoint& from,
                                                  Vec2f u) {
  if (!light.emits_both_sides && !(dot(light.normal, from.position - light.position) > 0))
    return {};
  NearQuadSample place = sample_near_place(light, from.position, from.receiving_normal, u);
  if (!place.is_seen) return {};
  LightSample sample = light_from_place(light, from, place.weights);
  if (place.pdf > 0 && sample.is_valid()) sample.pdf = place.pdf;
  return sample;
}

[[nodiscard]] inline LightSample sample_quad_light(const Light& light, const SurfacePoint& from,
                                                   Vec2f u) {
  if (is_near(light, from.position)) return sample_near_quad(light, from, u);
  return light_from_place(light, from, u);
}

// In solid angle, of what the unit wi meets at `distance`.
[[nodiscard]] inline float quad_light_pdf(const Light& light, const Vec3f& from,
                                          const Vec3f& normal, const Vec3f& wi, float distance) {
  if (is_near(light, from)) return near_quad_pdf(light, from, normal, wi, distance);
  return triangle_light_pdf(light, wi, distance);
}

}  // namespace candela
