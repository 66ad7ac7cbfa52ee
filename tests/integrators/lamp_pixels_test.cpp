// Pixels that lamps cover in part: more camera rays take noise away and nothing else.
#include "integrators/lamp_pixels.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numbers>

#include "integrators/path/find_lamp_pixels.h"
#include "integrators/path/kernels.h"
#include "renderer/accel/bvh_accel.h"
#include "renderer/base/parallel.h"
#include "tests/light/map_images.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

constexpr int some_rays = 8;

RenderSettings lamp_settings(int size, int samples, int rays, std::uint64_t seed = 1) {
  RenderSettings settings = settings_of(size, samples, seed);
  settings.options.lamp_rays = rays;
  return settings;
}

// Half of a quad lamp and of a ball lamp lie behind a wall; a textured one stands beside them.
SceneDescription three_lamps() {
  SceneDescription scene = empty_scene();
  const auto lamp = add_material(scene, diffuse(Vec3d(0.3)), Vec3d(10, 8, 6));
  add_mesh(scene, quad({-1, 0.2, 0}, {0.4, 0, 0}, {0, 0.4, 0}), lamp);
  add_mesh(scene, exact_sphere(0.2), lamp, at_place({0, 0.4, 0}));
  scene.images.push_back(light_test::write_float_map(
      "lamp_pixels", 4, 4, [](int x, int) { return Vec3f(x < 2 ? 1.0f : 0.0f); }));
  const auto textured = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(7));
  scene.materials[textured.index].emission_map = description::ImageHandle(std::size_t{0});
  add_mesh(scene, quad({0.5, 0.2, 0}, {0.4, 0, 0}, {0, 0.4, 0}), textured);
  const auto white = add_material(scene, diffuse(Vec3d(0.7)));
  add_mesh(scene, quad({-2, 0.4, 0.5}, {4, 0, 0}, {0, 1, 0}), white);
  add_mesh(scene, quad({-2, -0.5, 2}, {4, 0, 0}, {0, 0, -4}), white);
  set_camera(scene, {0, 0, 4}, {0, 0, 0}, 40);
  return scene;
}

TEST(Unit_LampPixels, AreThoseThatDifferFromANeighbour) {
  constexpr int side = 24;
  std::vector<LampCoverage> coverage(side * side, LampCoverage::None);
  for (const int y : {5, 6, 7, 8})
    for (const int x : {10, 11, 12, 13})
      coverage[static_cast<std::size_t>(y * side + x)] = LampCoverage::All;
  coverage[20 * side + 3] = LampCoverage::Part;
  const std::vector<std::uint8_t> edges = lamp_edges(coverage, side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const bool is_around = x >= 9 && x <= 14 && y >= 4 && y <= 9;
      const bool is_inside = x >= 11 && x <= 12 && y >= 6 && y <= 7;
      const bool is_dot = x >= 2 && x <= 4 && y >= 19 && y <= 21;
      EXPECT_EQ(edges[static_cast<std::size_t>(y * side + x)],
                (is_around && !is_inside) || is_dot ? 1 : 0)
          << x << " " << y;
    }
  }
}

TEST(Unit_LampPixels, HaveFewerRaysWhereTheyAreMany) {
  constexpr int side = 20;
  const RenderOptions options = lamp_settings(side, 4, some_rays).options;
  std::uint32_t rays = some_rays;
  for (std::size_t pixels = 1; pixels <= side * side; ++pixels) {
    const std::uint32_t now = affordable_lamp_rays(static_cast<double>(pixels), options);
    EXPECT_LE(now, rays);
    // In all no more than 2.4 for each of the picture's samples, which take some twenty times as
    // long.
    ASSERT_LE(static_cast<double>(now) * static_cast<double>(pixels), 2.4 * side * side);
    rays = now;
  }
  EXPECT_EQ(rays, 2u);
  EXPECT_EQ(affordable_lamp_rays(0.0, options), 0u);
}

// The number that --time and --error go without ends no picture.
TEST(Unit_LampPixels, ATrialTakesAShareOfTheSamplesThatAreSure) {
  SceneDescription scene = empty_scene();
  const auto lamp = add_material(scene, diffuse(Vec3d(0)), Vec3d(1));
  add_mesh(scene, quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}), lamp);
  set_camera(scene, {0, 0, 1}, {0, 0, 0}, 60);
  RenderOptions options = lamp_settings(20, 1 << 30, some_rays).options;
  const Scene compiled_scene = compiled(scene, options);
  const Filter filter = make_filter(options);
  const auto blocks = [&] { return plan_lamp_trial(compiled_scene, filter, options).blocks; };
  EXPECT_EQ(blocks(), 4u);
  options.time_limit_seconds = 1;
  EXPECT_EQ(blocks(), 3u);
  options.time_limit_seconds.reset();
  options.target_relmse = 1e-4;
  EXPECT_EQ(blocks(), 3u);
  options.samples_per_pixel = 16;
  EXPECT_EQ(blocks(), 0u);
}

TEST(Unit_LampPixels, NoneWhereItIsOver) {
  const RenderOptions options = lamp_settings(150, 8, some_rays).options;
  const Scene scene = compiled(small_room(), options);
  const BvhAccel accelerator(scene);
  const Filter filter = make_filter(options);
  const auto context = make_path_context(scene, accelerator, filter, options);
  with_threads(1, [&] {
    int asked = 0;
    const auto is_over_after = [&](int questions) {
      asked = 0;
      return find_lamp_pixels<media_features>(context,
                                              [&asked, questions] { return ++asked > questions; })
          .rays_a_sample();
    };
    EXPECT_GT(is_over_after(1 << 30), 0u);
    const int all = asked;
    EXPECT_GT(all, 4);
    for (int questions = 0; questions < all; ++questions)
      EXPECT_EQ(is_over_after(questions), 0u) << questions;
  });
}

TEST(Unit_LampPixels, AreFoundByTheirPlace) {
  LampPixels pixels(8, 2, [](const PixelRect&) {
    return std::vector<LampView>{{3, {}}, {10, {{0.5f, 0}, {0.25f, 1}}}};
  });
  EXPECT_EQ(pixels.find(3, 0), nullptr);
  pixels.set_rays_a_sample(4);
  ASSERT_NE(pixels.find(3, 0), nullptr);
  ASSERT_NE(pixels.find(2, 1), nullptr);
  EXPECT_EQ(pixels.find(2, 1)->part.share(), 0.25f);
  EXPECT_EQ(pixels.find(4, 0), nullptr);
  EXPECT_EQ(pixels.find(3, 1), nullptr);
  EXPECT_EQ(LampPixels().find(0, 0), nullptr);
}

// Of what is in a patch nobody knows until one of its pixels is asked for.
TEST(Unit_LampPixels, AreFoundOnceAPatch) {
  std::vector<PixelRect> asked;
  LampPixels pixels(150, 70, [&](const PixelRect& patch) {
    asked.push_back(patch);
    return std::vector<LampView>{{pixel_index(patch.x0, patch.y0, 150), {}}};
  });
  pixels.set_rays_a_sample(1);
  EXPECT_EQ(pixels.patch_count(), 6u);
  EXPECT_EQ(pixels.find(149, 69), nullptr);
  EXPECT_NE(pixels.find(128, 64), nullptr);
  EXPECT_NE(pixels.find(64, 0), nullptr);
  EXPECT_EQ(pixels.find(127, 63), nullptr);
  EXPECT_EQ(asked, (std::vector<PixelRect>{{128, 64, 150, 70}, {64, 0, 128, 64}}));
}

// How many there are is told by at most a thousand patches, whatever the picture's size.
TEST(Unit_LampPixels, AreCountedBySomeOfMany) {
  std::atomic<int> asked = 0;
  const auto count = [&](int size, std::size_t in_patch) {
    asked = 0;
    const LampPixels pixels(size, size, [&](const PixelRect&) {
      ++asked;
      return std::vector<LampView>(in_patch);
    });
    return count_lamp_pixels(pixels, 1, [] { return false; }).value_or(-1);
  };
  EXPECT_EQ(count(640, 3), 300);
  EXPECT_EQ(asked, 100);
  EXPECT_EQ(count(640, 0), 0);
  EXPECT_EQ(count(64 * 1000, 3), 3e6);
  EXPECT_EQ(asked, 1024);
  EXPECT_GT(count(64 * 1000, 0), 0);
}

// A crop of a picture that no machine could hold: its patches are the only ones that are looked at
// beside those that tell how many rays there are.
TEST(Agreement_LampPixels, CropsOfAGiantAreThoseOfALargerCrop) {
  constexpr PixelRect large{32730, 32740, 32776, 32775};
  constexpr PixelRect small{32763, 32751, 32773, 32769};
  RenderSettings settings = lamp_settings(65536, 1, some_rays);
  settings.options.crop = large;
  SceneDescription description = empty_scene();
  const auto lamp = add_material(description, diffuse(Vec3d(0)), Vec3d(1));
  add_mesh(description, triangle({0, 0, 0}, {1e-3, 1e-3, 0}, {1e-3, 3e-3, 0}), lamp);
  set_camera(description, {0, 0, 1}, {0, 0, 0}, 60);
  const Scene scene = compiled(description, settings.options);
  const RenderResult result = rendered(scene, settings);
  EXPECT_GT(result.statistics.rays.lamp, 0u);
  EXPECT_GT(result.statistics.skipped.samples, 0u);
  const Image whole = result.film.to_image(true);
  settings.options.crop = small;
  const Image part = picture(scene, settings);
  for (int y = small.y0; y < small.y1; ++y)
    for (int x = small.x0; x < small.x1; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(part.pixel(x - small.x0, y - small.y0)[c],
                  whole.pixel(x - large.x0, y - large.y0)[c]);
}

TEST(Unit_LampPixels, TheirRaysAreCountedApart) {
  const Scene scene = compiled(small_room(), lamp_settings(24, 8, some_rays).options);
  const RayCounts with = rendered(scene, lamp_settings(24, 8, some_rays)).statistics.rays;
  const RayCounts without = rendered(scene, lamp_settings(24, 8, 0)).statistics.rays;
  EXPECT_EQ(without.lamp, 0u);
  EXPECT_GT(with.lamp, 0u);
  EXPECT_EQ(with.lamp % 8, 0u);
  EXPECT_EQ(with.camera, without.camera);
  EXPECT_EQ(with.indirect, without.indirect);
}

TEST(Unit_LampPixels, NoneWithALens) {
  SceneDescription scene = small_room();
  scene.cameras[0].lens_radius = 0.1;
  scene.cameras[0].focus_distance = 3.5;
  EXPECT_EQ(rendered(scene, lamp_settings(24, 8, some_rays)).statistics.rays.lamp, 0u);
}

TEST(Agreement_LampPixels, SameBitsHoweverItIsRendered) {
  for (const SceneDescription& description : {small_room(), three_lamps()})
    for (const FilterKind filter : {FilterKind::BlackmanHarris, FilterKind::Mitchell}) {
      RenderSettings settings = lamp_settings(40, 20, some_rays);
      settings.options.filter = filter;
      const Scene scene = compiled(description, settings.options);
      const RenderResult result = rendered(scene, settings);
      EXPECT_GT(result.statistics.rays.lamp, 0u);
      const Image whole = result.film.to_image(true);
      expect_same_bits_however_rendered(scene, settings, whole, {13, 0, 31, 22});
      settings.options.uses_general_kernel = true;
      EXPECT_EQ(picture(scene, settings).values, whole.values);
    }
}

// Only what lamps send straight to the camera, of a lamp that covers a share of the pixel, down to
// less than the trial's rays tell from nothing.
TEST(Statistical_LampPixels, ShowTheShareThatIsCovered) {
  constexpr int size = 48;
  constexpr double pixel_width = 2.0 / size;  // the picture is 2 wide at the lamp's distance
  for (const double share : {0.5, 0.03, 0.004}) {
    SceneDescription scene = empty_scene();
    const auto lamp = add_material(scene, diffuse(Vec3d(0)), Vec3d(5));
    add_mesh(scene,
             quad({-4 * pixel_width, -4 * pixel_width, 0}, {(4 + share) * pixel_width, 0, 0},
                  {0, 8 * pixel_width, 0}),
             lamp);
    set_camera(scene, {0, 0, 1}, {0, 0, 0}, 90);
    statistics::Moments seen;
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
      RenderSettings settings = lamp_settings(size, 8, some_rays, seed);
      settings.options.filter = FilterKind::Box;
      settings.options.max_depth = 0;
      const RenderResult result = rendered(scene, settings);
      EXPECT_GT(result.statistics.rays.lamp, 0u);
      const Image image = result.film.to_image(false);
      for (int y = 22; y < 26; ++y) seen.add(static_cast<double>(image.pixel(size / 2, y)[0]));
    }
    EXPECT_GT(seen.p_value(5 * share), 0.01) << seen.mean() << " for " << 5 * share;
    // All rays look at the lamp: a hundredth of what those of the whole pixel would leave.
    EXPECT_LT(seen.variance(), share * (1 - share) * 25 / 8 / 8 / 100) << share;
  }
}

TEST(Statistical_LampPixels, SamePictureWithLessNoise) {
  constexpr int size = 48;
  constexpr int samples = 16;
  struct Case {
    SceneDescription description;
    FilterKind filter;
  };
  for (const Case& c : {Case{small_room(), FilterKind::BlackmanHarris},
                        Case{three_lamps(), FilterKind::BlackmanHarris},
                        Case{three_lamps(), FilterKind::Mitchell}}) {
    const Scene scene = compiled(c.description, lamp_settings(size, samples, 0).options);
    const auto moments = [&](int rays) {
      std::vector<statistics::Moments> pixels(size * size + 1);
      for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        RenderSettings settings = lamp_settings(size, samples, rays, seed);
        settings.options.filter = c.filter;
        const Image image = picture(scene, settings);
        const std::vector<double> values = grey(image);
        for (std::size_t i = 0; i < values.size(); ++i) pixels[i].add(values[i]);
        pixels.back().add(mean_of(image));
      }
      return pixels;
    };
    const auto without = moments(0);
    const auto with = moments(some_rays);
    EXPECT_GT(welch_p_value(without.back(), with.back()), 0.01)
        << without.back().mean() << " " << with.back().mean();
    double variance_without = 0;
    double variance_with = 0;
    for (std::size_t i = 0; i + 1 < with.size(); ++i) {
      variance_without += without[i].variance();
      variance_with += with[i].variance();
    }
    EXPECT_LT(variance_with, variance_without / 2);
  }
}

// Of each pixel, not in the mean alone: dimming what all of a sample's rays bring together would
// make pixels that a lamp touches as bright as it.
TEST(Statistical_LampPixels, SamePictureWithAClamp) {
  constexpr int size = 24;
  for (const FilterKind filter : {FilterKind::BlackmanHarris, FilterKind::Mitchell}) {
    const auto moments = [&](int rays) {
      std::vector<statistics::Moments> pixels(size * size);
      for (std::uint64_t seed = 1; seed <= 24; ++seed) {
        RenderSettings settings = lamp_settings(size, 32, rays, seed);
        settings.options.filter = filter;
        settings.options.clamp = 1;
        const std::vector<double> values =
            grey(rendered(small_room(), settings).film.to_image(false));
        for (std::size_t i = 0; i < values.size(); ++i) pixels[i].add(values[i]);
      }
      return pixels;
    };
    const auto without = moments(0);
    const auto with = moments(some_rays);
    double least = 1;
    for (std::size_t i = 0; i < with.size(); ++i)
      least = std::min(least, welch_p_value(without[i], with[i]));
    EXPECT_GT(least, 0.01 / (size * size)) << static_cast<int>(filter);
  }
}

}  // namespace
}  // namespace candela
