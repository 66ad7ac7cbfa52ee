// A step of validate(): materials.
#pragma once

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela::description {

// Of dielectrics that are no sheets: the surroundings may be denser than what is within.
inline constexpr double least_ior = 0.1;

// Handles of images in range, numbers finite and within what the models stand for; a warning for
// kd + ks above 1, which lets a surface reflect more than it gets.
void check_material(const SceneDescription& scene, const Material& material,
                    Diagnostics& diagnostics);

}  // namespace candela::description
