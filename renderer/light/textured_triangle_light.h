// Triangles that emit as a texture says. They are sampled as those that emit evenly.
#pragma once

#include "renderer/light/image_radiance.h"
#include "renderer/light/triangle_light.h"

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
  LightSample sample = sample_triangle_light(light, from, u);
  if (!sample.is_valid()) return sample;
  Vec2f weights = square_to_triangle(u);
  sample.radiance *= emission_factor(light, geometry, textures, weights.x, weights.y);
  if (is_black(sample.radiance)) return {};
  return sample;
}

}  // namespace candela
