// Program -> SceneDescription.
#pragma once

#include "scene_io/pbrt/context.h"

namespace candela::pbrt {

void build_scene(Context& context);

}  // namespace candela::pbrt
