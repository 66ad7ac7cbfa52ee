// A step of validate(): meshes.
#pragma once

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela::description {

// Sizes of the arrays, indices and handles in range, all numbers finite.
void check_mesh(const SceneDescription& scene, const Mesh& mesh, Diagnostics& diagnostics);

}  // namespace candela::description
