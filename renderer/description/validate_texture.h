// A step of validate(): textures.
#pragma once

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela::description {

// Images exist, inputs stand before what they go into, numbers are finite (heights may be below 0),
// neither depth nor number of what a texture is made of runs away.
void check_textures(const SceneDescription& scene, Diagnostics& diagnostics);

}  // namespace candela::description
