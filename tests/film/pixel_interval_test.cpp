#include "renderer/film/pixel_interval.h"

#include <gtest/gtest.h>

#include "renderer/film/student_t.h"
#include "tests/film/synthetic_film.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

void add(Film& film, int x, int y, std::initializer_list<float> greys) {
  for (const float grey : greys) {
    FilmSample sample;
    sample.radiance = Rgb(grey);
    film.add(x, y, sample);
  }
}

// Two replicates of one sample each: the variances of a sample are 8 and 2, with one degree each.
TEST(Unit_PixelInterval, PoolsThePixelsBesideIt) {
  Film film(4, 1, {0, 0, 4, 1}, 0, 2);
  add(film, 0, 0, {1, 5});
  add(film, 1, 0, {4, 6});
  add(film, 2, 0, {3, 3});
  add(film, 3, 0, {7, 7});
  const std::vector<Vec3d> intervals = pixel_intervals(film);
  EXPECT_DOUBLE_EQ(intervals[0].x, student_t_95(2) * std::sqrt((8.0 + 2.0) / 2 / 2));
  EXPECT_DOUBLE_EQ(intervals[1].y, student_t_95(3) * std::sqrt((8.0 + 2.0 + 0.0) / 3 / 2));
  EXPECT_DOUBLE_EQ(intervals[2].z, student_t_95(3) * std::sqrt((2.0 + 0.0 + 0.0) / 3 / 2));
  EXPECT_EQ(intervals[3].x, 0);
}

TEST(Unit_PixelInterval, WeighsByDegreesOfFreedom) {
  Film film(2, 1, {0, 0, 2, 1}, 0, 3);
  add(film, 0, 0, {1, 2, 6});  // variance 7, two degrees
  add(film, 1, 0, {1, 3});     // 2, one
  EXPECT_DOUBLE_EQ(pixel_intervals(film)[0].x, student_t_95(3) * std::sqrt(16.0 / 3 / 3));
}

// What counts is a sample's variance, of which a mean over more samples has less.
TEST(Unit_PixelInterval, NarrowsWithThePixelsOwnSamples) {
  Film film(1, 2, {0, 0, 1, 2}, 0, 2);
  add(film, 0, 0, {1, 5});
  add(film, 0, 1, {1, 5, 1, 5, 1, 5, 1, 5});
  // One sample's variance is 8 by the first pixel; the second's means of four, 1 and 5, say 32.
  const std::vector<Vec3d> intervals = pixel_intervals(film);
  EXPECT_DOUBLE_EQ(intervals[0].x, student_t_95(2) * std::sqrt(20.0 / 2));
  EXPECT_DOUBLE_EQ(intervals[1].x, student_t_95(2) * std::sqrt(20.0 / 8));
}

TEST(Unit_PixelInterval, OfOneReplicateIsNotKnown) {
  Film film(2, 1, {0, 0, 2, 1}, 0, 4);
  add(film, 0, 0, {3});
  add(film, 1, 0, {1, 2, 3, 4});
  EXPECT_EQ(pixel_intervals(film)[0], Vec3d(0.0));
  EXPECT_GT(pixel_intervals(film)[1].x, 0);
  EXPECT_EQ(pixel_intervals(Film(2, 1, {0, 0, 2, 1}, 0, 4)), std::vector<Vec3d>(2, Vec3d(0.0)));
}

double share_held(const Film& film, double truth) {
  const std::vector<Vec3d> intervals = pixel_intervals(film);
  double held = 0;
  for (std::size_t i = 0; i < intervals.size(); ++i)
    held += std::abs(film.mean(i).x - truth) <= intervals[i].x ? 1 : 0;
  return held / static_cast<double>(intervals.size());
}

double normal(std::mt19937_64& random, int, int) {
  return std::normal_distribution<double>(5, 1)(random);
}

// Pixels share their neighbours, so shares are compared over seeds.
TEST(Statistical_PixelInterval, HoldsTheTruthOfNormalPixelsIn95Percent) {
  statistics::Moments shares;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    shares.add(share_held(test::synthetic_film(32, 8, 4, seed, normal), 5));
  EXPECT_GT(shares.p_value(0.95), 1e-3) << shares.mean();
}

// One sample in twenty brings all the light: by its own four replicates a pixel's interval would
// hold the truth for 83 %.
TEST(Statistical_PixelInterval, HoldsItWhereLightIsRare) {
  const auto rare = [](std::mt19937_64& random, int, int) {
    return std::uniform_real_distribution<double>()(random) < 0.05 ? 20.0 : 0.0;
  };
  const double held = share_held(test::synthetic_film(128, 64, 4, 3, rare), 1);
  EXPECT_GT(held, 0.93);
  EXPECT_LT(held, 0.97);
}

TEST(Unit_PixelInterval, IsALayer) {
  Film film(2, 1, {0, 0, 2, 1}, aov_bit(Aov::Interval), 2);
  add(film, 0, 0, {1, 5});
  add(film, 1, 0, {4, 6});
  const Image image = film.to_image(false);
  EXPECT_FLOAT_EQ(image.pixel(1, 0)[image.channel_index("interval.G")],
                  static_cast<float>(pixel_intervals(film)[1].y));
}

}  // namespace
}  // namespace candela
