// Adaptive sampling: right in expectation, right about its error, the same bits, and worth it.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "integrators/render_rounds.h"
#include "tests/integrators/synthetic_tile.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;

// Pixels whose samples are exponential about 1: the few of a pilot that are small by chance look
// as if there were no noise. One number a sample, its own for each seed. (Counts in which a pixel's
// own samples have a say would pass: they are smoothed over too many. Unit_SampleDensity holds that
// they have none.)
TileCounts exponential_tile(const TilePass& pass, Film& film) {
  return synthetic_tile(
      pass, film, [](std::uint64_t bits, int, int) { return -std::log(1 - unit_double(bits)); });
}

struct MeanAndErrors {
  double mean = 0;
  double true_relmse = 0;
  double stated_relmse = 0;
};

MeanAndErrors exponential_picture(std::uint64_t seed, int samples) {
  RenderSettings settings = settings_of(24, samples, seed);
  settings.options.adaptive = true;
  Film film(24, 24, {0, 0, 24, 24}, 0, 4);
  const RoundsDone done = render_rounds(settings.options, exponential_tile, film, nullptr, nullptr);
  MeanAndErrors result;
  for (std::size_t i = 0; i < film.pixel_count(); ++i) {
    const double value = film.mean(i).x;
    result.mean += value / static_cast<double>(film.pixel_count());
    result.true_relmse += square(value - 1) / 1.01 / static_cast<double>(film.pixel_count());
  }
  EXPECT_NEAR(film.mean_samples(), samples, 0.1 * samples);
  EXPECT_GT(film.max_samples(), film.min_samples());
  result.stated_relmse = done.error ? done.error->relmse : 0;
  return result;
}

TEST(Statistical_Adaptive, ExponentialPixelsKeepTheirMeanAndStateTheirError) {
  constexpr int seeds = 64;
  double sum = 0, squares = 0, true_relmse = 0, stated_relmse = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const MeanAndErrors picture = exponential_picture(static_cast<std::uint64_t>(seed), 128);
    sum += picture.mean;
    squares += picture.mean * picture.mean;
    true_relmse += picture.true_relmse;
    stated_relmse += picture.stated_relmse;
  }
  const double mean = sum / seeds;
  const double error = std::sqrt((squares / seeds - mean * mean) / (seeds - 1));
  EXPECT_LT(error, 1e-3);
  EXPECT_LT(std::abs(mean - 1) / error, 3) << mean;
  EXPECT_NEAR(stated_relmse / true_relmse, 1, 0.05);
}

// The mean of a room's picture against that of the plain render, over seeds.
TEST(Statistical_Adaptive, ARoomKeepsItsMean) {
  constexpr int seeds = 16;
  double sums[2] = {0, 0};
  double squares[2] = {0, 0};
  for (const bool adaptive : {false, true})
    for (int seed = 1; seed <= seeds; ++seed) {
      RenderSettings settings = settings_of(16, 128, static_cast<std::uint64_t>(seed));
      settings.options.adaptive = adaptive;
      const double mean = mean_of(rendered(small_room(), settings).film.to_image(false));
      sums[adaptive] += mean / seeds;
      squares[adaptive] += mean * mean / seeds;
    }
  double variance = 0;
  for (const int a : {0, 1}) variance += (squares[a] - sums[a] * sums[a]) / (seeds - 1);
  EXPECT_LT(std::sqrt(variance), 0.01 * sums[0]);
  EXPECT_LT(std::abs(sums[1] - sums[0]) / std::sqrt(variance), 3) << sums[0] << " " << sums[1];
}

RenderSettings adaptive_settings(int size) {
  RenderSettings settings = settings_of(size, 128);
  settings.options.adaptive = true;
  settings.options.aovs = aov_bit(Aov::Samples) | aov_bit(Aov::Albedo) | aov_bit(Aov::Variance);
  return settings;
}

TEST(Agreement_Adaptive, SameBitsOverThreadsTilesAndCrops) {
  const RenderSettings settings = adaptive_settings(32);
  const Scene scene = compiled(small_room(), settings.options);
  const RenderResult result = rendered(scene, settings);
  EXPECT_GT(result.film.max_samples(), result.film.min_samples());
  expect_same_bits_however_rendered(scene, settings, result.film.to_image(true), {5, 11, 20, 32});
}

// Of pilots whose samples share blocks: lights that every hit asks cost rays of their own, and
// which paths are left over for single steps depends on what else is on its way.
TEST(Agreement_Adaptive, SameBitsWhereThePilotsPixelsShareBlocks) {
  RenderSettings settings = adaptive_settings(48);
  settings.options.replicates = 5;
  settings.options.samples_per_pixel = 120;
  description::SceneDescription room = small_room();
  for (const double x : {-0.6, -0.2, 0.2, 0.6})
    add_light(room, description::PointLight{{x, 0.3, 0.4}, Vec3d(0.1)});
  const auto metal = add_material(room, description::ConductorMaterial{.roughness = {0.3, {}, 0}});
  add_mesh(room, sphere(Vec3d(0.2, -0.5, 0), 0.4, 3), metal);
  const Scene scene = compiled(room, settings.options);
  const RenderResult own = rendered(scene, settings);
  EXPECT_GT(own.film.max_samples(), own.film.min_samples());
  const Image whole = own.film.to_image(true);
  expect_same_bits_however_rendered(scene, settings, whole, {5, 11, 30, 40});
  settings.options.use_general_kernel = true;
  EXPECT_EQ(picture(scene, settings).values, whole.values);
}

// Too few samples for a pilot, or no replicates to tell its noise by: as without.
TEST(Unit_Adaptive, StandsBackWhereAPilotIsNotWorthIt) {
  for (const auto& [samples, replicates] : {std::pair{63, 4}, std::pair{256, 1}}) {
    RenderSettings settings = settings_of(8, samples);
    settings.options.replicates = replicates;
    const Scene scene = compiled(small_room(), settings.options);
    const Image plain = rendered(scene, settings).film.to_image(false);
    settings.options.adaptive = true;
    EXPECT_EQ(rendered(scene, settings).film.to_image(false).values, plain.values);
  }
}

TEST(Unit_Adaptive, AnInterruptedPilotIsAPicture) {
  RenderSettings settings = adaptive_settings(8);
  Film film(8, 8, {2, 2, 6, 6}, 0, 4);
  settings.options.crop = film.crop();
  CancelFlag cancel = false;
  const RoundsDone done = render_rounds(
      settings.options,
      [&](const TilePass& pass, Film& target) {
        const TileCounts counts = exponential_tile(pass, target);
        cancel = true;
        return counts;
      },
      film, nullptr, &cancel);
  EXPECT_EQ(done.stop, StopReason::Cancelled);
  EXPECT_EQ(film.crop(), (PixelRect{2, 2, 6, 6}));
  EXPECT_EQ(film.max_samples(), 16u);
}

TEST(Unit_Adaptive, TheErrorGoalIsMet) {
  RenderSettings settings = settings_of(24, 1 << 30);
  settings.options.adaptive = true;
  settings.options.target_relmse = 4e-3;
  const RenderResult result = rendered(small_room(), settings);
  EXPECT_EQ(result.statistics.stop, StopReason::Error);
  ASSERT_TRUE(result.error);
  EXPECT_LE(result.error->relmse, 4e-3);
  EXPECT_GT(result.film.max_samples(), result.film.min_samples());
}

}  // namespace
}  // namespace candela
