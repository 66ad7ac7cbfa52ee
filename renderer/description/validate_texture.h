// A step of validate(): textures.
#pragma once

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela::description {

// Images exist, inputs stand before what they go into, numbers are finite,
// neither depth nor number of what a texture is made of runs away, colours and factors at
// least 0.
void check_textures(const SceneDescription& scene, Diagnostics& diagnostics);

}  // namespace candela::description
