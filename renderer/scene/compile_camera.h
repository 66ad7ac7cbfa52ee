// description::Camera -> Camera in normalised space.
#pragma once

#include "renderer/description/scene_description.h"
#include "renderer/scene/compile.h"
#include "renderer/scene/scene.h"

namespace candela {

// Eye and target differ and up is not parallel to the view: validation has seen to it.
[[nodiscard]] Camera compile_camera(const description::Camera& camera,
                                    const Normalisation& normalisation,
                                    const CompileOptions& options);

}  // namespace candela
