// A step of validate(): lights.
#pragma once

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela::description {

// Numbers finite, none negative, directions unit, triangles with an area, environments seen by
// cameras either all or none.
void check_lights(const SceneDescription& scene, Diagnostics& diagnostics);

// Light from infinitely far away, from everywhere.
[[nodiscard]] bool is_environment(const Light& light);

// An environment that cameras see, and not a black one.
[[nodiscard]] bool is_seen_sky(const Light& light);

// Sends out nothing, whatever is around it.
[[nodiscard]] bool is_black(const Light& light);

}  // namespace candela::description
