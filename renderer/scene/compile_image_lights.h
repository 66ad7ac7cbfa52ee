// Lights that images shape: points by direction, and triangles by place.
#pragma once

#include <vector>

#include "renderer/description/scene_description.h"
#include "renderer/geometry/geometry.h"
#include "renderer/light/light.h"
#include "renderer/texture/texture.h"

namespace candela {

// At `position` in normalised space; `unit`: an intensity of 1 there. `image` is the light's own,
// which this decodes, or none.
[[nodiscard]] Light goniometric_light(const description::GoniometricLight& light,
                                      const Vec3f& position, float unit, TextureHandle image,
                                      const TextureStore& textures);
[[nodiscard]] Light projection_light(const description::ProjectionLight& light,
                                     const Vec3f& position, float unit, TextureHandle image,
                                     const TextureStore& textures);

// Sets the mean luminance of the textured lights of a geometry, triangles or spheres, by which they
// are picked: from a grid of points on each, and above 0 wherever its texture has any light.
void set_mean_emission(const Geometry& geometry, const TextureStore& textures,
                       std::vector<Light>& lights);

}  // namespace candela
