// Boxes about compiled surfaces, in the space of their geometry.
#pragma once

#include "renderer/geometry/geometry.h"
#include "renderer/math/bounds.h"

namespace candela {

// A little wider than the sphere, for rounding of what is tested against it.
[[nodiscard]] inline Bounds3f bounds_of(const Sphere& sphere) {
  constexpr float wider = 0x1p-20f;
  const float reach = max_component(glm::abs(sphere.centre)) + sphere.radius;
  const Vec3f half(sphere.radius + reach * wider);
  return {sphere.centre - half, sphere.centre + half};
}

// Empty for a geometry without triangles and spheres.
[[nodiscard]] inline Bounds3f bounds_of(const Geometry& geometry) {
  Bounds3f bounds;
  for (const Vec3f& position : geometry.positions) bounds.include(position);
  for (const Sphere& sphere : geometry.spheres) bounds.include(bounds_of(sphere));
  return bounds;
}

}  // namespace candela
