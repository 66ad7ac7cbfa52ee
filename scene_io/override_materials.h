// What the command line says of all materials, in place of the scene.
#pragma once

#include "renderer/base/diagnostic.h"
#include "scene_io/load_options.h"

namespace candela {

// options.fresnel and options.geometry, into every CookTorrance material. The exact Fresnel term of
// a material that has F0 alone is that of the real index with this reflectance.
void override_materials(const LoadOptions& options, description::SceneDescription& scene,
                        Diagnostics& diagnostics);

}  // namespace candela
