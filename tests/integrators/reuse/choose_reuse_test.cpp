// Whether a trial lets pixels share what their paths find: where that saves more noise than it
// takes time, the same however rendered, and not where there is nothing to choose.
#include <gtest/gtest.h>

#include "integrators/render.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/room_of_a_point.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

RenderSettings choosing(int size, int samples, std::uint64_t seed = 1) {
  RenderSettings settings = settings_of(size, samples, seed);
  settings.options.chooses_reuse = true;
  return settings;
}

// Dark walls: the noise is of which parts of a large lamp are seen behind boxes.
SceneDescription room_of_shadows() {
  SceneDescription scene = furnace(inside_out(box({-1, -1, -1}, {1, 1, 1})), 0.15, 0);
  add_mesh(scene, quad({-0.8, 0.99, -0.8}, {1.6, 0, 0}, {0, 0, 1.6}),
           add_material(scene, diffuse(Vec3d(0)), Vec3d(2)));
  const auto grey = add_material(scene, diffuse(Vec3d(0.15)));
  for (int i = 0; i < 9; ++i)
    add_mesh(scene,
             box({-0.8 + 0.6 * (i % 3), 0, -0.8 + 0.6 * (i / 3)},
                 {-0.5 + 0.6 * (i % 3), 0.1, -0.5 + 0.6 * (i / 3)}),
             grey);
  return scene;
}

int times_shared(const SceneDescription& description) {
  int shared = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RenderSettings settings = choosing(96, 128, seed);
    settings.options.crop = PixelRect{0, 0, 1, 1};  // the trial is of the whole picture
    const RenderStatistics statistics = rendered(description, settings).statistics;
    EXPECT_GT(statistics.reuse_samples, 0u);
    shared += statistics.plan.reuses_paths ? 1 : 0;
  }
  return shared;
}

TEST(Statistical_ChooseReuse, SharesWhereIndirectLightHasTheNoise) {
  EXPECT_EQ(times_shared(room_of_a_point(0.7)), 8);
  EXPECT_EQ(times_shared(room_of_shadows()), 0);
}

TEST(Agreement_ChooseReuse, SameBitsOverThreadsTilesAndCrops) {
  RenderSettings settings = choosing(96, 96);
  settings.options.crop = PixelRect{10, 0, 34, 44};
  const Scene scene = compiled(room_of_a_point(0.7), settings.options);
  const RenderResult result = rendered(scene, settings);
  EXPECT_TRUE(result.statistics.plan.reuses_paths);
  expect_same_bits_however_rendered(scene, settings, result.film.to_image(true), {13, 5, 30, 40});
  RenderSettings told = settings;
  told.options.chooses_reuse = false;
  told.options.plan.reuses_paths = true;
  EXPECT_EQ(picture(scene, told).values, result.film.to_image(true).values);
}

TEST(Unit_ChooseReuse, NotOfFewSamplesNorWherePathsCannotBeShared) {
  const auto samples_of = [](const SceneDescription& description, const RenderSettings& settings) {
    const RenderStatistics statistics = rendered(description, settings).statistics;
    EXPECT_TRUE(statistics.reuse_samples > 0 || !statistics.plan.reuses_paths);
    return statistics.reuse_samples;
  };
  RenderSettings settings = choosing(640, 16);
  settings.options.crop = PixelRect{0, 0, 1, 1};
  const std::uint64_t clearly = samples_of(room_of_a_point(0.7), settings);
  EXPECT_GT(clearly, 0u);
  EXPECT_EQ(clearly % (512 * 8), 0u);
  EXPECT_LT(clearly, 640u * 640 * 16 / 100 / 2);
  settings.options.samples_per_pixel = 15;  // less than a block
  EXPECT_EQ(samples_of(room_of_a_point(0.7), settings), 0u);
  settings.options.samples_per_pixel = 256;
  EXPECT_EQ(samples_of(room_of_a_point(0), settings), 512u * 64) << "black: never clear";
  settings.options.width = settings.options.height = 96;
  settings.options.samples_per_pixel = 44;  // of which eight groups are more than one in 100
  EXPECT_EQ(samples_of(room_of_a_point(0.7), settings), 0u);
  settings.options.samples_per_pixel = 45;
  EXPECT_EQ(samples_of(room_of_a_point(0.7), settings), 512u * 8);
  SceneDescription mirrors = room_of_a_point(0.7);
  mirrors.materials[0].model = description::MirrorMaterial{};
  EXPECT_EQ(samples_of(mirrors, settings), 0u);
  settings.options.guiding = Guiding::On;
  EXPECT_EQ(samples_of(room_of_a_point(0.7), settings), 0u);
}

}  // namespace
}  // namespace candela
