// Spheres, in the space of their geometry, and directions from their centres: two numbers of a hit
// tell where it lies to an ulp of the radius.
#pragma once

#include "renderer/math/constants.h"
#include "renderer/math/transcendental.h"
#include "renderer/math/vec.h"

namespace candela {

struct Sphere {
  Vec3f centre{0};
  float radius = 1;
  Vec3f x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  // unit: its own axes, perhaps mirrored
  bool faces_inwards = false;                // its geometric normal
};

// A direction of any length as a point of [-1, 1]^2: the octahedron, unfolded [Cigolle14]. Errors
// of a rounding of the numbers move the direction by less than 2^-22.
[[nodiscard]] inline Vec2f to_octahedron(const Vec3d& d) {
  const double size = sum_of_absolutes(d);
  const double u = d.x / size;
  const double v = d.y / size;
  if (d.z >= 0) return {static_cast<float>(u), static_cast<float>(v)};
  return {static_cast<float>(std::copysign(1 - std::abs(v), u)),
          static_cast<float>(std::copysign(1 - std::abs(u), v))};
}

// Unit.
[[nodiscard]] inline Vec3f from_octahedron(Vec2f p) {
  const float z = (1 - std::abs(p.x)) - std::abs(p.y);
  Vec3f d{p.x, p.y, z};
  if (z < 0) d = {std::copysign(1 - std::abs(p.y), p.x), std::copysign(1 - std::abs(p.x), p.y), z};
  return d / std::sqrt(dot(d, d));
}

// The unit direction in the sphere's own axes.
[[nodiscard]] inline Vec3f in_own_axes(const Sphere& sphere, const Vec3f& d) {
  return {dot(d, sphere.x), dot(d, sphere.y), dot(d, sphere.z)};
}

// pbrt's coordinates of the point in the unit direction d from the centre: u around z from x on, v
// from -z to z; at the poles u = 0.
[[nodiscard]] inline Vec2f sphere_uv(const Sphere& sphere, const Vec3f& d) {
  const Vec3f own = in_own_axes(sphere, d);
  const float across = std::sqrt(own.x * own.x + own.y * own.y);
  const float turn = across > 0 ? arc_tangent(own.y, own.x) * (0.5f * inverse_pi) : 0.0f;
  return {turn < 0 ? turn + 1 : turn, 1 - arc_tangent(across, own.z) * inverse_pi};
}

}  // namespace candela
