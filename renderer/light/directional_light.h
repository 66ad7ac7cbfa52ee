// Light from one direction, infinitely far away.
#pragma once

#include "renderer/light/light.h"

namespace candela {

[[nodiscard]] inline LightSample sample_directional_light(const Light& light) {
  return {.wi = light.position,
          .radiance = light.emission,
          .pdf = 1,
          .is_delta = true,
          .is_infinite = true};
}

}  // namespace candela
