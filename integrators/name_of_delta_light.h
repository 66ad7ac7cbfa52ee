// Delta lights in messages of integrators that do without them.
#pragma once

#include <string_view>

#include "renderer/description/scene_description.h"

namespace candela {

// "a point light" and its like; "" of lights with an area, environments, and black ones.
[[nodiscard]] std::string_view name_of_delta_light(const description::Light& light);

}  // namespace candela
