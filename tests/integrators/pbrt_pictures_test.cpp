// Bitterli's scenes as pbrt-v4 files, where they are present, against pbrt-v4's own pictures of the
// very files: their luminance, as a whole and in 8 x 8 blocks.
//
// What a scene may be off by in the whole is docs/pbrt.md's promise: pbrt is spectral, so coloured
// light that is reflected again and again differs. On top of it comes the noise of both pictures:
// of ours by renders with seeds of their own, of pbrt's by its two independent halves. Two numbers
// say little of their spread, and few renders little of rare light: the noise of a block is that of
// the 5 x 5 blocks around it, relative to their light.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "renderer/image/image_io.h"
#include "renderer/math/colour.h"
#include "scene_io/load.h"
#include "tests/scene_io/shared_scenes.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

struct Case {
  std::string scene;
  std::string file;
  double tolerance;          // of the whole's luminance
  double odd_blocks = 0.02;  // share of the blocks that may be off by 3 % more: fireflies
};

constexpr int replicates = 8;
constexpr int block = 8;

Image read(const std::string& scene, const std::string& name) {
  Result<Image> image = read_image(*shared_scene("pbrt/" + scene + "/" + name));
  EXPECT_TRUE(image) << name;
  return image ? std::move(*image) : Image(1, 1, {"R", "G", "B"});
}

double luminance_of(const Image& image, int x, int y) {
  const std::array<int, 3> rgb{image.channel_index("R"), image.channel_index("G"),
                               image.channel_index("B")};
  const float* const pixel = image.pixel(x, y);
  return luminance(Vec3d(pixel[rgb[0]], pixel[rgb[1]], pixel[rgb[2]]));
}

// Mean luminance of each block, row by row; the last is that of all pixels.
std::vector<double> means_of(const Image& image) {
  const int columns = image.width / block;
  const int rows = image.height / block;
  std::vector<double> means(static_cast<std::size_t>(columns * rows) + 1);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double value = luminance_of(image, x, y);
      means.back() += value / (static_cast<double>(image.width) * image.height);
      if (x / block >= columns || y / block >= rows) continue;
      means[static_cast<std::size_t>(y / block * columns + x / block)] += value / (block * block);
    }
  return means;
}

// The variance of each block relative to its squared light, over the 5 x 5 blocks around it; of the
// whole, the last, its own.
std::vector<double> pooled(const std::vector<double>& relative, int columns) {
  std::vector<double> result = relative;
  const int rows = static_cast<int>(relative.size() - 1) / columns;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      statistics::Moments around;
      for (int v = std::max(y - 2, 0); v <= std::min(y + 2, rows - 1); ++v)
        for (int u = std::max(x - 2, 0); u <= std::min(x + 2, columns - 1); ++u)
          around.add(relative[static_cast<std::size_t>(v * columns + u)]);
      result[static_cast<std::size_t>(y * columns + x)] = around.mean();
    }
  return result;
}

double square(double x) {
  return x * x;
}

class Agreement_PbrtPictures : public testing::TestWithParam<Case> {};

TEST_P(Agreement_PbrtPictures, HaveTheLuminanceOfPbrts) {
  const Case& c = GetParam();
  const auto path = shared_scene("pbrt/" + c.scene + "/" + c.file);
  if (!path) GTEST_SKIP() << "the shared scenes are not here";
  const auto description = load(*path, {});
  ASSERT_TRUE(description);
  const std::vector<double> half1 = means_of(read(c.scene, "pbrt-v4-half1.exr"));
  const std::vector<double> half2 = means_of(read(c.scene, "pbrt-v4-half2.exr"));
  const Image reference = read(c.scene, "pbrt-v4.exr");

  // Of fewer the noise of veach-mis is so skewed that it is told too small more often than not.
  const int samples = std::getenv("CANDELA_HEAVY") != nullptr ? 256 : 16;
  test::RenderSettings settings = test::settings_of(reference.width, samples);
  settings.options.height = reference.height;
  settings.options.max_depth = description->defaults.max_depth;
  settings.options.filter = FilterKind::Triangle;  // of every file
  settings.options.filter_radius = 1.0f;
  const Scene scene = test::compiled(*description, settings.options);
  std::vector<statistics::Moments> ours(half1.size());
  for (int i = 0; i < replicates; ++i) {
    settings.options.seed = 100 + static_cast<std::uint64_t>(i);
    const Image image = test::rendered(scene, settings).film.to_image(false);
    const std::vector<double> means = means_of(image);
    for (std::size_t k = 0; k < means.size(); ++k) ours[k].add(means[k]);
  }
  std::vector<double> noises;  // of the difference, squared, over the light's square
  for (std::size_t k = 0; k < ours.size(); ++k)
    noises.push_back(square(2 * ours[k].standard_error() / (half1[k] + half2[k])) +
                     square((half1[k] - half2[k]) / (half1[k] + half2[k])));
  noises = pooled(noises, reference.width / block);
  int outside = 0;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    const bool is_whole = k + 1 == ours.size();
    const double theirs = (half1[k] + half2[k]) / 2;
    const double noise = std::sqrt(noises[k]) * theirs;
    const double difference = std::abs(ours[k].mean() - theirs);
    if (is_whole)
      EXPECT_LE(difference, c.tolerance * theirs + 3.5 * noise)
          << ours[k].mean() / theirs << " of pbrt's luminance, noise " << noise / theirs;
    else
      outside += difference <= (c.tolerance + 0.03) * theirs + 3.5 * noise ? 0 : 1;
  }
  EXPECT_LE(outside, static_cast<int>(c.odd_blocks * static_cast<double>(ours.size())));
}

// Coats and textured metal: 3 %. All else: 1.5 %. Of the Cornell box's blocks a sixth, beside its
// coloured walls, are off by more than 4.5 % between pbrt and any renderer in linear Rec.709: 63 of
// 400 of candela's, 66 of Tungsten's, of which candela's are off by .25 % in the median.
INSTANTIATE_TEST_SUITE_P(, Agreement_PbrtPictures,
                         testing::Values(Case{"cornell-box", "scene-v4.pbrt", 0.015, 0.2},
                                         Case{"veach-mis", "scene-v4.pbrt", 0.015},
                                         Case{"veach-ajar", "scene-v4-floorfix.pbrt", 0.03},
                                         Case{"classroom", "scene-v4.pbrt", 0.03},
                                         Case{"staircase2", "scene-v4.pbrt", 0.03},
                                         Case{"staircase", "scene-v4.pbrt", 0.03},
                                         Case{"teapot", "scene-v4.pbrt", 0.03}),
                         [](const auto& info) {
                           std::string name = info.param.scene;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace candela
