// What a sampling strategy of the path integrator cannot see of a scene, in sentences.
#pragma once

#include "integrators/sampling_strategy.h"
#include "renderer/base/diagnostic.h"
#include "renderer/description/scene_description.h"

namespace candela {

// Errors: delta lobes beside others without BSDF samples, delta lights without light samples. What
// no instance wears and what is black does not matter.
[[nodiscard]] Diagnostics check_sampling(const description::SceneDescription& scene,
                                         SamplingStrategy strategy);

}  // namespace candela
