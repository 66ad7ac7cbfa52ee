// Camera, Film, PixelFilter, Sampler and Integrator.
#pragma once

#include <string>

#include "scene_io/pbrt/write/write_context.h"

namespace candela::pbrt {

// All that stands before WorldBegin. `has_media` asks for the integrator that knows them.
[[nodiscard]] std::string write_view(WriteContext& context, bool has_media);

}  // namespace candela::pbrt
