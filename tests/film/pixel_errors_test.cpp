#include "renderer/film/pixel_errors.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/film/synthetic_film.h"

namespace candela {
namespace {

constexpr int size = 24;

bool is_noisy(int x, int y) {
  return (x * 5 + y * 11) % 13 == 0;
}

// Pixels are taken sixteen by sixteen, those with fewer replicates by themselves.
TEST(Unit_PixelErrors, AreThoseOfTheirPixels) {
  Film film(size, size, {0, 0, size, size}, 0, 4);
  std::mt19937_64 random(5);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (int s = 0; s < ((x + y) % 5 == 0 ? 3 : 8); ++s) {
        FilmSample sample;
        const double noise = std::uniform_real_distribution<double>(-0.5, 0.5)(random);
        sample.radiance = Rgb(static_cast<float>(1 + (is_noisy(x, y) ? noise : 0)));
        film.add(x, y, sample);
      }
  const PixelErrors errors = *estimate_pixel_errors(film);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double error = errors.errors[film.index(x, y)];
      if (is_noisy(x, y))
        EXPECT_GT(error, 1e-5) << x << "," << y;
      else
        EXPECT_NEAR(error, 0, 1e-20) << x << "," << y;
    }
}

// With a level of 1 and little else the error is the variance of the mean, over 1.01: relMSE's
// epsilon is .01 of the square of the picture's mean.
TEST(Unit_PixelErrors, InTheMeanTheyAreTheVariance) {
  for (const int replicates : {2, 3, 4, 5, 8}) {
    const Film film =
        test::synthetic_film(64, 8 * replicates, static_cast<std::uint32_t>(replicates), 9,
                             [](std::mt19937_64& random, int, int) {
                               return std::uniform_real_distribution<double>(0.9, 1.1)(random);
                             });
    const PixelErrors errors = *estimate_pixel_errors(film);
    double sum = 0;
    for (const double error : errors.errors) sum += error;
    const double variance = 0.04 / 12 / (8 * replicates);
    EXPECT_NEAR(sum / static_cast<double>(film.pixel_count()) * 1.01 / variance, 1, 0.05)
        << replicates;
  }
}

// Pixels of which none tells of its neighbours: each is held against what it has itself, though of
// two replicates none is left beside the pair.
TEST(Statistical_PixelErrors, PixelsUnlikeTheirNeighboursAreHeldAgainstThemselves) {
  constexpr int size = 64;
  std::mt19937_64 levels(3);
  std::vector<double> truth(size * size);
  for (double& r : truth) r = std::uniform_real_distribution<double>(0.5, 2)(levels);
  const auto at = [&](int x, int y) { return truth[static_cast<std::size_t>(y * size + x)]; };
  for (const std::uint32_t replicates : {2u, 3u, 4u, 8u}) {
    double stated = 0, is = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Film film = test::synthetic_film(
          size, 24, replicates, 100 * replicates + seed,
          [&](std::mt19937_64& random, int x, int y) {
            return at(x, y) + std::uniform_real_distribution<double>(-0.1, 0.1)(random);
          });
      const PixelErrors errors = *estimate_pixel_errors(film);
      stated += std::accumulate(errors.errors.begin(), errors.errors.end(), 0.0) / (size * size);
      is += test::relmse_to(at, film);
    }
    EXPECT_NEAR(stated / is, 1, 0.05) << replicates;
  }
}

// Bright pixels of which some samples are dark: without its brightest replicate a pixel seems
// brighter than it is, which what is near by says, too.
TEST(Statistical_PixelErrors, DarkSamplesAmongBrightOnes) {
  constexpr int size = 48;
  for (const std::uint32_t replicates : {3u, 4u}) {
    double stated = 0, is = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const Film film = test::synthetic_film(
          size, static_cast<int>(replicates), replicates, 10 * seed + replicates,
          [](std::mt19937_64& random, int, int) {
            return std::uniform_real_distribution<double>(0, 1)(random) < 0.75 ? 1.0 : 0.0;
          });
      const PixelErrors errors = *estimate_pixel_errors(film);
      stated += std::accumulate(errors.errors.begin(), errors.errors.end(), 0.0) / (size * size);
      is += test::relmse_to([](int, int) { return 0.75; }, film);
    }
    EXPECT_NEAR(stated / is, 1, 0.07) << replicates;
  }
}

}  // namespace
}  // namespace candela
