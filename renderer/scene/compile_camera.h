// description::Camera -> Camera in normalised space.
#pragma once

#include "renderer/description/scene_description.h"
#include "renderer/scene/compile.h"
#include "renderer/scene/scene.h"

namespace candela {

// Eye and target differ and up is not parallel to the view: validation has seen to it. Distances
// are those of check_distances().
[[nodiscard]] Camera compile_camera(const description::Camera& camera,
                                    const Normalisation& normalisation,
                                    const CompileOptions& options);

// Says what of a camera is too far away from the scene, or too near, for floats: errors.
void check_distances(const description::Camera& camera, const Normalisation& normalisation,
                     Diagnostics& diagnostics);

}  // namespace candela
