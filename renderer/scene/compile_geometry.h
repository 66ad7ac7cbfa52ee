// Meshes and instances -> flat geometries in normalised space. Single uses are flattened into the
// world; triangles are grouped by material and visibility; what no ray can meet is dropped.
#pragma once

#include "renderer/description/scene_description.h"
#include "renderer/scene/compile.h"
#include "renderer/scene/drop_reason.h"
#include "renderer/scene/scene.h"

namespace candela {

// Fills geometries, objects, world, instances. Materials are indexed as in the description, and the
// scene's material table and textures must be complete. Emissive geometries are flattened, so that
// each of their triangles is a light of its own.
void compile_geometry(const description::SceneDescription& description,
                      const CompileOptions& options, Scene& scene, DropCounts& dropped);

// Bounds of all that rays can hit.
[[nodiscard]] Bounds3f bounds_of(const Scene& scene);

}  // namespace candela
