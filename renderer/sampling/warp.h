// Maps from the unit square to directions and points, with their densities.
#pragma once

#include "renderer/math/constants.h"
#include "renderer/math/transcendental.h"
#include "renderer/math/vec.h"

namespace candela {

// Uniform on the unit disk, area-preserving and continuous [Shirley97]. The wedge about y is that
// about x with the axes exchanged, so neither needs a branch.
[[nodiscard]] inline Vec2f square_to_disk(Vec2f u) {
  float radius = 2 * u.x - 1;
  float across = 2 * u.y - 1;
  const bool is_about_y = std::abs(across) > std::abs(radius);
  swap_if(is_about_y, radius, across);
  if (radius == 0) return {0, 0};
  SinCos angle = sin_cos_of_octant((pi / 4) * (across / radius));
  Vec2f disk{radius * angle.cos, radius * angle.sin};
  swap_if(is_about_y, disk.x, disk.y);
  return disk;
}

// Density cos(theta) / pi over the hemisphere about z [Malley].
[[nodiscard]] inline Vec3f square_to_cosine_hemisphere(Vec2f u) {
  Vec2f d = square_to_disk(u);
  return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}
[[nodiscard]] inline float cosine_hemisphere_pdf(float cos_theta) {
  return cos_theta > 0 ? cos_theta * inverse_pi : 0;
}

// Density 1 / (2 pi) over the hemisphere about z.
[[nodiscard]] inline Vec3f square_to_uniform_hemisphere(Vec2f u) {
  const float z = u.x;
  const float r = std::sqrt(std::max(0.0f, 1 - z * z));
  SinCos phi = sin_cos_of_turns(u.y);
  return {r * phi.cos, r * phi.sin, z};
}

// Density 1 / (4 pi) over the sphere.
[[nodiscard]] inline Vec3f square_to_uniform_sphere(Vec2f u) {
  const float z = 1 - 2 * u.x;
  const float r = std::sqrt(std::max(0.0f, 1 - z * z));
  SinCos phi = sin_cos_of_turns(u.y);
  return {r * phi.cos, r * phi.sin, z};
}

// Barycentric weights of vertices 1 and 2 of a point uniform on a triangle; continuous, and closer
// in shape to the square than the square-root map [Heitz19].
[[nodiscard]] inline Vec2f square_to_triangle(Vec2f u) {
  return {std::max(u.x - 0.5f * u.y, 0.5f * u.x), std::max(u.y - 0.5f * u.x, 0.5f * u.y)};
}

}  // namespace candela
