// What light that bounces and lamps that have an area change in a picture (REPORT 4.1): the same
// diffuse Cornell box by `path` and by `whitted`.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "scene_io/load.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using test::RenderSettings;

// `ambient`: what whitted needs to see anything of a side that no lamp reaches.
Scene diffuse_cornell_box(std::optional<Vec3d> ambient) {
  LoadOptions options;
  options.ambient = ambient;
  const Result<description::SceneDescription> description =
      load(CANDELA_SOURCE_DIR "/assets/cornell_box_diffuse/cornell_box_diffuse.yaml", options);
  EXPECT_TRUE(description);
  return test::compiled(*description, test::settings_of(512, 1).options);
}

Image crop_of(const Scene& scene, IntegratorKind integrator, const PixelRect& crop,
              int samples_per_pixel, std::uint64_t seed = 1) {
  RenderSettings settings = test::settings_of(512, samples_per_pixel, seed);
  settings.options.integrator = integrator;
  settings.options.crop = crop;
  settings.options.filter = FilterKind::Box;
  return test::rendered(scene, settings).film.to_image(false);
}

// Red over green, in units of what the white of the boxes has of it under the lamp's light.
double redness(const Image& image) {
  double red = 0;
  double green = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      red += double{image.pixel(x, y)[0]} / (.725 * 23);
      green += double{image.pixel(x, y)[1]} / (.71 * 20.7);
    }
  return red / green;
}

// The short box's side beside the red wall: no lamp reaches it, the wall does.
TEST(Statistical_PathAndWhitted, ColoursBleedOnlyWhereLightBounces) {
  const PixelRect side{381, 370, 391, 430};
  const Scene scene = diffuse_cornell_box(std::nullopt);
  statistics::Moments path;
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
    path.add(redness(crop_of(scene, IntegratorKind::Path, side, 32, seed)));
  const double whitted = redness(crop_of(diffuse_cornell_box(Vec3d(.05) * Vec3d(23, 20.7, 16.1)),
                                         IntegratorKind::Whitted, side, 1));
  EXPECT_NEAR(whitted, 1, 1e-3);
  EXPECT_GT(path.interval(0.99).low, 3 * whitted) << path.mean();
}

// Green, from top to bottom of a column of pixels.
std::vector<double> column(const Image& image) {
  std::vector<double> values;
  for (int y = 0; y < image.height; ++y) values.push_back(image.pixel(0, y)[1]);
  return values;
}

// Rows that are neither in the shadow nor in the light: between 10 and 90 % of the way from the
// darkest tenth of the column to its brightest.
int penumbra_rows(const std::vector<double>& values) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const auto tenth = static_cast<std::ptrdiff_t>(sorted.size() / 10);
  const auto count = static_cast<double>(tenth);
  const double dark = std::accumulate(sorted.begin(), sorted.begin() + tenth, 0.0) / count;
  const double light = std::accumulate(sorted.end() - tenth, sorted.end(), 0.0) / count;
  return static_cast<int>(std::count_if(values.begin(), values.end(), [&](double value) {
    const double way = (value - dark) / (light - dark);
    return way > 0.1 && way < 0.9;
  }));
}

// The front edge of the tall box's shadow on the floor, left of the box.
TEST(Statistical_PathAndWhitted, ShadowsAreSoftOnlyUnderLampsWithAnArea) {
  const PixelRect edge{100, 420, 101, 468};
  const Scene scene = diffuse_cornell_box(std::nullopt);
  const int path = penumbra_rows(column(crop_of(scene, IntegratorKind::Path, edge, 1024)));
  EXPECT_GT(path, 5);
  EXPECT_LT(path, 30) << "the column holds the shadow and the light, too";
  EXPECT_LE(penumbra_rows(column(crop_of(scene, IntegratorKind::Whitted, edge, 1))), 1);
}

}  // namespace
}  // namespace candela
