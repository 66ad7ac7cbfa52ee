#include "integrators/tile_counts.h"

#include <gtest/gtest.h>

#include <limits>

namespace candela {
namespace {

// Samples of several pixels come in any order.
TEST(Unit_TileCounts, TheFirstInvalidSampleIsThePicturesFirst) {
  Film film(3, 2, {0, 0, 3, 2}, 0, 1);
  TileCounts counts;
  FilmSample sample;
  sample.radiance = Rgb(-1, 0, 0);
  const auto expect_first = [&](int x, int y, std::uint32_t index) {
    EXPECT_EQ(counts.first_invalid->x, x);
    EXPECT_EQ(counts.first_invalid->y, y);
    EXPECT_EQ(counts.first_invalid->sample, index);
  };
  add_or_count(sample, 2, 1, 0, 1, film, counts);
  expect_first(2, 1, 0);
  add_or_count(sample, 0, 1, 7, 1, film, counts);
  expect_first(0, 1, 7);
  add_or_count(sample, 2, 0, 5, 1, film, counts);
  add_or_count(sample, 2, 0, 4, 1, film, counts);
  add_or_count(sample, 2, 0, 6, 1, film, counts);
  expect_first(2, 0, 4);
  EXPECT_EQ(counts.invalid_samples, 5u);
}

// What lamps' own rays bring to a sample, of either sign under some filters.
TEST(Unit_TileCounts, WeightedLightMustBeFinite) {
  Film film(1, 1, {0, 0, 1, 1}, 0, 1);
  TileCounts counts;
  add_or_count({}, 0, 0, 0, 4, film, counts);
  add_weighted_or_count(Rgb(1, -2, 0), 0, 0, 0, film, counts);
  EXPECT_EQ(film.mean(0), Vec3d(1, -2, 0));
  EXPECT_EQ(counts.invalid_samples, 0u);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  add_weighted_or_count(Rgb(1, infinity, 0), 0, 0, 0, film, counts);
  EXPECT_EQ(film.mean(0), Vec3d(1, -2, 0));
  EXPECT_EQ(counts.invalid_samples, 1u);
  EXPECT_EQ(counts.first_invalid->sample, 0u);
}

}  // namespace
}  // namespace candela
