// How large a scene as written is.
#pragma once

#include "renderer/description/scene_description.h"
#include "renderer/math/bounds.h"

namespace candela::description {

// Of every vertex of every instance and of the triangle lights; empty where there are none.
// Instances of meshes that do not exist are stepped over.
[[nodiscard]] Bounds3d world_bounds(const SceneDescription& scene);

}  // namespace candela::description
