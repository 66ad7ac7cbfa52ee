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

MeanAndErrors exponential_picture(std::uint64_t seed, int samples, int replicates) {
  RenderSettings settings = settings_of(24, samples, seed);
  settings.options.adaptive = true;
  settings.options.replicates = replicates;
  Film film(24, 24, {0, 0, 24, 24}, 0, static_cast<std::uint32_t>(replicates));
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

// Over seeds: the true relMSE and the stated one.
MeanAndErrors expect_exponential_pixels_keep_their_mean(int replicates) {
  constexpr int seeds = 64;
  MeanAndErrors sum;
  double squares = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const MeanAndErrors picture =
        exponential_picture(static_cast<std::uint64_t>(seed), 128, replicates);
    sum.mean += picture.mean;
    squares += picture.mean * picture.mean;
    sum.true_relmse += picture.true_relmse;
    sum.stated_relmse += picture.stated_relmse;
  }
  const double mean = sum.mean / seeds;
  const double error = std::sqrt((squares / seeds - mean * mean) / (seeds - 1));
  EXPECT_LT(error, 1e-3);
  EXPECT_LT(std::abs(mean - 1) / error, 3) << mean;
  return sum;
}

TEST(Statistical_Adaptive, ExponentialPixelsKeepTheirMeanAndStateTheirError) {
  const MeanAndErrors sum = expect_exponential_pixels_keep_their_mean(4);
  EXPECT_NEAR(sum.stated_relmse / sum.true_relmse, 1, 0.05);
}

TEST(Statistical_Adaptive, ExponentialPixelsOfOneReplicateKeepTheirMean) {
  EXPECT_EQ(expect_exponential_pixels_keep_their_mean(1).stated_relmse, 0);
}

// The mean of a room's picture against that of the plain render, over seeds.
void expect_a_room_keeps_its_mean(int replicates) {
  constexpr int seeds = 16;
  double sums[2] = {0, 0};
  double squares[2] = {0, 0};
  for (const bool adaptive : {false, true})
    for (int seed = 1; seed <= seeds; ++seed) {
      RenderSettings settings = settings_of(16, 128, static_cast<std::uint64_t>(seed));
      settings.options.adaptive = adaptive;
      settings.options.replicates = replicates;
      const double mean = mean_of(rendered(small_room(), settings).film.to_image(false));
      sums[adaptive] += mean / seeds;
      squares[adaptive] += mean * mean / seeds;
    }
  double variance = 0;
  for (const int a : {0, 1}) variance += (squares[a] - sums[a] * sums[a]) / (seeds - 1);
  EXPECT_LT(std::sqrt(variance), 0.01 * sums[0]);
  EXPECT_LT(std::abs(sums[1] - sums[0]) / std::sqrt(variance), 3) << sums[0] << " " << sums[1];
}

TEST(Statistical_Adaptive, ARoomKeepsItsMean) {
  expect_a_room_keeps_its_mean(4);
}

TEST(Statistical_Adaptive, ARoomOfOneReplicateKeepsItsMean) {
  expect_a_room_keeps_its_mean(1);
}

RenderSettings adaptive_settings(int size) {
  RenderSettings settings = settings_of(size, 128);
  settings.options.adaptive = true;
  settings.options.aovs = aov_bit(Aov::Samples) | aov_bit(Aov::Albedo) | aov_bit(Aov::Variance);
  return settings;
}

TEST(Agreement_Adaptive, SameBitsOverThreadsTilesAndCrops) {
  RenderSettings settings = adaptive_settings(32);
  const Scene scene = compiled(small_room(), settings.options);
  for (const int replicates : {4, 1}) {
    settings.options.replicates = replicates;
    const RenderResult result = rendered(scene, settings);
    EXPECT_GT(result.film.max_samples(), result.film.min_samples());
    expect_same_bits_however_rendered(scene, settings, result.film.to_image(true), {5, 11, 20, 32});
  }
}

// The pilot's samples and those after it are the first of a pixel's: where a pixel got as few as
// any, they are those of a plain picture of that many.
TEST(Agreement_Adaptive, SamplesAreTheFirstOfAPixels) {
  for (const int replicates : {4, 1}) {
    RenderSettings settings = adaptive_settings(24);
    settings.options.replicates = replicates;
    const Film film = rendered(small_room(), settings).film;
    settings.options.adaptive = false;
    settings.options.samples_per_pixel = static_cast<int>(film.min_samples());
    const Film plain = rendered(small_room(), settings).film;
    int compared = 0;
    for (std::size_t i = 0; i < film.pixel_count(); ++i) {
      if (film.samples(i) != film.min_samples()) continue;
      EXPECT_NEAR(film.mean(i).x, plain.mean(i).x, 1e-12 * plain.mean(i).x);
      ++compared;
    }
    EXPECT_GT(compared, 0);
    EXPECT_LT(compared, 24 * 24);
  }
}

// The left half has a tenth of the noise of the right one.
TEST(Unit_Adaptive, SamplesGoWhereTheNoiseIs) {
  for (const int replicates : {4, 2, 1}) {
    RenderSettings settings = adaptive_settings(24);
    settings.options.replicates = replicates;
    Film film(24, 24, {0, 0, 24, 24}, 0, static_cast<std::uint32_t>(replicates));
    const auto half_noisy_tile = [](const TilePass& pass, Film& target) {
      return synthetic_tile(pass, target, [](std::uint64_t bits, int x, int) {
        return 1 + (x < 12 ? 0.1 : 1) * (unit_double(bits) - 0.5);
      });
    };
    (void)render_rounds(settings.options, half_noisy_tile, film, nullptr, nullptr);
    EXPECT_GT(film.samples(film.index(18, 10)), 3 * film.samples(film.index(5, 10))) << replicates;
    EXPECT_NEAR(film.mean_samples(), 128, 4) << replicates;
  }
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
  settings.options.uses_general_kernel = true;
  EXPECT_EQ(picture(scene, settings).values, whole.values);
}

// Too few samples for a pilot: as without.
TEST(Unit_Adaptive, StandsBackWhereAPilotIsNotWorthIt) {
  for (const int replicates : {4, 1}) {
    RenderSettings settings = settings_of(8, 63);
    settings.options.replicates = replicates;
    const Scene scene = compiled(small_room(), settings.options);
    const Image plain = rendered(scene, settings).film.to_image(false);
    settings.options.adaptive = true;
    EXPECT_EQ(rendered(scene, settings).film.to_image(false).values, plain.values);
  }
}

void expect_an_interrupted_pilot_is_a_picture(int replicates) {
  RenderSettings settings = adaptive_settings(8);
  settings.options.replicates = replicates;
  Film film(8, 8, {2, 2, 6, 6}, 0, static_cast<std::uint32_t>(replicates));
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
  EXPECT_GT(film.mean(0).x, 0);
}

TEST(Unit_Adaptive, AnInterruptedPilotIsAPicture) {
  expect_an_interrupted_pilot_is_a_picture(4);
  expect_an_interrupted_pilot_is_a_picture(1);
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
