// Triangles that emit as a texture says. They are sampled as those that emit evenly.
#pragma once

#include "renderer/light/image_radiance.h"
#include "renderer/light/near_place.h"

namespace candela {

// The texture's factor of what leaves the light's triangle at the barycentric weights (u, v).
[[nodiscard]] inline Rgb emission_factor(const Light& light, const Geometry& geometry,
                                         const TextureStore& textures, float u, float v) {
  return image_radiance(textures, light.texture, uv_at(geometry, light.triangle, u, v));
}

[[nodiscard]] inline LightSample sample_textured_triangle_light(const Light& light,
                                                                const Geometry& geometry,
                                                                const TextureStore& textures,
                                                                const SurfacePoint& from, Vec2f u) {
  NearPlace place{.weights = square_to_triangle(u)};
  if (is_near(light, from.position))
    place = sample_near_place(light, from.position, from.receiving_normal, u);
  LightSample sample = light_from_near_place(light, from, place);
  if (!sample.is_valid()) return sample;
  sample.radiance *= emission_factor(light, geometry, textures, place.weights.x, place.weights.y);
  if (is_black(sample.radiance)) return {};
  return sample;
}

}  // namespace candela
