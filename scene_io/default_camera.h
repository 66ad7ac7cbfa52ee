// A camera for scenes that bring none.
#pragma once

#include "renderer/description/scene_description.h"

namespace candela {

// Sees the scene's bounds from the front (+z), a little from above, at 45 degrees.
[[nodiscard]] description::Camera default_camera(const description::SceneDescription& scene);

}  // namespace candela
