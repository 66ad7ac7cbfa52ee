// Media, for integrators that have none.
#pragma once

#include <string_view>

#include "renderer/description/scene_description.h"

namespace candela {

// A warning where the scene has media.
[[nodiscard]] Diagnostics check_media(const description::SceneDescription& scene,
                                      std::string_view integrator);

}  // namespace candela
