// Samples go where a pilot is wrong for what they cost there, and all of them go somewhere.
#include "renderer/film/sample_density.h"

#include <gtest/gtest.h>

#include "tests/film/synthetic_film.h"

namespace candela {
namespace {

constexpr int size = 64;

// 1 with a standard deviation of `noise(x)` a sample; each costs cost(x).
template <class Noise, class Cost>
Film pilot_of(const Noise& noise, const Cost& cost) {
  Film film = test::synthetic_film(size, 16, 4, 5, [&](std::mt19937_64& random, int x, int) {
    return 1 + noise(x) * (std::uniform_real_distribution<double>(-1, 1)(random));
  });
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) film.add_cost(x, y, 16 * cost(x));
  return film;
}

// Over a column, away from others by more than the smoothing reaches.
double column_mean(const SampleDensity& density, int x) {
  double sum = 0;
  for (int y = 0; y < size; ++y) sum += static_cast<double>(density.at(x, y)) / size;
  return sum;
}

TEST(Unit_SampleDensity, FollowsTheErrorOfHalves) {
  const SampleDensity density(
      pilot_of([](int x) { return x < size / 2 ? 0.2 : 0.6; }, [](int) { return 1u; }));
  // A tenth of all is dealt out evenly, the rest by 1 : 3 about a mean of 2.
  EXPECT_NEAR(column_mean(density, 10), 0.1 + 0.9 * 0.5, 0.05);
  EXPECT_NEAR(column_mean(density, 54), 0.1 + 0.9 * 1.5, 0.08);
}

TEST(Unit_SampleDensity, FollowsTheCostOfHalves) {
  const SampleDensity density(
      pilot_of([](int) { return 0.4; }, [](int x) { return x < size / 2 ? 4u : 1u; }));
  EXPECT_NEAR(column_mean(density, 10), 0.1 + 0.9 * 2.0 / 3, 0.06);
  EXPECT_NEAR(column_mean(density, 54), 0.1 + 0.9 * 4.0 / 3, 0.08);
}

TEST(Unit_SampleDensity, WithoutNoiseAllGetTheSame) {
  const SampleDensity density(pilot_of([](int) { return 0.0; }, [](int) { return 1u; }));
  EXPECT_EQ(density.at(0, 0), 1);
  EXPECT_EQ(density.samples(63, 63, 112), 112u);
}

TEST(Unit_SampleDensity, OneFireflyDoesNotTakeAll) {
  Film film = pilot_of([](int) { return 0.1; }, [](int) { return 1u; });
  FilmSample firefly;
  firefly.radiance = Rgb(1e6f);
  film.add(30, 30, firefly);
  const SampleDensity density(film);
  EXPECT_LE(density.at(30, 30), 11);
  EXPECT_GT(density.at(5, 5), 0.09f);
}

// Counts join from pass to pass: none, or a multiple of the replicates, and never fewer.
TEST(Unit_SampleDensity, CountsRiseWithTheMeanAndFillTheReplicates) {
  const SampleDensity density(
      pilot_of([](int x) { return 0.01 + 0.02 * x; }, [](int) { return 1u; }));
  for (int x = 0; x < size; ++x) {
    std::uint32_t last = 0;
    EXPECT_EQ(density.samples(x, 7, 0), 0u);
    for (std::uint32_t mean = 1; mean < 400; ++mean) {
      const std::uint32_t count = density.samples(x, 7, mean);
      ASSERT_GE(count, std::max(last, 4u));
      ASSERT_EQ(count % 4, 0u);
      last = count;
    }
  }
}

TEST(Unit_SampleDensity, HandsOutWhatThereIs) {
  const SampleDensity density(
      pilot_of([](int x) { return 0.01 + 0.02 * x; }, [](int) { return 1u; }));
  for (const std::uint32_t mean : {48u, 112u, 1000u}) {
    double sum = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) sum += density.samples(x, y, mean);
    EXPECT_NEAR(sum / (size * size), mean, 0.03 * mean) << mean;
  }
}

}  // namespace
}  // namespace candela
