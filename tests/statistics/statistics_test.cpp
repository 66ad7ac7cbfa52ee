// The statistical tests themselves: the null hypothesis is rejected as often as the level says, and
// small faults are found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "renderer/base/floating_point_traps.h"
#include "tests/statistics/chi_square.h"
#include "tests/statistics/distributions.h"
#include "tests/statistics/image_test.h"
#include "tests/statistics/moments.h"

namespace candela::statistics {
namespace {

TEST(Unit_Moments, MatchesAHandCalculation) {
  Moments moments;
  for (const double x : {1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16}) moments.add(x);
  EXPECT_EQ(moments.mean(), 1e9 + 10);
  EXPECT_EQ(moments.variance(), 30);
  EXPECT_NEAR(moments.interval(0.95).high - moments.mean(), 3.182446305 * std::sqrt(7.5), 1e-6);
}

TEST(Unit_ChiSquare, ComputesPearsonsStatistic) {
  const std::vector<double> observed = {16, 18, 16, 14, 12, 12};
  const std::vector<double> expected = {16, 16, 16, 16, 16, 8};
  const ChiSquareResult result = chi_square_test(observed, expected);
  EXPECT_NEAR(result.statistic, 3.5, 1e-12);
  EXPECT_EQ(result.degrees_of_freedom, 5);
  EXPECT_NEAR(result.p_value, 0.62338763, 1e-7);
}

TEST(Unit_ChiSquare, MergesSmallCellsAndRefusesImpossibleOnes) {
  const FloatingPointTraps traps(Traps::Off);  // what is fed is not always a number
  const std::vector<double> observed = {1, 0, 2, 50, 47, 0};
  const std::vector<double> expected = {1, 1, 1, 48, 49, 0};
  EXPECT_EQ(chi_square_test(observed, expected).degrees_of_freedom, 1);
  EXPECT_GT(chi_square_test(observed, expected).p_value, 0.1);
  const std::vector<double> impossible = {1, 0, 2, 50, 46, 1};
  EXPECT_EQ(chi_square_test(impossible, expected).p_value, 0);
  const std::vector<double> invalid = {1, 1, 1, 48, std::nan(""), 1};
  EXPECT_EQ(chi_square_test(observed, invalid).p_value, 0);
}

// Under the null hypothesis p-values are uniform.
TEST(Statistical_ChiSquare, PValuesAreUniform) {
  std::mt19937 random(1);
  std::vector<double> p_values;
  for (int run = 0; run < 2000; ++run) {
    std::vector<double> observed(20), expected(20);
    for (std::size_t i = 0; i < 20; ++i) expected[i] = 1000.0 * static_cast<double>(i + 1) / 210.0;
    std::discrete_distribution<int> cell(expected.begin(), expected.end());
    for (int i = 0; i < 1000; ++i) ++observed[static_cast<std::size_t>(cell(random))];
    p_values.push_back(chi_square_test(observed, expected).p_value);
  }
  std::sort(p_values.begin(), p_values.end());
  double distance = 0;
  for (std::size_t i = 0; i < p_values.size(); ++i)
    distance = std::max(distance, std::abs(p_values[i] - (static_cast<double>(i) + 0.5) / 2000));
  EXPECT_GT(kolmogorov_survival(distance, 2000), 0.01);
}

struct NoisyPair {
  Image mean;
  Image variance;
};

// Each pixel: the mean of `samples` exponential numbers, as skewed as light often is.
NoisyPair noisy_image(unsigned seed, double scale, int samples, int width = 64) {
  std::mt19937 random(seed);
  std::exponential_distribution<double> light(1.0);
  NoisyPair image{Image(width, width, {"R", "G", "B"}), Image(width, width, {"R", "G", "B"})};
  for (std::size_t i = 0; i < image.mean.values.size(); ++i) {
    const double truth = scale * (1 + static_cast<double>(i % 7));
    Moments moments;
    for (int s = 0; s < samples; ++s) moments.add(truth * light(random));
    image.mean.values[i] = static_cast<float>(moments.mean());
    image.variance.values[i] = static_cast<float>(moments.variance_of_mean());
  }
  return image;
}

ImageTestResult compare(const NoisyPair& a, const NoisyPair& b, double degrees) {
  return compare_images({&a.mean, &a.variance}, {&b.mean, &b.variance},
                        {.degrees_of_freedom = degrees});
}

TEST(Statistical_ImageTest, AcceptsEqualExpectations) {
  const NoisyPair reference = noisy_image(1, 1, 512, 32);
  int rejected = 0;
  for (unsigned seed = 2; seed < 22; ++seed)
    if (!compare(noisy_image(seed, 1, 512, 32), reference, 511).passed) ++rejected;
  EXPECT_LE(rejected, 2);  // binomial(20, 0.01): more than 2 has probability 0.001
}

TEST(Statistical_ImageTest, FindsTwoPerCentByBlockOrWhole) {
  const NoisyPair reference = noisy_image(1, 1, 512);
  const ImageTestResult result = compare(noisy_image(2, 0.98, 512), reference, 511);
  EXPECT_FALSE(result.passed);
  EXPECT_LT(result.whole_p_value, 1e-6) << result.message;
  EXPECT_NEAR(result.whole_ratio, 0.98, 0.002);
}

TEST(Statistical_ImageTest, FindsOneWrongPixelAndOneWrongBlock) {
  const NoisyPair reference = noisy_image(1, 1, 512);
  NoisyPair image = noisy_image(2, 1, 512);
  image.mean.pixel(13, 40)[1] *= 1.6f;
  const ImageTestResult pixel = compare(image, reference, 511);
  EXPECT_FALSE(pixel.passed);
  EXPECT_EQ(pixel.worst_x, 13);
  EXPECT_EQ(pixel.worst_y, 40);
  EXPECT_EQ(pixel.worst_channel, 1);

  image = noisy_image(2, 1, 512);
  for (int y = 8; y < 16; ++y)
    for (int x = 24; x < 32; ++x) image.mean.pixel(x, y)[0] *= 1.1f;
  const ImageTestResult block = compare(image, reference, 511);
  EXPECT_FALSE(block.passed);
  EXPECT_LT(block.block_p_value, 1e-4);
  EXPECT_GT(block.pixel_p_value, 1e-3);
}

TEST(Unit_ImageTest, HandlesExactAndBrokenImages) {
  const FloatingPointTraps traps(Traps::Off);  // what is fed is not always a number
  const NoisyPair a = noisy_image(1, 1, 4, 16);
  EXPECT_TRUE(compare_images({&a.mean, nullptr}, {&a.mean, nullptr}).passed);
  Image changed = a.mean;
  changed.pixel(3, 3)[0] *= 1.001f;
  EXPECT_FALSE(compare_images({&changed, nullptr}, {&a.mean, nullptr}).passed);
  changed.pixel(3, 3)[0] = std::nanf("");
  EXPECT_FALSE(compare_images({&changed, &a.variance}, {&a.mean, &a.variance}).passed);
  const NoisyPair smaller = noisy_image(1, 1, 4, 8);
  EXPECT_FALSE(compare_images({&a.mean, nullptr}, {&smaller.mean, nullptr}).passed);
}

}  // namespace
}  // namespace candela::statistics
