// Media -> coefficients in normalised space, and which of them lie on the sides of surfaces.
#pragma once

#include <vector>

#include "renderer/description/scene_description.h"
#include "renderer/scene/drop_reason.h"
#include "renderer/scene/scene.h"

namespace candela {

// Fills media, the boundaries by material and the cameras' media, whose table must be complete.
// Media that neither absorb nor scatter, or that nothing `used` and no camera refers to, are
// dropped; where none is left all stays empty. Surfaces that bound media and are nothing else
// (interfaces) become opaque, so that rays meet them.
void compile_media(const description::SceneDescription& description, const std::vector<bool>& used,
                   Scene& scene, DropCounts& dropped);

}  // namespace candela
