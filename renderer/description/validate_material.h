// A step of validate(): materials.
#pragma once

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela::description {

// Of dielectrics that are no sheets: the surroundings may be denser than what is within.
inline constexpr double least_ior = 0.1;
inline constexpr double largest_ior = 1000;  // products of larger ones leave what float can tell
inline constexpr int deepest_coat = 1000;    // each bounce is a product at every hit

// Handles of images in range, numbers finite and within what the models stand for; a warning for
// kd + ks above 1, which both are made smaller for.
void check_material(const SceneDescription& scene, const Material& material,
                    Diagnostics& diagnostics);

// Of mixtures of mixtures, of all materials.
inline constexpr int deepest_mixture = 16;
void check_mixtures(const SceneDescription& scene, Diagnostics& diagnostics);

}  // namespace candela::description
