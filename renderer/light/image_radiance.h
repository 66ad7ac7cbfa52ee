// What an image says of light: its colours, where they are light.
#pragma once

#include <limits>

#include "renderer/math/vec.h"
#include "renderer/texture/texture.h"

namespace candela {

// Values that are not finite or below 0 count as 0.
[[nodiscard]] inline Rgb valid_radiance(const Vec4f& texel) {
  const auto valid = [](float x) {
    return x > 0 && x <= std::numeric_limits<float>::max() ? x : 0.0f;
  };
  return {valid(texel.x), valid(texel.y), valid(texel.z)};
}

[[nodiscard]] inline Rgb image_radiance(const TextureStore& textures, TextureHandle image,
                                        Vec2f uv) {
  return valid_radiance(textures.lookup(image, uv));
}

}  // namespace candela
