// Lights of the description and emissive triangles -> the light table.
#pragma once

#include "renderer/description/scene_description.h"
#include "renderer/scene/compile.h"
#include "renderer/scene/drop_reason.h"
#include "renderer/scene/scene.h"

namespace candela {

// Fills lights, environment, ambient and light_sampler, and first_light of emissive geometries.
// Black lights are dropped and counted. Geometry, bounds and normalisation must be complete.
void compile_lights(const description::SceneDescription& description, const CompileOptions& options,
                    Scene& scene, DropCounts& dropped, Diagnostics& diagnostics);

}  // namespace candela
