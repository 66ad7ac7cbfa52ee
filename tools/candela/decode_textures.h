// Decoding that does not wait for a ray: to find broken image files before rendering.
#pragma once

#include "renderer/texture/texture.h"

namespace candela::cli {

// Touches every texture; what went wrong is in textures.decoding_diagnostics().
void decode_all_textures(const TextureStore& textures);

}  // namespace candela::cli
