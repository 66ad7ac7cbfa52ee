// Means of images' luminance, for lights of a given power. Texels that are not finite or below 0
// count as 0, as where light is looked up. They decode the image.
#pragma once

#include <vector>

#include "renderer/light/image_radiance.h"
#include "renderer/math/colour.h"

namespace candela {

// The mean over an image's texels of weight(column, row) times luminance, the middles of texels
// being in [0, 1], rows from the top.
template <class Weight>
[[nodiscard]] double mean_luminance(const TextureStore& textures, TextureHandle image,
                                    const Weight& weight) {
  const TextureInfo& info = textures.info(image);
  double sum = 0;
  for (int y = 0; y < info.height; ++y) {
    const std::vector<Vec4f> row = textures.texels(image, y);
    for (int x = 0; x < info.width; ++x) {
      const Rgb texel = valid_radiance(row[static_cast<std::size_t>(x)]);
      sum += weight((x + 0.5) / info.width, (y + 0.5) / info.height) * luminance(Vec3d(texel));
    }
  }
  return sum / (static_cast<double>(info.width) * info.height);
}

[[nodiscard]] inline double mean_luminance(const TextureStore& textures, TextureHandle image) {
  return mean_luminance(textures, image, [](double, double) { return 1.0; });
}

}  // namespace candela
