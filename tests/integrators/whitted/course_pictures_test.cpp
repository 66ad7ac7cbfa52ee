// whitted against pictures that the course's own ray tracer made: 905x930, one sample in each
// pixel's centre, 8 bits by the power 1/2.2 (docs/cli.md, "Whitted and raster"). Where the scenes
// are not there the tests are skipped.
//
// The normals of those pictures are as the lab interpolates them (RenderOptions::lab_normals): with
// that, the oak agrees pixel by pixel as the Cornell box does. The breakfast room's mesh was
// rebuilt from another export, so only its large shapes can agree.
#include <optional>

#include "renderer/image/image_io.h"
#include "renderer/math/colour.h"
#include "scene_io/load.h"
#include "tests/integrators/whitted/lab_scenes.h"
#include "tests/scene_io/shared_scenes.h"

namespace candela {
namespace {

constexpr int width = 905, height = 930;

struct CoursePicture {
  std::string scene;    // in lab3/
  std::string picture;  // in lab3-pictures/
  int max_depth = 0;
  bool lab_normals = true;
  SpecularModel specular = SpecularModel::Blinn;
};

using Levels = std::vector<int>;  // 0..255, three a pixel

// From linear radiance, as the lab encodes for display.
Levels levels_of(const Image& image) {
  Levels levels;
  for (const float v : image.values)
    levels.push_back(static_cast<int>(
        std::lround(255 * std::pow(std::clamp(static_cast<double>(v), 0.0, 1.0), 1 / 2.2))));
  return levels;
}

// read_image decodes 8-bit files from sRGB: encoding again gives what is stored.
Levels stored_levels(const std::string& path) {
  const Result<Image> image = read_image(path);
  Levels levels;
  if (!image || image->width != width || image->height != height) {
    ADD_FAILURE() << path << " is no picture of 905x930";
    return levels;
  }
  for (std::size_t i = 0; i < image->pixel_count(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      levels.push_back(static_cast<int>(std::lround(
          255 *
          linear_to_srgb(static_cast<double>(image->values[i * image->channel_count() + c])))));
  return levels;
}

Levels rendered_levels(const std::string& scene_file, const CoursePicture& c) {
  LoadOptions load_options;
  if (const auto ground = shared_scene("lab3-pictures/ground.jpg");
      c.scene == "white_oak" && ground)
    load_options.lab3_ground = *ground;
  Result<description::SceneDescription> description = load(scene_file, load_options);
  EXPECT_TRUE(description) << scene_file;
  if (!description) return {};
  test::RenderSettings settings = test::lab_settings(IntegratorKind::Whitted);
  settings.options.width = width;
  settings.options.height = height;
  settings.options.max_depth = c.max_depth;
  settings.options.specular = c.specular;
  settings.options.lab_normals = c.lab_normals;
  return levels_of(test::rendered(*description, settings).film.to_image(false));
}

// Ours and the course's, or nothing where they are not there.
std::optional<std::pair<Levels, Levels>> pictures_of(const CoursePicture& c) {
  const auto scene = shared_scene(fmt::format("lab3/{0}/{0}.yaml", c.scene));
  const auto picture = shared_scene("lab3-pictures/" + c.picture);
  if (!scene || !picture) return std::nullopt;
  std::pair<Levels, Levels> pair{rendered_levels(*scene, c), stored_levels(*picture)};
  EXPECT_EQ(pair.first.size(), pair.second.size());
  return pair;
}

// Of the pixels, whose channels are all within `levels`.
double share_within(const Levels& a, const Levels& b, int levels) {
  std::size_t within = 0;
  for (std::size_t i = 0; i + 2 < a.size(); i += 3) {
    int worst = 0;
    for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[i + c] - b[i + c]));
    within += worst <= levels ? 1u : 0u;
  }
  return static_cast<double>(3 * within) / static_cast<double>(a.size());
}

// Sums over blocks of 16 x 16 pixels.
std::vector<double> blocks_of(const Levels& levels) {
  constexpr int block = 16;
  std::vector<double> sums(static_cast<std::size_t>((width / block) * (height / block)));
  for (int y = 0; y < height / block * block; ++y)
    for (int x = 0; x < width / block * block; ++x)
      for (int c = 0; c < 3; ++c)
        sums[static_cast<std::size_t>(y / block * (width / block) + x / block)] +=
            levels[static_cast<std::size_t>(3 * (y * width + x) + c)];
  return sums;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double mean_a = 0, mean_b = 0, ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) mean_a += a[i] / n, mean_b += b[i] / n;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += square(a[i] - mean_a);
    bb += square(b[i] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

// Seen: 99.9905 %, 99.55 % equal.
TEST(Agreement_CoursePictures, CornellBox) {
  for (const bool lab_normals : {false, true}) {
    const auto pair = pictures_of(
        {"cornell_box", "cornell_box-depth3.png", 3, lab_normals, SpecularModel::Blinn});
    if (!pair) GTEST_SKIP() << "the course's Cornell box is not there";
    EXPECT_GT(share_within(pair->first, pair->second, 2), 0.9995);
    EXPECT_GT(share_within(pair->first, pair->second, 0), 0.99);
  }
}

// Seen: 99.880 %, with Phong's highlights 99.718 %.
TEST(Agreement_CoursePictures, WhiteOak) {
  const auto pair = pictures_of({"white_oak", "white_oak-depth7.png", 7});
  if (!pair) GTEST_SKIP() << "the course's white oak is not there";
  EXPECT_GT(share_within(pair->first, pair->second, 2), 0.998);
}

// Unit normals that face the viewer leave 88.7 % of the pixels and a correlation of .997.
TEST(Agreement_CoursePictures, WhiteOakWithNormalsThatFaceTheViewer) {
  const auto pair = pictures_of({"white_oak", "white_oak-depth7.png", 7, false});
  if (!pair) GTEST_SKIP() << "the course's white oak is not there";
  EXPECT_LT(share_within(pair->first, pair->second, 2), 0.9);
  EXPECT_GT(correlation(blocks_of(pair->first), blocks_of(pair->second)), 0.99);
}

// Seen: .910.
TEST(Agreement_CoursePictures, BreakfastRoomInItsLargeShapes) {
  const auto pair = pictures_of({"breakfast_room", "breakfast_room-depth7.png", 7});
  if (!pair) GTEST_SKIP() << "the course's breakfast room is not there";
  EXPECT_GT(correlation(blocks_of(pair->first), blocks_of(pair->second)), 0.89);
}

}  // namespace
}  // namespace candela
