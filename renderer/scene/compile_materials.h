// description::Material -> Material: colours decoded to linear floats, textures registered, models
// reduced to the simplest that gives the same picture.
#pragma once

#include "renderer/description/scene_description.h"
#include "renderer/scene/compile.h"
#include "renderer/scene/scene.h"

namespace candela {

[[nodiscard]] Material compile_material(const description::SceneDescription& scene,
                                        const description::Material& material,
                                        const CompileOptions& options, TextureStore& textures,
                                        Diagnostics& diagnostics);

// Adds what the material needs of a kernel.
void add_features(const Material& material, SceneFeatures& features);

}  // namespace candela
