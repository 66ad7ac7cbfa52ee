// Which materials of a description the surfaces of some instance have.
#pragma once

#include <vector>

#include "renderer/description/scene_description.h"

namespace candela::description {

// One flag a material; the parts of mixtures count. Handles that lead nowhere are passed over.
[[nodiscard]] std::vector<bool> used_materials(const SceneDescription& scene);

}  // namespace candela::description
