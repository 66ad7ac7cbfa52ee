// A step of validate(): media, and who refers to them.
#pragma once

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela::description {

// Coefficients finite and not negative, asymmetries between -1 and 1, handles in range.
void check_media(const SceneDescription& scene, Diagnostics& diagnostics);

}  // namespace candela::description
