// World space <-> the space of an instance's object, of instances that floats can invert. The rest
// can not be hit.
#pragma once

#include <optional>

#include "renderer/base/floating_point_traps.h"
#include "renderer/geometry/geometry.h"
#include "renderer/math/ray.h"

namespace candela {

// World space -> an instance's object space.
struct WorldToObject {
  Vec3f x, y, z, translation;  // p' = x*p.x + y*p.y + z*p.z + translation

  // The direction is not normalised, so that t keeps its meaning.
  [[nodiscard]] Ray apply(const Ray& ray) const {
    const Vec3f& o = ray.origin;
    const Vec3f& d = ray.direction;
    return {x * o.x + y * o.y + z * o.z + translation, x * d.x + y * d.y + z * d.z, ray.t_max};
  }
};

// Embree inverts in floats: the determinant must be one, and more than what rounding leaves of
// columns that are nearly in a plane.
[[nodiscard]] inline bool is_invertible_in_floats(const Instance& instance, double determinant) {
  constexpr float shortest = 4e-13f, longest = 1e12f;  // cubed they are normal floats
  for (const Vec3f& column : {instance.x, instance.y, instance.z}) {
    const float size = max_component(glm::abs(column));
    if (!(size >= shortest && size <= longest)) return false;
  }
  const float rounded = dot(instance.x, cross(instance.y, instance.z));
  return std::abs(double{rounded} - determinant) < 0.1 * std::abs(determinant);
}

// None for an instance that is flat, too small, too large or not finite.
[[nodiscard]] inline std::optional<WorldToObject> world_to_object(const Instance& instance) {
  const FloatingPointTraps traps(Traps::Off);  // a flat one's inverse is infinite
  const Mat3d linear(Vec3d(instance.x), Vec3d(instance.y), Vec3d(instance.z));
  if (!is_invertible_in_floats(instance, glm::determinant(linear))) return std::nullopt;
  const Mat3d inverse = glm::inverse(linear);
  const WorldToObject map{Vec3f(inverse[0]), Vec3f(inverse[1]), Vec3f(inverse[2]),
                          Vec3f(-(inverse * Vec3d(instance.translation)))};
  const bool is_usable =
      is_finite(map.x) && is_finite(map.y) && is_finite(map.z) && is_finite(map.translation);
  return is_usable ? std::optional(map) : std::nullopt;
}

// The box of an instance: of its object's corners, moved.
[[nodiscard]] inline Bounds3f bounds_of(const Instance& instance, const Bounds3f& object) {
  Bounds3f box;
  for (int corner = 0; corner < 8; ++corner) box.include(instance.point(object.corner(corner)));
  return box;
}

}  // namespace candela
