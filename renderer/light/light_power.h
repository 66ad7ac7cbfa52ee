// How much light a light sends, for choosing among lights.
#pragma once

#include "renderer/light/environment.h"
#include "renderer/light/light.h"

namespace candela {

// Flux by luminance: what leaves lights within the scene; what meets the scene's bounding disc
// (pi r^2) from directional and environment lights. 0: the light is black. `environment` may be
// null where the light is none.
[[nodiscard]] double light_power(const Light& light, const Environment* environment,
                                 double scene_radius);

}  // namespace candela
