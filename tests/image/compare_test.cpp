// The measures of error against their formulas, worked out here in a plain way.
#include "renderer/image/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {
namespace {

Image filled(int width, int height, float value) {
  Image image(width, height, {"R", "G", "B"});
  std::fill(image.values.begin(), image.values.end(), value);
  return image;
}

// Neither smooth nor symmetric.
Image pattern(int width, int height, int shift) {
  Image image(width, height, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] =
        static_cast<float>((i * 2654435761u + static_cast<unsigned>(shift) * 97u) % 1000) / 500.0f;
  return image;
}

struct Expected {
  double relmse = 0, trimmed = 0, mse = 0;
};

Expected expected_of(const Image& x, const Image& r) {
  double mean = 0;
  for (const float v : r.values)
    mean += static_cast<double>(v) / static_cast<double>(r.values.size());
  const double epsilon = 0.01 * mean * mean;
  std::vector<double> errors;
  Expected expected;
  for (std::size_t i = 0; i < r.values.size(); i += 3) {
    double error = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double a = static_cast<double>(x.values[i + c]),
                   b = static_cast<double>(r.values[i + c]);
      error += (a - b) * (a - b) / (b * b + epsilon) / 3;
      expected.mse += (a - b) * (a - b) / static_cast<double>(r.values.size());
    }
    errors.push_back(error);
  }
  std::sort(errors.begin(), errors.end());
  const std::size_t kept = errors.size() - errors.size() / 1000;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    expected.relmse += errors[i] / static_cast<double>(errors.size());
    if (i < kept) expected.trimmed += errors[i] / static_cast<double>(kept);
  }
  return expected;
}

TEST(Unit_Compare, MeasuresFollowTheirDefinition) {
  const Image r = pattern(70, 50, 0);
  const Image x = pattern(70, 50, 3);
  const Result<ImageComparison> found = compare_images(x, r);
  ASSERT_TRUE(found);
  const Expected expected = expected_of(x, r);
  EXPECT_NEAR(found->relmse, expected.relmse, 1e-12 * expected.relmse);
  EXPECT_NEAR(found->relmse_trimmed, expected.trimmed, 1e-12 * expected.trimmed);
  EXPECT_LT(found->relmse_trimmed, found->relmse);
  EXPECT_NEAR(found->rmse, std::sqrt(expected.relmse), 1e-12);
  EXPECT_NEAR(found->mse, expected.mse, 1e-12);
  const double largest = static_cast<double>(*std::max_element(r.values.begin(), r.values.end()));
  EXPECT_NEAR(found->psnr, 20 * std::log10(largest) - 10 * std::log10(expected.mse), 1e-9);
}

TEST(Unit_Compare, ScalingBothChangesNoRelativeError) {
  const Image r = pattern(40, 30, 0);
  const Image x = pattern(40, 30, 1);
  Image big_r = r, big_x = x;
  for (float& v : big_r.values) v *= 1024;
  for (float& v : big_x.values) v *= 1024;
  EXPECT_EQ(compare_images(big_x, big_r)->relmse, compare_images(x, r)->relmse);
}

TEST(Unit_Compare, AOnePercentErrorIsOnePercent) {
  const Image r = filled(10, 10, 2);
  const Image x = filled(10, 10, 2.02f);
  const Result<ImageComparison> found = compare_images(x, r);
  EXPECT_NEAR(found->rmse, 0.01 / std::sqrt(1.01), 1e-8);
  for (const double ratio : found->mean_ratio) EXPECT_NEAR(ratio, 1.01, 1e-7);
}

TEST(Unit_Compare, EqualImagesHaveNoError) {
  for (const float value : {0.0f, 0.7f}) {
    const Result<ImageComparison> found = compare_images(filled(8, 4, value), filled(8, 4, value));
    EXPECT_EQ(found->relmse, 0);
    EXPECT_EQ(found->mse, 0);
    EXPECT_EQ(found->psnr, std::numeric_limits<double>::infinity());
    EXPECT_EQ(found->mean_ratio[1], 1);
  }
}

TEST(Unit_Compare, FindsTheWorstPixelAndTrimsIt) {
  Image x = filled(50, 40, 1);  // 2000 pixels: two are left out
  const Image r = filled(50, 40, 1);
  x.pixel(7, 5)[1] = 1001;
  x.pixel(9, 30)[0] = 3;
  const Result<ImageComparison> found = compare_images(x, r);
  EXPECT_EQ(found->worst_x, 7);
  EXPECT_EQ(found->worst_y, 5);
  EXPECT_NEAR(found->worst_error, 1e6 / 1.01 / 3, 1e-3);
  EXPECT_EQ(found->worst_image[1], 1001);
  EXPECT_EQ(found->worst_reference[1], 1);
  EXPECT_GT(found->relmse, 100);
  EXPECT_EQ(found->relmse_trimmed, 0);
}

TEST(Unit_Compare, AGreyImageIsThreeEqualChannels) {
  Image grey(2, 1, {"Y"});
  grey.values = {0.5f, 0.25f};
  Image colour(2, 1, {"R", "G", "B", "A"});
  colour.values = {0.5f, 0.5f, 0.5f, 0.1f, 0.25f, 0.25f, 0.25f, 1};
  EXPECT_EQ(compare_images(grey, colour)->relmse, 0);
  EXPECT_EQ(compare_images(colour, grey)->relmse, 0);
}

TEST(Unit_Compare, BlackReferencesDivideByNothing) {
  const Result<ImageComparison> found = compare_images(filled(4, 4, 1), filled(4, 4, 0));
  EXPECT_EQ(found->relmse, std::numeric_limits<double>::infinity());
  EXPECT_EQ(found->mean_ratio[0], std::numeric_limits<double>::infinity());
}

TEST(Errors_Compare, WhatIsNotFiniteIsCountedAndInfinitelyWrong) {
  Image x = filled(50, 40, 1);
  Image r = filled(50, 40, 1);
  x.pixel(3, 4)[0] = std::numeric_limits<float>::quiet_NaN();
  x.pixel(3, 4)[2] = std::numeric_limits<float>::infinity();
  r.pixel(5, 6)[1] = -std::numeric_limits<float>::infinity();
  const Result<ImageComparison> found = compare_images(x, r);
  EXPECT_EQ(found->invalid_in_image, 2u);
  EXPECT_EQ(found->invalid_in_reference, 1u);
  EXPECT_EQ(found->invalid_values, 3u);
  EXPECT_EQ(found->relmse, std::numeric_limits<double>::infinity());
  EXPECT_EQ(found->psnr, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(found->relmse_trimmed, 0);
  EXPECT_EQ(found->worst_x, 3);
  EXPECT_EQ(found->mean_ratio, (std::array<double, 3>{1, 1, 1}));  // of what both have
}

TEST(Errors_Compare, DifferentSizesAndMissingChannelsAreSentences) {
  const Result<ImageComparison> sizes = compare_images(filled(4, 3, 1), filled(3, 4, 1));
  ASSERT_FALSE(sizes);
  EXPECT_EQ(sizes.diagnostics.list()[0].message,
            "the image has 4 x 3 pixels and the reference 3 x 4: they must be of one size");
  EXPECT_FALSE(compare_images(Image(2, 2, {"normal.X", "normal.Y"}), filled(2, 2, 1)));
  EXPECT_FALSE(compare_images(Image{}, Image{}));
  EXPECT_FALSE(error_heatmap(filled(4, 3, 1), filled(3, 4, 1)));
}

double oklab_lightness(const std::array<float, 3>& c) {  // [Ottosson20], the other way round
  const double r = static_cast<double>(c[0]), g = static_cast<double>(c[1]),
               b = static_cast<double>(c[2]);
  return 0.2104542553 * std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) +
         0.7936177850 * std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) -
         0.0040720468 * std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
}

TEST(Unit_Heatmap, LightnessRisesEvenly) {
  for (int i = 0; i <= 100; ++i)
    EXPECT_NEAR(oklab_lightness(heat_colour(i / 100.0)), i / 100.0, 2e-3) << i;
  EXPECT_EQ(heat_colour(-5), heat_colour(0));
  EXPECT_EQ(heat_colour(7), heat_colour(1));
}

TEST(Unit_Heatmap, ShowsErrorsOnTheLogarithmicScaleAndInvalidPixelsRed) {
  const Image r = filled(3, 1, 1);
  Image x = r;
  for (std::size_t c = 0; c < 3; ++c) x.pixel(1, 0)[c] = 1 + 0.1f * std::sqrt(1.01f);
  x.pixel(2, 0)[0] = std::numeric_limits<float>::quiet_NaN();
  const Result<Image> map = error_heatmap(x, r);
  ASSERT_TRUE(map);
  const auto at = [&](int i) {
    return std::array<float, 3>{map->pixel(i, 0)[0], map->pixel(i, 0)[1], map->pixel(i, 0)[2]};
  };
  EXPECT_EQ(at(0), heat_colour(0));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(at(1)[c], heat_colour(0.5)[c], 1e-4);
  EXPECT_EQ(at(2), (std::array<float, 3>{1, 0, 0}));
}

}  // namespace
}  // namespace candela
