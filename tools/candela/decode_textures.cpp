#include "tools/candela/decode_textures.h"

#include "renderer/base/parallel.h"

namespace candela::cli {

void decode_all_textures(const TextureStore& textures) {
  parallel_for(textures.size(), [&](std::size_t i) { textures.decode(TextureHandle(i)); });
}

}  // namespace candela::cli
