// Which materials of a description some instance wears.
#pragma once

#include <vector>

#include "renderer/description/scene_description.h"

namespace candela {

// One flag a material.
[[nodiscard]] std::vector<bool> worn_materials(const description::SceneDescription& scene);

}  // namespace candela
