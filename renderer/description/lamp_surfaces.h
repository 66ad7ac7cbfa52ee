// Triangle lights -> surfaces that shine.
#pragma once

#include "renderer/description/scene_description.h"

namespace candela::description {

[[nodiscard]] bool is_triangle_light(const Light& light);

// Appends the surfaces of triangle lights to the description's geometry: a black material and a
// mesh for each lamp, which is triangles alike that share corners. The lights stay.
void add_lamp_surfaces(SceneDescription& description);

}  // namespace candela::description
