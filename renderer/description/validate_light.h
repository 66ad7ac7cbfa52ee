// A step of validate(): lights.
#pragma once

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela::description {

// Numbers finite, none negative, directions unit, triangles with an area, at most one environment.
void check_lights(const SceneDescription& scene, Diagnostics& diagnostics);

// Sends out nothing, whatever is around it.
[[nodiscard]] bool is_black(const Light& light);

}  // namespace candela::description
