// The camera, and what the other directives before WorldBegin say about the picture.
#pragma once

#include "scene_io/pbrt/context.h"

namespace candela::pbrt {

void read_camera(Context& context);

// Film, PixelFilter, Sampler and Integrator -> RenderDefaults, with pbrt's own defaults. Returns
// what the film multiplies radiance by: the imaging ratio, exposure time * ISO / 100.
[[nodiscard]] double read_film(Context& context);

}  // namespace candela::pbrt
