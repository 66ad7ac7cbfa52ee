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

// What of a ray's line is in a sphere, in the ray's t. Of the origin's distance the part along the
// ray is taken off first, which leaves the discriminant exact to the radius, however far away it is
// [Haines19]. The ray's direction need not be unit.
struct SphereChord {
  double middle;
  double half2;  // half of its length, squared; not 0 or more: the line passes by
};
[[nodiscard]] inline SphereChord chord_of(const Vec3d& from_centre, const Vec3d& direction,
                                          double radius) {
  const double length2 = length_squared(direction);
  const double middle = -dot(from_centre, direction) / length2;
  const Vec3d beside = from_centre + direction * middle;
  return {middle, (radius * radius - length_squared(beside)) / length2};
}

// Whether a ray meets the sphere's surface at an end of its chord. Without branches, for loops over
// lanes; not where that is NaN.
[[nodiscard]] inline bool is_on_ray(double t, double t_max) {
  const double rounded = static_cast<float>(t);
  return (t > 0) & (rounded > 0) & (rounded <= t_max);
}

// The nearest hit with 0 < t <= t_max that `is_there(u, v)` says is no hole. The square of an
// origin that was moved off the surface by its error bound is told from that of the radius, so that
// the side on which a ray starts is never in doubt.
template <class IsThere>
[[nodiscard]] SphereHit intersect_sphere(const Sphere& sphere, const Ray& ray, float t_max,
                                         const IsThere& is_there) {
  const Vec3d direction(ray.direction);
  const Vec3d from_centre = Vec3d(ray.origin) - Vec3d(sphere.centre);
  const SphereChord chord = chord_of(from_centre, direction, sphere.radius);
  if (!(chord.half2 >= 0)) return {};
  const double half = std::sqrt(chord.half2);
  for (const double t : {chord.middle - half, chord.middle + half}) {
    if (!is_on_ray(t, t_max)) continue;
    const Vec2f place = to_octahedron(from_centre + direction * t);
    if (is_there(place.x, place.y)) return {static_cast<float>(t), place.x, place.y};
  }
  return {};
}

}  // namespace candela
