// The options as far as there is what they ask for: a render goes by these, and so does what is
// measured of it.
#pragma once

#include "integrators/render_options.h"

namespace candela {

// Without sharing, guiding, splitting and trials that the scene or the strategy has none of.
[[nodiscard]] RenderOptions feasible_options(const Scene& scene, const RenderOptions& options);

}  // namespace candela
