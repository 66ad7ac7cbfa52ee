// A step of validate(): cameras.
#pragma once

#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela::description {

// There is one; each looks somewhere, knows which way is up, and has an angle of view.
void check_cameras(const SceneDescription& scene, Diagnostics& diagnostics);

}  // namespace candela::description
