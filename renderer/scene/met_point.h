// Where a ray meets a surface of a scene.
#pragma once

#include "renderer/geometry/surface_point.h"
#include "renderer/scene/scene.h"

namespace candela {

// Without texture coordinates, bumps and shading frame; on the side that `wo` is on.
[[nodiscard]] inline SurfacePoint met_point(const Scene& scene, const Hit& hit, const Vec3f& wo) {
  return make_surface_point(scene.geometries[hit.geometry], instance_of(scene, hit), hit, wo,
                            false);
}

}  // namespace candela
