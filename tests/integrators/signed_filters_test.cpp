// Pixel filters with negative parts, from samples to pictures.
#include <gtest/gtest.h>

#include <array>

#include "renderer/film/variance.h"
#include "renderer/image/relmse.h"
#include "renderer/math/constants.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

constexpr int size = 16;

// A straight edge in the picture's middle: radiance 1 on its left, `dim` on its right.
SceneDescription edge(double dim) {
  SceneDescription scene = empty_scene();
  const auto left = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(1.0));
  const auto right = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(dim));
  add_mesh(scene, quad({-4, -4, 0}, {4, 0, 0}, {0, 8, 0}), left);
  add_mesh(scene, quad({0, -4, 0}, {4, 0, 0}, {0, 8, 0}), right);
  set_camera(scene, {0, 0, 1}, {0, 0, 0});
  scene.cameras[0].kind = description::CameraKind::Orthographic;
  return scene;
}

double mitchell(double x) {
  const double t = std::abs(x);
  if (t >= 2) return 0;
  if (t < 1) return (7 * t * t * t - 12 * t * t + 16.0 / 3) / 6;
  return (-7.0 / 3 * t * t * t + 12 * t * t - 20 * t + 32.0 / 3) / 6;
}

// The filter's integral up to x.
double mitchell_below(double x) {
  constexpr int steps = 4000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double y = -2 + (x + 2) * (i + 0.5) / steps;
    sum += mitchell(y) * (x + 2) / steps;
  }
  return sum;
}

// Darker than the dim side and brighter than the bright one, as the filter says. Beside nothing the
// bright side is a lamp that has rays of its own.
void expect_the_edge_under_the_filter(double dim) {
  std::vector<statistics::Moments> columns(size);
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    RenderSettings settings = settings_of(size, 64, seed);
    settings.options.filter = FilterKind::Mitchell;
    settings.options.lamp_rays = 8;
    const RenderResult result = rendered(edge(dim), settings);
    EXPECT_EQ(result.statistics.rays.lamp > 0, dim == 0);
    const Image image = result.film.to_image(true);
    for (int x = 0; x < size; ++x)
      for (int y = 0; y < size; ++y) {
        columns[static_cast<std::size_t>(x)].add(double{image.pixel(x, y)[1]});
        EXPECT_EQ(image.pixel(x, y)[3], 1);  // whatever the signs
      }
  }
  for (int x = 0; x < size; ++x) {
    const double distance = size / 2 - (x + 0.5);  // from the pixel's centre to the edge
    const double left = distance >= 2 ? 1 : distance <= -2 ? 0 : mitchell_below(distance);
    const statistics::Moments& column = columns[static_cast<std::size_t>(x)];
    EXPECT_NEAR(column.mean(), left + dim * (1 - left), 1e-3 + 5 * column.standard_error()) << x;
    EXPECT_LT(column.standard_error(), 2e-3);
  }
  EXPECT_GT(columns[size / 2 - 2].mean(), 1);
  EXPECT_LT(columns[size / 2 + 1].mean(), dim);
}

TEST(Statistical_SignedFilters, PicturesAreTheSceneUnderTheFilter) {
  for (const double dim : {0.25, 0.0}) expect_the_edge_under_the_filter(dim);
}

// What the replicates say of a pixel's variance, against that over many seeds.
TEST(Statistical_SignedFilters, StatedVariancesAreTrue) {
  for (const FilterKind filter : {FilterKind::Mitchell, FilterKind::Sinc}) {
    std::vector<statistics::Moments> pixels(size * size);
    statistics::Moments stated;
    for (std::uint64_t seed = 1; seed <= 64; ++seed) {
      RenderSettings settings = settings_of(size, 16, seed);
      settings.options.filter = filter;
      const Film film = rendered(edge(0.25), settings).film;
      double sum = 0;
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i].add(film.mean(i).y);
        sum += variance_of_mean(film, i).y;
      }
      stated.add(sum);
    }
    double found = 0;
    for (const statistics::Moments& pixel : pixels) found += pixel.variance();
    // Relative: sqrt(2 / (63 * 256)) of what is found, were all pixels alike.
    EXPECT_NEAR(stated.mean() / found, 1, 0.06) << static_cast<int>(filter);
  }
}

// Of a room with its lamp in sight, beside which pixels are darker than their neighbours: against
// the error that the pictures' own spread tells.
TEST(Statistical_SignedFilters, StatedErrorsAreTrue) {
  constexpr int seeds = 64;
  for (const FilterKind filter : {FilterKind::Mitchell, FilterKind::Sinc}) {
    std::vector<std::array<statistics::Moments, 3>> pixels(24 * 24);
    statistics::Moments stated, levels;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      RenderSettings settings = settings_of(24, 64, seed);
      settings.options.filter = filter;
      settings.options.lamp_rays = 8;
      const RenderResult result = rendered(small_room(), settings);
      stated.add(result.error->relmse);
      for (std::size_t i = 0; i < pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
          pixels[i][static_cast<std::size_t>(c)].add(result.film.mean(i)[c]);
          levels.add(result.film.mean(i)[c]);
        }
    }
    const double epsilon = relmse_epsilon(levels.mean());
    double found = 0;
    for (const auto& channels : pixels)
      for (const statistics::Moments& m : channels)
        found += m.variance() / (m.mean() * m.mean() + epsilon) / (3.0 * 24 * 24);
    EXPECT_NEAR(stated.mean() / found, 1, 0.15) << static_cast<int>(filter);
  }
}

}  // namespace
}  // namespace candela
