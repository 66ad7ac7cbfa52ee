// Triangles that emit the same radiance from each point in each direction of a side.
// Sampled uniformly by area; densities in solid angle are distance^2 / (|cos| area).
#pragma once

#include "renderer/light/light.h"
#include "renderer/sampling/warp.h"

namespace candela {

// Unit, on the side of (v1 - v0) x (v2 - v0).
[[nodiscard]] inline Vec3f triangle_light_normal(const Light& light) {
  const Vec3f& a = light.edge1;
  const Vec3f& b = light.edge2;
  const float scale = 0.5f / light.area;
  return {difference_of_products(a.y, b.z, a.z, b.y) * scale,
          difference_of_products(a.z, b.x, a.x, b.z) * scale,
          difference_of_products(a.x, b.y, a.y, b.x) * scale};
}

// Radiance leaving the triangle towards the unit direction `wo`, which points away from it.
[[nodiscard]] inline Rgb triangle_light_radiance(const Light& light, const Vec3f& normal,
                                                 const Vec3f& wo) {
  const bool is_lit_side = light.emits_both_sides || dot(normal, wo) > 0;
  return is_lit_side ? light.emission : Rgb(0);
}

// The density in solid angle with which the triangle's points are met at `distance` along the unit
// direction `wi`. 0 where grazing makes it overflow: sampling gives up the same points.
[[nodiscard]] inline float triangle_light_pdf(const Light& light, const Vec3f& normal,
                                              const Vec3f& wi, float distance) {
  const float projected_area = std::abs(dot(normal, wi)) * light.area;
  const float pdf = distance * distance / projected_area;
  return pdf <= std::numeric_limits<float>::max() ? pdf : 0.0f;  // neither Inf nor NaN
}

[[nodiscard]] inline LightSample sample_triangle_light(const Light& light, const Vec3f& p,
                                                       Vec2f u) {
  const Vec2f weights = square_to_triangle(u);
  const Vec3f along1 = light.edge1 * weights.x;
  const Vec3f along2 = light.edge2 * weights.y;
  const Vec3f point = light.position + (along1 + along2);
  const Vec3f to_light = point - p;
  const float distance2 = dot(to_light, to_light);
  if (!(distance2 > 0)) return {};
  const float distance = std::sqrt(distance2);
  const Vec3f wi = to_light / distance;
  const Vec3f normal = triangle_light_normal(light);
  const Rgb radiance = triangle_light_radiance(light, normal, -wi);
  if (is_black(radiance)) return {};
  // The edges carry the rounding of v1 - v0, then a product and two sums round again.
  const Vec3f point_error =
      gamma_bound(5) * (glm::abs(light.position) + glm::abs(along1) + glm::abs(along2));
  return {.wi = wi,
          .radiance = radiance,
          .pdf = triangle_light_pdf(light, normal, wi, distance),
          .point = point,
          .point_error = point_error,
          .normal = normal};
}

}  // namespace candela
