#include "renderer/scene/compile_image_lights.h"

#include <algorithm>
#include <cmath>

#include "renderer/light/make_light.h"
#include "renderer/light/textured_triangle_light.h"
#include "renderer/scene/image_luminance.h"
#include "renderer/scene/normalise.h"

namespace candela {
namespace {

// The intensity, and the mean over all directions of its luminance, of an image whose own mean over
// all directions is `mean`.
struct Brightness {
  Vec3d intensity{0.0};
  double mean_luminance = 0;
};

Brightness brightness_of(const Vec3d& intensity, const std::optional<double>& power, double mean) {
  if (!power) return {intensity, luminance(intensity) * mean};
  if (!(mean > 0)) return {};
  const Vec3d scaled = intensity * (*power / (4 * pi_double * mean));
  return {scaled, luminance(scaled) * mean};
}

// The half sides of an image at distance 1; the angle is of the shorter one.
Vec2d half_sides_of(const description::ProjectionLight& light, const TextureInfo& info) {
  const double shorter = std::tan(0.5 * light.angle_degrees * (pi_double / 180));
  const double aspect = static_cast<double>(info.width) / info.height;
  return shorter * Vec2d(std::max(aspect, 1.0), std::max(1 / aspect, 1.0));
}

// The middles of side^2 equal parts of a triangle, as barycentric weights of vertices 1 and 2.
template <class Visit>
void for_each_part(int side, const Visit& visit) {
  const double step = 1.0 / side;
  for (int i = 0; i < side; ++i)
    for (int j = 0; i + j < side; ++j) {
      visit((i + 1.0 / 3) * step, (j + 1.0 / 3) * step);
      if (i + j + 1 < side) visit((i + 2.0 / 3) * step, (j + 2.0 / 3) * step);
    }
}

bool has_light(const TextureStore& textures, const Light& light,
               const std::array<Vec2f, 3>& triangle) {
  const Vec2f uv[3] = {triangle[0], triangle[1], triangle[2]};
  for (int c = 0; c < 3; ++c)
    if (light.emission[c] > 0 && textures.range_in_triangle(light.texture, uv, c).high > 0)
      return true;
  return false;
}

bool has_light(const TextureStore& textures, const Geometry& geometry, const Light& light) {
  std::array<Vec2f, 3> uv{Vec2f(0.5f), Vec2f(0.5f), Vec2f(0.5f)};
  if (!geometry.uvs.empty())
    for (std::size_t k = 0; k < 3; ++k) uv[k] = geometry.uvs[geometry.triangles[light.triangle][k]];
  return has_light(textures, light, uv);
}

float mean_emission(const TextureStore& textures, const Geometry& geometry, const Light& light,
                    int side) {
  double sum = 0;
  for_each_part(side, [&](double u, double v) {
    sum += luminance(
        Vec3d(light.emission * emission_factor(light, geometry, textures, static_cast<float>(u),
                                               static_cast<float>(v))));
  });
  const double mean = sum / (static_cast<double>(side) * side);
  if (mean > 0 || !has_light(textures, geometry, light)) return static_cast<float>(mean);
  return 1e-6f * luminance(light.emission);  // dim, and not black
}

float mean_sphere_emission(ImageMeans& means, const Light& light) {
  const auto mean =
      static_cast<float>(luminance(Vec3d(light.emission) * means.over_sphere(light.texture)));
  const TextureStore& textures = means.textures();
  const bool shines = mean > 0 || has_light(textures, light, {{{0, 0}, {1, 0}, {1, 1}}}) ||
                      has_light(textures, light, {{{0, 0}, {1, 1}, {0, 1}}});
  return mean > 0 || !shines ? mean : 1e-6f * luminance(light.emission);  // dim, and not black
}

}  // namespace

double ImageMeans::of_directions(TextureHandle image) {
  const auto [at, is_new] = luminances_.try_emplace(Key(image.index, 0.0, 0.0), 0.0);
  if (is_new) at->second = mean_luminance(textures_, image);
  return at->second;
}

// An area at distance 1 is seen under the cube of its direction's cosine.
double ImageMeans::of_projection(TextureHandle image, const Vec2d& half_sides) {
  const auto [at, is_new] =
      luminances_.try_emplace(Key(image.index, half_sides.x, half_sides.y), 0.0);
  if (!is_new) return at->second;
  const auto cosine_cubed = [&](double s, double t) {
    const Vec2d place = half_sides * (2.0 * Vec2d(s, t) - 1.0);
    return std::pow(1 + dot(place, place), -1.5);
  };
  const double area = 4 * half_sides.x * half_sides.y;
  return at->second = mean_luminance(textures_, image, cosine_cubed) * area / (4 * pi_double);
}

// Rows of a sphere have the area of the sine of their angle from a pole.
Vec3d ImageMeans::over_sphere(TextureHandle image) {
  const auto [at, is_new] = over_spheres_.try_emplace(image.index, Vec3d(0.0));
  if (!is_new) return at->second;
  constexpr int columns = 128;
  constexpr int rows = 64;
  Vec3d sum(0.0);
  double weight = 0;
  for (int row = 0; row < rows; ++row) {
    const double v = (row + 0.5) / rows;
    const double area = std::sin(v * pi_double);
    for (int column = 0; column < columns; ++column) {
      const Vec2f uv(static_cast<float>((column + 0.5) / columns), static_cast<float>(v));
      sum += area * Vec3d(image_radiance(textures_, image, uv));
      weight += area;
    }
  }
  return at->second = sum / weight;
}

Light goniometric_light(const description::GoniometricLight& light, const Vec3f& position,
                        const Normalisation& n, TextureHandle image, ImageMeans& means) {
  const double mean = image ? means.of_directions(image) : 1;
  const Brightness bright = brightness_of(light.intensity, light.power, mean);
  Light out = make_goniometric_light(position, light.world_from_map,
                                     normalised_intensity(n, bright.intensity), image);
  out.mean_luminance = normalised_intensity(n, Vec3d(bright.mean_luminance)).x;
  return out;
}

Light projection_light(const description::ProjectionLight& light, const Vec3f& position,
                       const Normalisation& n, TextureHandle image, ImageMeans& means) {
  const Vec2d half_sides = half_sides_of(light, means.textures().info(image));
  const Brightness bright =
      brightness_of(light.intensity, light.power, means.of_projection(image, half_sides));
  Light out = make_projection_light(position, light.world_from_map, half_sides,
                                    normalised_intensity(n, bright.intensity), image);
  out.mean_luminance = normalised_intensity(n, Vec3d(bright.mean_luminance)).x;
  return out;
}

void set_mean_emission(const Geometry& geometry, std::size_t triangles_in_all, ImageMeans& means,
                       std::vector<Light>& lights) {
  for (std::size_t i = 0; i < geometry.spheres.size(); ++i) {
    Light& light = lights[geometry.first_light + i];
    light.mean_luminance = mean_sphere_emission(means, light);
  }
  constexpr double most_points = 1 << 20;  // of all triangles together
  const auto count = static_cast<double>(std::max(triangles_in_all, std::size_t{1}));
  const int side = static_cast<int>(std::clamp(std::sqrt(most_points / count), 2.0, 64.0));
  for (std::size_t i = 0; i < geometry.triangles.size(); ++i) {
    Light& light = lights[geometry.first_light + i];
    light.mean_luminance = mean_emission(means.textures(), geometry, light, side);
  }
}

}  // namespace candela
