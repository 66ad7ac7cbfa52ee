#include "renderer/film/heavy_tails.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/film/synthetic_film.h"

namespace candela {
namespace {

std::ptrdiff_t masked(const Film& film) {
  const std::vector<bool> mask = heavy_tail_mask(film);
  return std::count(mask.begin(), mask.end(), true);
}

double ordinary(std::mt19937_64& random, int, int) {
  return std::uniform_real_distribution<double>(0, 2)(random);
}

TEST(Unit_HeavyTails, OrdinaryNoiseIsNotMasked) {
  for (const std::uint32_t replicates : {2u, 3u, 4u, 16u})
    EXPECT_EQ(masked(test::synthetic_film(32, 16, replicates, 1, ordinary)), 0) << replicates;
}

TEST(Unit_HeavyTails, ASampleThatOutshinesItsRegionMasksItAndNoOther) {
  for (const std::uint32_t replicates : {2u, 3u, 4u, 16u}) {
    Film film = test::synthetic_film(32, 16, replicates, 1, ordinary);
    FilmSample firefly;
    firefly.radiance = Rgb(10'000);
    film.add(9, 17, firefly);
    const std::vector<bool> mask = heavy_tail_mask(film);
    EXPECT_EQ(masked(film), 64) << replicates;
    EXPECT_TRUE(mask[film.index(8, 16)] && mask[film.index(15, 23)]) << replicates;
    EXPECT_FALSE(mask[film.index(7, 16)] || mask[film.index(16, 23)]) << replicates;
  }
}

// One sample in fifty brings everything: most pixels have met none or one.
TEST(Unit_HeavyTails, RareLightMasksThoughRegionsAsAWholeLookEven) {
  const auto rare = [](std::mt19937_64& random, int, int) {
    return std::uniform_real_distribution<double>()(random) < 0.02 ? 1.0 : 0.0;
  };
  const auto frequent = [](std::mt19937_64& random, int, int) {
    return std::uniform_real_distribution<double>()(random) < 0.5 ? 1.0 : 0.0;
  };
  EXPECT_GT(masked(test::synthetic_film(64, 64, 4, 1, rare)), 64 * 64 / 2);
  EXPECT_EQ(masked(test::synthetic_film(64, 64, 4, 1, frequent)), 0);
}

TEST(Unit_HeavyTails, WithoutReplicatesOrLightNothingIsMasked) {
  EXPECT_EQ(masked(test::synthetic_film(16, 4, 1, 1, ordinary)), 0);
  EXPECT_EQ(masked(test::synthetic_film(16, 4, 4, 1, [](auto&, int, int) { return 0.0; })), 0);
}

// As beside edges, by filters with negative parts: without noise nothing is rare.
TEST(Unit_HeavyTails, LessThanNoLightIsNotRareLight) {
  for (const int end : {2, 8}) {  // within a region, and between two
    const auto edge = [end](auto&, int x, int) { return x < end ? 1.0 : -0.01; };
    EXPECT_EQ(masked(test::synthetic_film(16, 4, 4, 1, edge)), 0) << end;
  }
}

TEST(Unit_HeavyTails, RegionsTooDimToMatterAreNotMasked) {
  const auto beside_a_lamp = [](double dim) {
    return [dim](std::mt19937_64& random, int x, int) {
      if (x < 8) return 1.0;
      return std::uniform_real_distribution<double>()(random) < 0.02 ? dim : 0.0;
    };
  };
  EXPECT_GT(masked(test::synthetic_film(16, 4, 4, 1, beside_a_lamp(1))), 0);
  EXPECT_EQ(masked(test::synthetic_film(16, 4, 4, 1, beside_a_lamp(1e-4))), 0);
}

// The layer shows what the estimate counts.
TEST(Unit_HeavyTails, TheLayerIsTheMask) {
  Film film(16, 8, {0, 0, 16, 8}, aov_bit(Aov::HeavyTail) | aov_bit(Aov::Variance), 2);
  for (int s = 0; s < 4; ++s)
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 16; ++x) {
        FilmSample sample;
        sample.radiance = Rgb(x < 8 && s == 0 ? 100 : 1);
        film.add(x, y, sample);
      }
  const Image image = film.to_image(false);
  EXPECT_EQ(image.pixel(0, 0)[image.channel_index("heavy_tail.V")], 1);
  EXPECT_EQ(image.pixel(8, 0)[image.channel_index("heavy_tail.V")], 0);
  EXPECT_EQ(image.pixel(8, 0)[image.channel_index("variance.R")], 0);
  // Replicates of means 50.5 and 1.
  EXPECT_FLOAT_EQ(image.pixel(0, 0)[image.channel_index("variance.R")], 24.75f * 24.75f);
}

}  // namespace
}  // namespace candela
