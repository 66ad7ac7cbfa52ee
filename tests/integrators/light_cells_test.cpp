// --light-cells: whole pictures with lights by what they may send and by power.
#include <gtest/gtest.h>

#include "tests/integrators/lane_steps.h"
#include "tests/integrators/replicated_pictures.h"
#include "tests/scenes/description.h"
#include "tests/scenes/exact_sphere.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// Balls that shine above a floor, half of whose triangles no point sees.
SceneDescription balls_that_shine(int subdivisions) {
  SceneDescription scene = empty_scene();
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(8.0));
  add_mesh(scene, quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}),
           add_material(scene, diffuse(Vec3d(0.7))));
  add_mesh(scene, sphere({-0.8, 0.3, 0.5}, 0.15, subdivisions), lamp);
  add_mesh(scene, sphere({0.7, 0.6, 0.9}, 0.2, subdivisions), lamp);
  add_mesh(scene, sphere({0, -0.2, 0.3}, 0.25, 2), add_material(scene, diffuse({0.2, 0.5, 0.8})));
  set_camera(scene, {0.5, -2.5, 1.2}, {-0.2, 0, 0.3}, 60, {0, 0, 1});
  return scene;
}

statistics::Replicates replicates_of(const SceneDescription& description, bool by_cells,
                                     std::uint64_t first_seed, int max_depth,
                                     SamplingStrategy strategy = SamplingStrategy::Mis,
                                     std::uint32_t splitting = 1) {
  RenderSettings settings = settings_of(16, 64, first_seed);
  settings.options.light_cells = by_cells;
  settings.options.max_depth = max_depth;
  settings.options.sampling = strategy;
  settings.options.plan.splitting = splitting;
  return replicated_pictures(description, settings, by_cells ? "by cells" : "by power");
}

void expect_agreement(const SceneDescription& scene, SamplingStrategy strategy, const char* name) {
  const auto result = statistics::compare_replicates(replicates_of(scene, true, 200, 4, strategy),
                                                     replicates_of(scene, false, 100, 4));
  EXPECT_TRUE(result.passed) << name << ": " << result.message;
}

// Few lights, asked at the first hit alone, and many; light samples alone see all of them, too.
TEST(Agreement_LightCells, GiveOnePicture) {
  expect_agreement(balls_that_shine(1), SamplingStrategy::Mis, "few");
  expect_agreement(balls_that_shine(1), SamplingStrategy::Light, "few, light samples alone");
  expect_agreement(balls_that_shine(4), SamplingStrategy::Mis, "many");
  expect_agreement(balls_that_shine(4), SamplingStrategy::Light, "many, light samples alone");
}

TEST(Agreement_LightCells, GiveOnePictureWithinMedia) {
  SceneDescription scene = balls_that_shine(1);
  scene.cameras[0].medium = add_medium(scene, Vec3d(0.05), Vec3d(0.6), 0.3);
  expect_agreement(scene, SamplingStrategy::Mis, "fog");
}

// Paths that are split weigh what they meet by the cell of their first hit, too.
TEST(Agreement_LightCells, GiveOnePictureOfSplitPaths) {
  const SceneDescription scene = balls_that_shine(1);
  const auto result =
      statistics::compare_replicates(replicates_of(scene, true, 200, 1, SamplingStrategy::Mis, 8),
                                     replicates_of(scene, false, 100, 1));
  EXPECT_TRUE(result.passed) << result.message;
}

// By single steps as well as side by side, and where exact spheres or media want other kernels.
TEST(Agreement_LightCells, LanesAreSingleSteps) {
  for (const int subdivisions : {1, 4}) {
    SceneDescription scene = balls_that_shine(subdivisions);
    expect_single_steps(scene, settings_of(32, 40), "path/lanes", "triangles");
    add_mesh(scene, exact_sphere(0.3), add_material(scene, diffuse(Vec3d(0.5))),
             at_place({0.5, -0.5, 0.4}));
    expect_single_steps(scene, settings_of(32, 40), "path/lanes", "and a sphere");
  }
}

double noise_of(const SceneDescription& scene, bool by_cells) {
  const statistics::Replicates replicates = replicates_of(scene, by_cells, 300, 1);
  statistics::Moments logarithms;
  for (std::size_t pixel = 0; pixel < replicates.images[0].size(); ++pixel) {
    statistics::Moments moments;
    for (const std::vector<double>& image : replicates.images) moments.add(image[pixel]);
    if (moments.variance() > 0) logarithms.add(std::log(moments.variance()));
  }
  EXPECT_GT(logarithms.count(), 100u);
  return std::exp(logarithms.mean());
}

TEST(Statistical_LightCells, LeaveLessNoiseOfDirectLight) {
  for (const int subdivisions : {1, 3}) {
    const SceneDescription scene = balls_that_shine(subdivisions);
    EXPECT_LT(noise_of(scene, true), 0.6 * noise_of(scene, false)) << subdivisions;
  }
}

}  // namespace
}  // namespace candela
