// What textures may look at: where on a surface, and where in the world.
#pragma once

#include "renderer/math/vec.h"

namespace candela {

struct TexturePoint {
  Vec2f uv{0};
  Vec3f position{0};  // normalised space
  Vec3f normal{0};    // unit, geometric, on either side
};

}  // namespace candela
