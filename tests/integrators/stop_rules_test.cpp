// render() ends where its rules say, and states what it should.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "integrators/tile_counts.h"
#include "tests/scenes/description.h"
#include "tests/scenes/meshes.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

description::SceneDescription furnace_of(double emission) {
  return test::furnace(test::inside_out(test::box({-1, -1, -1}, {1, 1, 1})), 0.5, emission);
}

Scene noisy_scene(const RenderOptions& options) {
  return test::compiled(furnace_of(1), options);
}

RenderResult noisy(const test::RenderSettings& settings) {
  return test::rendered(noisy_scene(settings.options), settings);
}

test::RenderSettings without_limit(int size) {
  return test::settings_of(size, 1 << 30);
}

// More than any goal here takes, so that a rule that never ends fails its test.
test::RenderSettings with_far_limit(int size) {
  return test::settings_of(size, 1 << 12);
}

TEST(Unit_StopRules, SamplesWhereNothingElseIsSaid) {
  const RenderResult result = noisy(test::settings_of(8, 24));
  EXPECT_EQ(result.statistics.stop, StopReason::Samples);
  EXPECT_EQ(result.film.min_samples(), 24u);
  EXPECT_EQ(result.film.max_samples(), 24u);
  EXPECT_EQ(result.film.replicates(), 4u);
  ASSERT_TRUE(result.error);
  EXPECT_GT(result.error->relmse, 0);
}

TEST(Unit_StopRules, TheErrorIsMetAndNotByFar) {
  test::RenderSettings settings = with_far_limit(32);
  settings.options.target_relmse = 1e-3;
  const RenderResult result = noisy(settings);
  EXPECT_EQ(result.statistics.stop, StopReason::Error);
  ASSERT_TRUE(result.error);
  EXPECT_LE(result.error->relmse, 1e-3);
  EXPECT_GT(result.error->relmse, 0.64e-3);   // an rMSE of at least 0.8 of what was asked for
  EXPECT_GT(result.film.min_samples(), 16u);  // it took more than one round
}

// What is stated may understate just then, of small pictures by much: half the way to the upper end
// of its interval has to be below the goal.
TEST(Unit_StopRules, TheUpperHalfOfTheIntervalCounts) {
  test::RenderSettings settings = with_far_limit(6);
  settings.options.target_relmse = 1e-2;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    settings.options.seed = seed;
    const RenderResult result = noisy(settings);
    ASSERT_TRUE(result.error);
    EXPECT_LE((result.error->relmse + result.error->interval95.high) / 2, 1e-2) << seed;
  }
}

TEST(Unit_StopRules, TheFirstRuleThatIsMetCounts) {
  test::RenderSettings settings = test::settings_of(16, 20);
  settings.options.target_relmse = 1e-30;
  settings.options.time_limit_seconds = 1e6;
  EXPECT_EQ(noisy(settings).statistics.stop, StopReason::Samples);
  settings.options.target_relmse = 1e30;
  const RenderResult result = noisy(settings);
  EXPECT_EQ(result.statistics.stop, StopReason::Error);
  EXPECT_EQ(result.film.max_samples(), 16u);
}

TEST(Unit_StopRules, TimeEndsWhatHasNoOtherEnd) {
  test::RenderSettings settings = without_limit(8);
  settings.options.time_limit_seconds = 0.05;
  const RenderResult result = noisy(settings);
  EXPECT_EQ(result.statistics.stop, StopReason::Time);
  EXPECT_GT(result.film.min_samples(), 0u);
}

TEST(Unit_StopRules, APictureWithoutNoiseMeetsAnyError) {
  test::RenderSettings settings = with_far_limit(8);
  settings.options.target_relmse = 1e-30;
  const Scene black = test::compiled(furnace_of(0), settings.options);
  const RenderResult result = test::rendered(black, settings);
  EXPECT_EQ(result.statistics.stop, StopReason::Error);
  EXPECT_EQ(result.error->relmse, 0);
}

// A box with its light outside: light that no sample meets may yet be all that there is.
description::SceneDescription box_in_light() {
  description::SceneDescription scene = furnace_of(0);
  test::add_light(scene, description::PointLight{{0, 5, 0}, Vec3d(10)});
  return scene;
}

TEST(Unit_StopRules, APictureThatHasMetNoLightMeetsNoError) {
  test::RenderSettings settings = test::settings_of(8, 64);
  settings.options.target_relmse = 1e30;
  for (const bool adaptive : {false, true}) {
    settings.options.adaptive = adaptive;
    const RenderResult result = test::rendered(box_in_light(), settings);
    EXPECT_EQ(result.statistics.stop, StopReason::Samples);
    EXPECT_FALSE(result.error);
  }
}

// As of a crop beside all there is, whatever else the pilot's squares see.
TEST(Unit_StopRules, ABlackBackgroundThatIsProvenHasNoError) {
  description::SceneDescription scene;
  const auto white = test::add_material(scene, test::diffuse(Vec3d(0.7)));
  test::add_mesh(scene, test::sphere({0, 0, 0}, 0.3, 2), white);
  test::add_light(scene, description::PointLight{{0, 5, 0}, Vec3d(10)});
  test::set_camera(scene, {0, 0, 5}, {0, 0, 0}, 50);
  test::RenderSettings settings = test::settings_of(64, 1 << 12);
  settings.options.adaptive = true;
  settings.options.target_relmse = 1e-30;
  settings.options.chooses_reuse = true;
  for (const PixelRect& crop : {PixelRect{1, 2, 9, 11}, {16, 16, 20, 20}}) {
    settings.options.crop = crop;
    const RenderResult result = test::rendered(scene, settings);
    EXPECT_EQ(result.statistics.stop, StopReason::Error);
    ASSERT_TRUE(result.error);
    EXPECT_EQ(result.error->relmse, 0);
  }
}

TEST(Unit_StopRules, OneReplicateStatesNothing) {
  test::RenderSettings settings = test::settings_of(8, 16);
  settings.options.replicates = 1;
  const RenderResult result = noisy(settings);
  EXPECT_FALSE(result.error);
  EXPECT_EQ(result.film.replicates(), 1u);
}

TEST(Unit_StopRules, ReplicatesAreNoMoreThanSamples) {
  EXPECT_EQ(noisy(test::settings_of(8, 2)).film.replicates(), 2u);
  EXPECT_EQ(noisy(test::settings_of(8, 1)).film.replicates(), 1u);
}

// The replicates see other numbers: were they the same, the error would be 0 or too small by far.
TEST(Statistical_Replicates, AreIndependentOfEachOther) {
  test::RenderSettings settings = test::settings_of(32, 64);
  const RenderResult result = noisy(settings);
  const Film& film = result.film;
  double covariance = 0;
  double variance = 0;
  for (std::size_t i = 0; i < film.pixel_count(); ++i) {
    const auto deviation = [&](std::uint32_t r) {
      return film.replicate_sum(i, r).x / film.samples_by_replicate(i).of(r) -
             2;  // 1 / (1 - albedo)
    };
    covariance += deviation(0) * deviation(1);
    variance += deviation(0) * deviation(0);
  }
  const double correlation = covariance / variance;
  EXPECT_LT(std::abs(correlation), 4 / std::sqrt(static_cast<double>(film.pixel_count())));
}

TEST(Unit_Clamp, DimsWithoutChangingTheHue) {
  Film film(2, 1, {0, 0, 2, 1}, 0, 1);
  TileCounts counts;
  FilmSample sample;
  sample.radiance = Rgb(4, 2, 1);
  add_or_count(sample, 0, 0, 0, 2, film, counts);
  EXPECT_EQ(film.mean(0), Vec3d(2, 1, 0.5));
  sample.radiance = Rgb(2, 1.5f, 0);
  add_or_count(sample, 1, 0, 0, 2, film, counts);
  EXPECT_EQ(film.mean(1), Vec3d(2, 1.5, 0));
}

TEST(Unit_Clamp, LeavesNothingBrighter) {
  test::RenderSettings settings = test::settings_of(8, 16);
  settings.options.clamp = 0.25f;
  const Image image = noisy(settings).film.to_image(false);
  EXPECT_LE(*std::max_element(image.values.begin(), image.values.end()), 0.25f);
  EXPECT_GT(test::mean_of(image), 0.2);
}

}  // namespace
}  // namespace candela
