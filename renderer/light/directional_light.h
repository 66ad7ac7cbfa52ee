// Light from one direction, infinitely far away.
#pragma once

#include "renderer/geometry/surface_point.h"
#include "renderer/light/light.h"

namespace candela {

[[nodiscard]] inline LightSample sample_directional_light(const Light& light,
                                                          const SurfacePoint& from) {
  return {.wi = light.position,
          .radiance = light.emission,
          .pdf = 1,
          .is_delta = true,
          .shadow_ray = spawn_ray(from, light.position)};
}

}  // namespace candela
