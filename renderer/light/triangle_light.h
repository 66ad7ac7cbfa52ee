// Triangles that emit the same radiance from each point in each direction of a side.
// Sampled uniformly by area; densities in solid angle are distance^2 / (|cos| area).
#pragma once

#include "renderer/light/light.h"
#include "renderer/light/shadow_segment.h"
#include "renderer/sampling/warp.h"

namespace candela {

// Radiance leaving the triangle towards the unit direction `wo`, which points away from it.
[[nodiscard]] inline Rgb triangle_light_radiance(const Light& light, const Vec3f& wo) {
  const bool is_lit_side = light.emits_both_sides || dot(light.normal, wo) > 0;
  return is_lit_side ? light.emission : Rgb(0);
}

// The density in solid angle with which the triangle's points are met at `distance` along the unit
// direction `wi`. 0 where grazing makes it overflow: sampling gives up the same points.
[[nodiscard]] inline float triangle_light_pdf(const Light& light, const Vec3f& wi, float distance) {
  const float projected_area = std::abs(dot(light.normal, wi)) * light.area;
  if (!(projected_area > 0)) return 0;  // within the triangle's plane
  const float pdf = distance * distance / projected_area;
  return pdf <= std::numeric_limits<float>::max() ? pdf : 0.0f;
}

// From the point of a triangle or quad at these weights of its edges, uniform by area.
[[nodiscard]] inline LightSample light_from_place(const Light& light, const SurfacePoint& from,
                                                  Vec2f weights) {
  Vec3f point = light.position + (light.edge1 * weights.x + light.edge2 * weights.y);
  Vec3f to_light = point - from.position;
  const float distance2 = dot(to_light, to_light);
  if (!(distance2 > 0)) return {};
  const float distance = std::sqrt(distance2);
  Vec3f wi = to_light / distance;
  Rgb radiance = triangle_light_radiance(light, -wi);
  if (is_black(radiance)) return {};
  Vec3f end = offset_origin(point, light.normal, light.offset, -wi);
  return {.wi = wi,
          .radiance = radiance,
          .pdf = triangle_light_pdf(light, wi, distance),
          .shadow_ray = shadow_segment(from, wi, end)};
}

[[nodiscard]] inline LightSample sample_triangle_light(const Light& light, const SurfacePoint& from,
                                                       Vec2f u) {
  return light_from_place(light, from, square_to_triangle(u));
}

}  // namespace candela
