// What of the options there is for a scene and a strategy: what a render goes by, and what is
// measured of it.
#pragma once

#include "integrators/render.h"

namespace candela {

// The same without sharing, guiding, splitting and choices that such a scene or strategy has none
// of.
[[nodiscard]] RenderOptions feasible_options(const Scene& scene, const RenderOptions& options);

}  // namespace candela
