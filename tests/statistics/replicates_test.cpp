#include "tests/statistics/replicates.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/statistics/distributions.h"

namespace candela::statistics {
namespace {

constexpr int side = 16;
constexpr int replicate_count = 16;
constexpr int runs = 200;

// Pixels of mean 1 and up, whose noise is exp(sigma z) less its mean: skewed like radiance.
Replicates noisy(std::mt19937& random, double sigma, double gain) {
  std::lognormal_distribution<double> noise(-0.5 * sigma * sigma, sigma);
  Replicates replicates{"noise", side, side, {}};
  for (int i = 0; i < replicate_count; ++i) {
    std::vector<double> image;
    for (int p = 0; p < side * side; ++p) image.push_back((1 + p) * gain * noise(random));
    replicates.images.push_back(image);
  }
  return replicates;
}

int failures(double sigma_of_a, double sigma_of_b, double gain) {
  std::mt19937 random(7);
  int count = 0;
  for (int run = 0; run < runs; ++run) {
    const Replicates a = noisy(random, sigma_of_a, 1);
    const Replicates b = noisy(random, sigma_of_b, gain);
    count += compare_replicates(a, b, {.level = 0.05}).passed ? 0 : 1;
  }
  return count;
}

// Equal expectations fail as often as the level says, or less: 200 runs of 5 % give at most 22 with
// a chance of .9995. Also where one renderer is noisier than the other, and skewed.
TEST(Statistical_Replicates, EqualExpectationsPass) {
  EXPECT_LE(failures(0.1, 0.1, 1), 22);
  EXPECT_LE(failures(0.1, 0.3, 1), 22);
  EXPECT_LE(failures(0.6, 0.6, 1), 22);
}

// Of 4096 numbers a renderer with a spread of 10 %, a gain of 1.5 % is 7 standard errors.
TEST(Statistical_Replicates, AGainIsSeen) {
  EXPECT_EQ(failures(0.1, 0.1, 1.015), runs);
}

// A difference that blocks and the whole do not see: every other pixel brighter, the rest darker.
TEST(Statistical_Replicates, PixelsSeeWhatAveragesOut) {
  std::mt19937 random(9);
  const Replicates a = noisy(random, 0.1, 1);
  Replicates b = noisy(random, 0.1, 1);
  for (auto& image : b.images)
    for (std::size_t i = 0; i < image.size(); ++i) image[i] *= i % 2 == 0 ? 1.06 : 0.94;
  const Agreement agreement = compare_replicates(a, b);
  EXPECT_LT(agreement.pixels_p_value, 1e-6);
  EXPECT_GT(agreement.whole_p_value, 0.01);
  EXPECT_FALSE(agreement.passed);
}

}  // namespace
}  // namespace candela::statistics
