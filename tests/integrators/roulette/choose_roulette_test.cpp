// Roulette by what walks tell: more noise is saved than time is spent, the same bits however
// rendered, and nothing where there is nothing to choose.
#include <gtest/gtest.h>

#include <random>

#include "integrators/render.h"
#include "integrators/tile_counts.h"
#include "renderer/image/compare.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/scenes/room_of_a_point.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

RenderSettings choosing(int size, int samples, std::uint64_t seed = 1) {
  RenderSettings settings = settings_of(size, samples, seed);
  settings.options.plan.roulette_threshold = default_roulette_threshold;
  settings.options.chooses_roulette = true;
  return settings;
}

// Under a sky: whether a camera ray meets a leaf decides, and what bounces between them adds
// little.
SceneDescription leaves() {
  SceneDescription scene = empty_scene();
  const auto grey = add_material(scene, diffuse(Vec3d(0.2)));
  std::mt19937 random(1);
  const auto within = [&](double size) {
    return size * (2 * std::generate_canonical<double, 53>(random) - 1);
  };
  const auto vector = [&](double size) { return Vec3d(within(size), within(size), within(size)); };
  for (int i = 0; i < 1500; ++i) {
    const Vec3d corner = vector(1), along = vector(0.1), across = vector(0.1);
    add_mesh(scene, quad(corner, along, across), grey);
  }
  add_light(scene, description::ConstantEnvironment{Vec3d(1), true});
  set_camera(scene, {0, 0, 3}, {0, 0, 0}, 40);
  return scene;
}

PathPlan plan_of(const SceneDescription& scene, const RenderSettings& settings) {
  return rendered(scene, settings).statistics.plan;
}

// relMSE times bounces, in the mean over seeds.
double effort(const Scene& scene, const PathPlan& plan, const Image& reference) {
  double error = 0, rays = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    RenderSettings settings = settings_of(reference.width, 64, seed);
    settings.options.plan = plan;
    const RenderResult result = rendered(scene, settings);
    error += compare_images(result.film.to_image(false), reference)->relmse;
    rays += static_cast<double>(cost_of(result.statistics.rays));
  }
  return error * rays;
}

TEST(Statistical_ChooseRoulette, SavesMoreNoiseThanItTakesTime) {
  const RenderSettings settings = choosing(64, 128);
  const Scene scene = compiled(room_of_a_point(0.8), settings.options);
  const PathPlan chosen = rendered(scene, settings).statistics.plan;
  EXPECT_EQ(chosen.roulette_threshold, 0.25f);
  RenderSettings fine = settings_of(64, 1024, 99);
  fine.options.plan.roulette_threshold = 0.125f;
  const Image reference = rendered(scene, fine).film.to_image(false);
  EXPECT_LT(effort(scene, chosen, reference),
            0.9 * effort(scene, settings.options.plan, reference));
}

// With most seeds: few walks decide.
TEST(Statistical_ChooseRoulette, EndsPathsSoonerWhereFirstHitsHaveTheNoise) {
  int sooner = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    sooner += plan_of(leaves(), choosing(64, 128, seed)).first_roulette_bounce == 1;
  EXPECT_GT(sooner, 3);
}

TEST(Agreement_ChooseRoulette, SameBitsOverThreadsTilesAndCrops) {
  RenderSettings settings = choosing(96, 64);
  settings.options.crop = PixelRect{10, 0, 34, 44};
  const Scene scene = compiled(room_of_a_point(0.8), settings.options);
  const RenderResult result = rendered(scene, settings);
  EXPECT_NE(result.statistics.plan.roulette_threshold, default_roulette_threshold);
  expect_same_bits_however_rendered(scene, settings, result.film.to_image(true), {13, 5, 30, 40});
}

// Pixels that see the sky alone are skipped.
TEST(Agreement_ChooseRoulette, SameBitsOverKernels) {
  RenderSettings settings = choosing(64, 128);
  SceneDescription description = leaves();
  set_camera(description, {0, 0, 6}, {0, 0, 0}, 40);
  const Scene scene = compiled(description, settings.options);
  const RenderResult special = rendered(scene, settings);
  EXPECT_GT(special.statistics.skipped.samples, 0u);
  settings.options.uses_general_kernel = true;
  expect_part(special.film.to_image(true), picture(scene, settings), {0, 0, 64, 64});
}

SceneDescription foggy_box() {
  SceneDescription foggy = room_of_a_point(0.8);
  foggy.cameras[0].medium = add_medium(foggy, Vec3d(0.1), Vec3d(0.5));
  return foggy;
}
RenderSettings choosing_in_fog() {
  RenderSettings settings = choosing(64, 128);
  settings.options.max_depth = 6;
  return settings;
}

// Neither is done in scenes with media.
TEST(Unit_ChooseRoulette, NeitherGuidingNorSplittingStandsInItsWayInFog) {
  RenderSettings settings = choosing_in_fog();
  const Scene scene = compiled(foggy_box(), settings.options);
  const RenderResult plain = rendered(scene, settings);
  EXPECT_GT(plain.statistics.roulette_samples, 0u);
  settings.options.guiding = Guiding::Auto;
  settings.options.plan.splitting = 2;
  const RenderResult asked = rendered(scene, settings);
  EXPECT_EQ(asked.statistics.roulette_samples, plain.statistics.roulette_samples);
  EXPECT_EQ(asked.film.to_image(true).values, plain.film.to_image(true).values);
}

TEST(Agreement_ChooseRoulette, SameBitsOverKernelsInFog) {
  RenderSettings settings = choosing_in_fog();
  const Scene scene = compiled(foggy_box(), settings.options);
  const RenderResult special = rendered(scene, settings);
  EXPECT_GT(special.statistics.roulette_samples, 0u);
  settings.options.uses_general_kernel = true;
  expect_part(special.film.to_image(true), picture(scene, settings), {0, 0, 64, 64});
}

TEST(Unit_ChooseRoulette, NotOfFewSamplesNorOfSplitPaths) {
  const PathPlan usual = choosing(64, 128).options.plan;
  const auto expect_usual = [&](const RenderSettings& settings) {
    const RenderStatistics statistics = rendered(room_of_a_point(0.8), settings).statistics;
    EXPECT_EQ(statistics.roulette_samples, 0u);
    EXPECT_EQ(statistics.plan.roulette_threshold, usual.roulette_threshold);
  };
  expect_usual(choosing(64, 64));
  RenderSettings split = choosing(64, 128);
  split.options.plan.splitting = 2;
  expect_usual(split);
  RenderSettings guided = choosing(64, 128);
  guided.options.guiding = Guiding::On;
  expect_usual(guided);
  RenderSettings told = choosing(64, 128);
  told.options.chooses_roulette = false;
  expect_usual(told);
  EXPECT_EQ(rendered(room_of_a_point(0.8), choosing(64, 128)).statistics.roulette_samples,
            64u * 64 * 128 / 400 / 32 * 32);
}

}  // namespace
}  // namespace candela
