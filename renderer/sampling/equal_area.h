// The unit square <-> the sphere, of equal areas: an octahedron unfolded [Clarberg08]. The centre
// is +z, the corners -z; +x is the middle of the right edge (x = 1), +y of the edge y = 1.
#pragma once

#include "renderer/math/constants.h"
#include "renderer/math/transcendental.h"
#include "renderer/math/vec.h"

namespace candela {

// A unit direction; density 1 / (4 pi).
[[nodiscard]] inline Vec3f square_to_equal_area_sphere(Vec2f p) {
  const float u = 2 * p.x - 1;
  const float v = 2 * p.y - 1;
  const float across = std::abs(u);
  const float along = std::abs(v);
  const float from_diagonal = 1 - (across + along);  // > 0: the upper half
  const float r = 1 - std::abs(from_diagonal);
  // The azimuth from the diagonal of its quarter, in [-pi/4, pi/4].
  const float turn = r > 0 ? (along - across) / r : 0;
  SinCos from_middle = sin_cos_of_octant((pi / 4) * turn);
  constexpr float root_half = 0.70710678f;
  const float cosine = std::max(0.0f, root_half * (from_middle.cos - from_middle.sin));
  const float sine = std::max(0.0f, root_half * (from_middle.cos + from_middle.sin));
  const float sin_theta = r * std::sqrt(std::max(0.0f, 2 - r * r));
  return {std::copysign(cosine, u) * sin_theta, std::copysign(sine, v) * sin_theta,
          std::copysign(1 - r * r, from_diagonal)};
}

// Where the square goes on beyond its edges: each is folded about its middle [pbrt-v4,
// util/math.cpp: WrapEqualAreaSquare]. Of a point some units away at most, in [0, 1]^2.
[[nodiscard]] inline Vec2f wrap_equal_area_square(Vec2f p) {
  const auto is_within = [](float x) { return x >= 0 && x <= 1; };
  while (!is_within(p.x)) p = {(p.x < 0 ? 0.0f : 2.0f) - p.x, 1 - p.y};
  while (!is_within(p.y)) p = {1 - p.x, (p.y < 0 ? 0.0f : 2.0f) - p.y};
  return p;
}

// The inverse, of any direction whose square is a float and not 0; in [0, 1]^2.
[[nodiscard]] inline Vec2f equal_area_sphere_to_square(const Vec3f& d) {
  const float across = std::abs(d.x);
  const float along = std::abs(d.y);
  const float sin2_theta = d.x * d.x + d.y * d.y;
  const float size = std::sqrt(sin2_theta + d.z * d.z);
  // r = sqrt(1 - |z|), which would cancel near the poles.
  const float r = std::sqrt(sin2_theta / (size * (size + std::abs(d.z))));
  const float azimuth = sin2_theta > 0 ? arc_tangent(along, across) : 0;
  float v = r * azimuth * (2 * inverse_pi);
  float u = r - v;
  if (d.z < 0) {  // folded outwards over the diagonal
    const float folded = 1 - v;
    v = 1 - u;
    u = folded;
  }
  const auto to_unit = [](float x) { return std::clamp(0.5f * x + 0.5f, 0.0f, 1.0f); };
  return {to_unit(std::copysign(u, d.x)), to_unit(std::copysign(v, d.y))};
}

}  // namespace candela
