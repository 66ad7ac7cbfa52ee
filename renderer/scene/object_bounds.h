// Boxes of a scene's objects, each in the space of its geometries.
#pragma once

#include <vector>

#include "renderer/geometry/geometry_bounds.h"
#include "renderer/scene/scene.h"

namespace candela {

[[nodiscard]] inline Bounds3f bounds_of(const Scene& scene, const Object& object) {
  Bounds3f bounds;
  for (const GeometryHandle handle : object.geometries)
    bounds.include(bounds_of(scene.geometries[handle.index]));
  return bounds;
}

[[nodiscard]] inline std::vector<Bounds3f> bounds_of_objects(const Scene& scene) {
  std::vector<Bounds3f> objects;
  for (const Object& object : scene.objects) objects.push_back(bounds_of(scene, object));
  return objects;
}

}  // namespace candela
