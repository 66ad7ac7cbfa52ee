// Splitting at the first hit and the threshold of Russian roulette: right in expectation, the same
// bits, less noise, and chosen where they pay.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "integrators/render.h"
#include "renderer/image/compare.h"
#include "scene_io/load.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// Lamps, a sky, a mirror, glass, a lens: whatever a first hit can be.
SceneDescription room_of_kinds() {
  SceneDescription scene = small_room();
  add_mesh(scene, quad({-0.9, -0.9, 0.3}, {0.6, 0, 0.3}, {0, 0.8, 0}),
           add_material(scene, description::MirrorMaterial{}));
  add_mesh(scene, quad({0.2, -0.9, 0.5}, {0.6, 0, 0.2}, {0, 0.8, 0}),
           add_material(scene, description::DielectricMaterial{}));
  add_light(scene, description::PointLight{{0.2, 0.6, 0.1}, Vec3d(0.3)});
  add_light(scene, description::ConstantEnvironment{Vec3d(0.2), true});
  return scene;
}

// Its direct light has no noise at all, and most of its light has bounced.
SceneDescription lamp_in_a_box() {
  SceneDescription scene = furnace(inside_out(box({-1, -1, -1}, {1, 1, 1})), 0.7, 0);
  add_light(scene, description::PointLight{{0.3, 0.4, 0.2}, Vec3d(1)});
  return scene;
}

RenderSettings split_settings(int size, int samples, std::optional<int> splitting,
                              std::uint64_t seed = 1) {
  RenderSettings settings = settings_of(size, samples, seed);
  settings.options.splitting = splitting;
  return settings;
}

statistics::Moments means_over_seeds(const Scene& scene, const PathPlan& plan,
                                     std::optional<int> max_depth) {
  statistics::Moments means;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    RenderSettings settings = split_settings(24, 20, static_cast<int>(plan.splitting), seed);
    settings.options.roulette_threshold = plan.roulette_threshold;
    settings.options.max_depth = max_depth;
    means.add(mean_of(picture(scene, settings)));
  }
  return means;
}

TEST(Statistical_PathPlan, KeepsTheMean) {
  for (const SceneDescription& description : {small_room(), room_of_kinds()})
    for (const std::optional<int> max_depth : {std::optional<int>(), std::optional(1)}) {
      const Scene scene = compiled(description, settings_of(24, 20).options);
      const statistics::Moments plain = means_over_seeds(scene, {1, 1}, max_depth);
      for (const PathPlan& plan : {PathPlan{3, 1}, PathPlan{1, 0.25f}, PathPlan{2, 0.5f}}) {
        const statistics::Moments planned = means_over_seeds(scene, plan, max_depth);
        const double error = std::hypot(plain.standard_error(), planned.standard_error());
        EXPECT_LT(error, 0.02 * plain.mean());
        EXPECT_LT(std::abs(planned.mean() - plain.mean()) / error, 3)
            << plain.mean() << " " << planned.mean();
      }
    }
}

struct Errors {
  double stated = 0;
  double true_relmse = 0;
};

Errors errors_over_seeds(const Scene& scene, int splitting, const Image& reference) {
  Errors errors;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto result = rendered(scene, split_settings(reference.width, 64, splitting, seed));
    errors.stated += result.error->relmse;
    errors.true_relmse += compare_images(result.film.to_image(false), reference)->rel_mse;
  }
  return errors;
}

// Four paths for one at a quarter of the noise, nearly: what is left is that of the first hit. And
// the error that is stated knows, though it overstates what the lamp's edges have in both.
TEST(Statistical_Splitting, LowersTheErrorThatIsStated) {
  const Scene scene = compiled(small_room(), settings_of(32, 64).options);
  const Image reference = rendered(scene, split_settings(32, 1024, 4, 107)).film.to_image(false);
  const Errors whole = errors_over_seeds(scene, 1, reference);
  const Errors split = errors_over_seeds(scene, 4, reference);
  EXPECT_LT(split.true_relmse, 0.5 * whole.true_relmse);
  EXPECT_LT(split.stated, 2 / 3.0 * whole.stated);
  const auto once = rendered(scene, split_settings(32, 16, 1));
  const auto often = rendered(scene, split_settings(32, 16, 4));
  EXPECT_EQ(often.statistics.rays.camera, once.statistics.rays.camera);
  EXPECT_GT(often.statistics.rays.indirect, 3 * once.statistics.rays.indirect);
}

// In a closed box each hit multiplies the throughput by the albedo, and nothing but roulette ends a
// path: the mean number of its rays is known.
TEST(Statistical_PathPlan, PathsEndWhereTheThresholdSaysSo) {
  const double albedo = 0.7;  // lamp_in_a_box()
  for (const double threshold : {1.0, 0.5, 0.2}) {
    RenderSettings settings = settings_of(32, 64);
    settings.options.roulette_threshold = static_cast<float>(threshold);
    const Scene scene = compiled(lamp_in_a_box(), settings.options);
    const RayCounts rays = rendered(scene, settings).statistics.rays;
    double expected = 0;
    double alive = 1;
    double throughput = 1;
    for (int bounce = 0; bounce < 200; ++bounce) {  // leaving the hit of this number
      throughput *= albedo;
      if (bounce >= 2) {
        const double survival = std::min(throughput / threshold, 0.998);
        alive *= survival;
        throughput /= survival;
      }
      expected += alive;
    }
    const double found = static_cast<double>(rays.indirect) / static_cast<double>(rays.camera);
    EXPECT_NEAR(found, expected, 0.01 * expected) << threshold;
  }
}

// The trial takes its difference from a whole picture for what is after the first hit: the two may
// have nothing else in common.
TEST(Statistical_Splitting, SplitPathsShareTheFirstHitAlone) {
  const Scene scene = compiled(lamp_in_a_box(), settings_of(48, 16).options);
  const Image reference = rendered(scene, split_settings(48, 1024, 4, 107)).film.to_image(false);
  double products = 0, whole_squares = 0, split_squares = 0;
  std::uint64_t pixels = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RenderSettings settings = split_settings(48, 4, 1, seed);
    settings.options.replicates = 1;
    const Image whole = rendered(scene, settings).film.to_image(false);
    settings.options.splitting = 4;
    const Image split = rendered(scene, settings).film.to_image(false);
    for (std::size_t i = 0; i < reference.values.size(); i += 4, ++pixels) {
      const double w = double{whole.values[i]} - double{reference.values[i]};
      const double s = double{split.values[i]} - double{reference.values[i]};
      products += w * s;
      whole_squares += w * w;
      split_squares += s * s;
    }
  }
  const double correlation = products / std::sqrt(whole_squares * split_squares);
  EXPECT_LT(std::abs(correlation) * std::sqrt(static_cast<double>(pixels)), 3) << correlation;
}

struct PlansOfSeeds {
  std::uint32_t fewest = 4;  // paths from a first hit
  std::uint32_t most = 1;
};

// Renders one pixel, for which the trial is that of the whole picture.
PlansOfSeeds plans_of_seeds(const SceneDescription& description, int samples = 64) {
  PlansOfSeeds plans;
  RenderSettings settings = split_settings(96, samples, std::nullopt);
  settings.options.crop = PixelRect{0, 0, 1, 1};
  settings.options.roulette_threshold.reset();
  settings.options.target_relmse = 1e30;
  const Scene scene = compiled(description, settings.options);
  for (settings.options.seed = 1; settings.options.seed <= 8; ++settings.options.seed) {
    const std::uint32_t splitting = rendered(scene, settings).statistics.plan.splitting;
    plans.fewest = std::min(plans.fewest, splitting);
    plans.most = std::max(plans.most, splitting);
  }
  return plans;
}

// Where it is clear what pays, every trial finds it.
TEST(Statistical_Splitting, TrialsOfOtherSeedsAgree) {
  EXPECT_EQ(plans_of_seeds(lamp_in_a_box()).fewest, 4u);
  EXPECT_GE(plans_of_seeds(small_room()).fewest, 2u);
}

// Nearly all the noise is in the light that comes straight from the sky; also where an error ends
// the render and not the samples, whose number says nothing then.
TEST(Statistical_Splitting, PathsUnderASkyAreNotSplit) {
  const auto sky =
      load(CANDELA_SOURCE_DIR "/tools/benchmarks/blender/scenes/environment_lit.yaml", {});
  ASSERT_TRUE(sky);
  EXPECT_EQ(plans_of_seeds(*sky).most, 1u);
  EXPECT_EQ(plans_of_seeds(*sky, 1 << 20).most, 1u);
}

TEST(Agreement_Splitting, SameBitsOverThreadsTilesAndCrops) {
  for (const std::optional<int> splitting : {std::optional(4), std::optional<int>()}) {
    RenderSettings settings = split_settings(96, 84, splitting);
    if (!splitting) settings.options.roulette_threshold.reset();
    settings.options.crop = PixelRect{10, 0, 34, 44};
    settings.options.aovs = aov_bit(Aov::Albedo) | aov_bit(Aov::Variance);
    const Scene scene = compiled(lamp_in_a_box(), settings.options);
    const RenderResult result = rendered(scene, settings);
    EXPECT_GT(result.statistics.plan.splitting, 1u);
    expect_same_bits_however_rendered(scene, settings, result.film.to_image(true), {13, 5, 30, 40});
  }
}

// Blocks that are cut trace their rays one by one.
TEST(Agreement_Splitting, SameBitsOverKernelsAndCutBlocks) {
  RenderSettings settings = split_settings(24, 16, 4);
  settings.options.replicates = 1;
  const Scene scene = compiled(small_room(), settings.options);
  const RenderResult special = rendered(scene, settings);
  EXPECT_EQ(special.statistics.kernel, "path/lanes");
  settings.options.use_general_kernel = true;
  EXPECT_EQ(picture(scene, settings).values, special.film.to_image(true).values);

  settings.options.samples_per_pixel = 7;
  const Film cut = rendered(scene, settings).film;
  settings.options.samples_per_pixel = 6;
  const Film shorter = rendered(scene, settings).film;
  settings.accelerator = AcceleratorKind::Bvh;
  settings.options.samples_per_pixel = 16;
  const Film bvh = rendered(scene, settings).film;
  std::size_t different = 0;
  for (std::size_t i = 0; i < cut.pixel_count(); ++i) {
    EXPECT_TRUE(
        glm::all(glm::greaterThanEqual(cut.replicate_sum(i, 0), shorter.replicate_sum(i, 0))));
    const double own = special.film.mean(i).y;
    if (std::abs(bvh.mean(i).y - own) > 1e-3 * own) ++different;
  }
  EXPECT_LT(different, cut.pixel_count() / 50);  // hits at edges
}

PathPlan found_plan(const SceneDescription& scene, RenderSettings settings) {
  settings.options.splitting.reset();
  settings.options.roulette_threshold.reset();
  settings.options.crop = PixelRect{0, 0, 4, 4};
  return rendered(scene, settings).statistics.plan;
}

// Small lamps close above a floor: nearly all noise is in the choice of a lamp at the first hit.
SceneDescription floor_under_lamps() {
  SceneDescription scene;
  add_mesh(scene, quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}),
           add_material(scene, diffuse(Vec3d(0.9))));
  const auto lamp = add_material(scene, diffuse(Vec3d(0.0)), Vec3d(100.0));
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      add_mesh(scene, quad({-2 + 0.5 * column, 0.4, 2 - 0.5 * row}, {0, 0, -0.02}, {0.02, 0, 0}),
               lamp);
  add_mesh(scene, quad({-2, 1, -2}, {4, 0, 0}, {0, 0, 4}),
           add_material(scene, diffuse(Vec3d(0.9))));
  set_camera(scene, {0, 0.7, 1.9}, {0, 0.2, 0}, 60);
  return scene;
}

TEST(Unit_Splitting, IsChosenWhereItPays) {
  EXPECT_EQ(found_plan(lamp_in_a_box(), settings_of(96, 64)).splitting, 4u) << "light that bounces";
  EXPECT_EQ(found_plan(lamp_in_a_box(), settings_of(16, 64)).splitting, 1u)
      << "too small for a trial";
  RenderSettings emission_only = settings_of(96, 64);
  emission_only.options.max_depth = 0;
  EXPECT_EQ(found_plan(lamp_in_a_box(), emission_only).splitting, 1u) << "nothing to split";
}

TEST(Unit_RouletteThreshold, IsLowWhereLongPathsPay) {
  EXPECT_EQ(found_plan(lamp_in_a_box(), settings_of(96, 64)).roulette_threshold, 0.25f)
      << "light that bounces";
  EXPECT_EQ(found_plan(floor_under_lamps(), settings_of(96, 64)).roulette_threshold, 0.5f)
      << "noise of the first hit";
  EXPECT_EQ(found_plan(lamp_in_a_box(), settings_of(16, 64)).roulette_threshold, 0.5f)
      << "too small for a trial";
}

// A scene with media cannot be split, and has a trial for its roulette nevertheless.
TEST(Unit_RouletteThreshold, IsTriedInMediaToo) {
  SceneDescription scene = lamp_in_a_box();
  scene.cameras[0].medium = add_medium(scene, Vec3d(0.01), Vec3d(0.0));
  const PathPlan plan = found_plan(scene, settings_of(96, 64));
  EXPECT_EQ(plan.roulette_threshold, 0.25f);
  EXPECT_EQ(plan.splitting, 1u);
}

TEST(Unit_RouletteThreshold, WhatTheOptionsSayStays) {
  RenderSettings settings = settings_of(96, 64);
  settings.options.crop = PixelRect{0, 0, 4, 4};
  settings.options.splitting.reset();
  for (const float threshold : {0.25f, 0.5f, 1.0f}) {
    settings.options.roulette_threshold = threshold;
    const PathPlan split = rendered(lamp_in_a_box(), settings).statistics.plan;
    EXPECT_EQ(split.roulette_threshold, threshold);
    EXPECT_EQ(split.splitting, 4u);
  }
  settings.options.splitting = 3;
  settings.options.roulette_threshold.reset();
  const PathPlan patient = rendered(lamp_in_a_box(), settings).statistics.plan;
  EXPECT_EQ(patient.splitting, 3u);
  EXPECT_EQ(patient.roulette_threshold, 0.25f);
}

}  // namespace
}  // namespace candela
