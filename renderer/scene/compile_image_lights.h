// Lights that images shape: points by direction, and triangles by place.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "renderer/description/scene_description.h"
#include "renderer/geometry/geometry.h"
#include "renderer/light/light.h"
#include "renderer/scene/scene.h"
#include "renderer/texture/texture.h"

namespace candela {

// Means of images, which are decoded for it, each found once: many lights may share one.
class ImageMeans {
 public:
  explicit ImageMeans(const TextureStore& textures) : textures_(textures) {}

  // Of the luminance over all directions: of an image of them, and of one that is projected onto an
  // area of these half sides at distance 1.
  [[nodiscard]] double of_directions(TextureHandle image);
  [[nodiscard]] double of_projection(TextureHandle image, const Vec2d& half_sides);
  // Of the colour, over a sphere's surface.
  [[nodiscard]] Vec3d over_sphere(TextureHandle image);

  [[nodiscard]] const TextureStore& textures() const { return textures_; }

 private:
  using Key = std::tuple<std::size_t, double, double>;  // image and half sides

  const TextureStore& textures_;
  std::map<Key, double> luminances_;
  std::map<std::size_t, Vec3d> over_spheres_;
};

// At `position` in the normalised space of `n`. `image` is the light's own, or none.
[[nodiscard]] Light goniometric_light(const description::GoniometricLight& light,
                                      const Vec3f& position, const Normalisation& n,
                                      TextureHandle image, ImageMeans& means);
[[nodiscard]] Light projection_light(const description::ProjectionLight& light,
                                     const Vec3f& position, const Normalisation& n,
                                     TextureHandle image, ImageMeans& means);

// Sets the mean luminance of the textured lights of a geometry, triangles or spheres, by which they
// are picked: from a grid of points on each, the coarser the more such triangles the scene has, and
// above 0 wherever its texture has any light.
void set_mean_emission(const Geometry& geometry, std::size_t triangles_in_all, ImageMeans& means,
                       std::vector<Light>& lights);

}  // namespace candela
