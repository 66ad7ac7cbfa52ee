// LightSource directives, and triangles that shine on their own.
#pragma once

#include <string>

#include "scene_io/pbrt/write/write_textures.h"

namespace candela::pbrt {

[[nodiscard]] std::string write_lights(WriteContext& context, TextureWriter& textures);

// An AreaLightSource with the end of its line.
[[nodiscard]] std::string area_light(const Vec3d& radiance, bool emits_both_sides);

}  // namespace candela::pbrt
