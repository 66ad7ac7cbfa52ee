#include "tools/candela/decode_textures.h"

#include "renderer/base/parallel.h"

namespace candela::cli {

void decode_all_textures(const TextureStore& textures) {
  parallel_for(textures.size(), [&](std::size_t i) {
    static_cast<void>(textures.lookup(TextureHandle(i), Vec2f(0.5f)));
  });
}

}  // namespace candela::cli
