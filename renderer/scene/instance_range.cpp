#include "renderer/scene/instance_range.h"

#include <algorithm>

#include "renderer/geometry/world_to_object.h"
#include "renderer/scene/triangle_sort.h"

namespace candela {
namespace {

double farthest(const Bounds3f& bounds) {
  if (bounds.is_empty()) return 0;
  return std::max(max_component(glm::abs(bounds.lower)), max_component(glm::abs(bounds.upper)));
}

}  // namespace

bool is_placeable(const Instance& instance, const Bounds3f& object) {
  if (object.is_empty()) return true;  // nothing is placed
  const FloatingPointTraps traps(Traps::Off);
  return world_to_object(instance) && farthest(bounds_of(instance, object)) < out_of_reach_at;
}

bool is_large_ground(const Instance& instance, const Bounds3f& object, std::size_t triangles) {
  constexpr double large = 1e4;
  constexpr std::size_t few = 4096;
  return triangles > 0 && triangles <= few && !object.is_empty() &&
         max_component(bounds_of(instance, object).extent()) > large;
}

double farthest_origin(const Instance& instance) {
  constexpr double largest = 1e17;  // Embree refuses 1.8e18
  const std::optional<WorldToObject> inverse = world_to_object(instance);
  if (!inverse) return 0;
  double factor = 0;
  for (const Vec3f& column : {inverse->x, inverse->y, inverse->z})
    factor += max_component(glm::abs(column));
  return largest / factor - max_component(glm::abs(Vec3d(instance.translation)));
}

double reach_of_rays(const Scene& scene, const Bounds3f& world, std::span<const Bounds3f> objects) {
  double reach = std::max(1.0, farthest(world));
  for (const Instance& instance : scene.instances) {
    const Bounds3f& object = objects[instance.object.index];
    if (!object.is_empty()) reach = std::max(reach, farthest(bounds_of(instance, object)));
  }
  for (const Camera& camera : scene.cameras)
    for (const Vec3f& part : {camera.eye, camera.right, camera.up, Vec3f(camera.lens_radius)})
      reach = std::max<double>(reach, max_component(glm::abs(part)));
  return std::min<double>(reach, farthest_traceable);
}

}  // namespace candela
