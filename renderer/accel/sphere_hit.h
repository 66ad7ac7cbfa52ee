// Where a ray meets a sphere. In double, by one function for all accelerators: their answers agree
// to the bit.
#pragma once

#include "renderer/geometry/geometry.h"
#include "renderer/math/ray.h"

namespace candela {

struct SphereHit {
  float t = std::numeric_limits<float>::infinity();  // none
  float u = 0, v = 0;                                // as in Hit

  [[nodiscard]] bool is_hit() const { return t < std::numeric_limits<float>::infinity(); }
};

// The nearest hit with 0 < t <= t_max that `is_there(u, v)` says is no hole. The ray's direction
// need not be unit. Of the origin's distance the part along the ray is taken off first, which
// leaves the discriminant exact to the radius, however far away it is [Haines19]. The square of an
// origin that was moved off the surface by its error bound is told from that of the radius, so that
// the side on which a ray starts is never in doubt.
template <class IsThere>
[[nodiscard]] SphereHit intersect_sphere(const Sphere& sphere, const Ray& ray, float t_max,
                                         const IsThere& is_there) {
  const Vec3d direction(ray.direction);
  const Vec3d from_centre = Vec3d(ray.origin) - Vec3d(sphere.centre);
  const double radius = sphere.radius;
  const double length2 = length_squared(direction);
  const double closest = -dot(from_centre, direction) / length2;
  const Vec3d beside = from_centre + direction * closest;
  const double half_chord2 = (radius * radius - length_squared(beside)) / length2;
  if (!(half_chord2 >= 0)) return {};
  const double half_chord = std::sqrt(half_chord2);
  for (const double t : {closest - half_chord, closest + half_chord}) {
    const auto rounded = static_cast<float>(t);
    if (!(t > 0) || !(rounded > 0) || !(rounded <= t_max)) continue;
    const Vec2f place = to_octahedron(from_centre + direction * t);
    if (is_there(place.x, place.y)) return {rounded, place.x, place.y};
  }
  return {};
}

}  // namespace candela
