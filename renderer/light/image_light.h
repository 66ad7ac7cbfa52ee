// Points whose intensity an image says: by all directions (goniometric), or projected by a lens.
#pragma once

#include "renderer/light/image_radiance.h"
#include "renderer/light/point_light.h"
#include "renderer/sampling/equal_area.h"

namespace candela {

// What of the intensity leaves towards the unit direction w. Rows of images count from the top.
[[nodiscard]] inline Rgb goniometric_share(const Light& light, const TextureStore& textures,
                                           const Vec3f& w) {
  if (!light.texture) return Rgb(1);
  Vec2f st = equal_area_sphere_to_square(
      Vec3f(dot(light.edge1, w), dot(light.edge2, w), dot(light.normal, w)));
  return image_radiance(textures, light.texture, {st.x, 1 - st.y});
}

// The image plane's axes are as long as its half sides at distance 1 are short.
[[nodiscard]] inline Rgb projected_share(const Light& light, const TextureStore& textures,
                                         const Vec3f& w) {
  const float along = dot(light.normal, w);
  if (!(along > 0)) return Rgb(0);
  Vec2f place{dot(light.edge1, w) / along, dot(light.edge2, w) / along};
  if (!(std::abs(place.x) <= 1 && std::abs(place.y) <= 1)) return Rgb(0);
  return image_radiance(textures, light.texture, place * 0.5f + 0.5f);
}

[[nodiscard]] inline LightSample sample_image_light(const Light& light,
                                                    const TextureStore& textures,
                                                    const SurfacePoint& from) {
  return sample_from_point(light, from, [&](const Vec3f& w) {
    return light.kind == LightKind::Goniometric ? goniometric_share(light, textures, w)
                                                : projected_share(light, textures, w);
  });
}

}  // namespace candela
