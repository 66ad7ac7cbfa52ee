// Meshes as PLY files, and the shapes and objects that place them.
#pragma once

#include <string>

#include "scene_io/pbrt/write/write_materials.h"
#include "scene_io/pbrt/write/write_media.h"

namespace candela::pbrt {

// A mesh that several instances share is an object, unless it shines or is bumped: pbrt's objects
// do not shine, and heights are lengths in the world.
[[nodiscard]] std::string write_shapes(WriteContext& context, TextureWriter& textures,
                                       MaterialWriter& materials, MediaWriter& media);

}  // namespace candela::pbrt
