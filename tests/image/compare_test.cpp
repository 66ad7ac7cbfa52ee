#include "renderer/image/compare.h"

#include <limits>

#include <gtest/gtest.h>

namespace candela {
namespace {

Image filled(int width, int height, float r, float g, float b) {
  Image image(width, height, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.pixel_count(); ++i) {
    image.values[3 * i] = r;
    image.values[3 * i + 1] = g;
    image.values[3 * i + 2] = b;
  }
  return image;
}

TEST(Unit_CompareImages, EqualImagesHaveNoError) {
  const Image image = filled(4, 2, 0.25f, 0.5f, 2);
  const auto result = compare_images(image, image);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->rel_mse, 0);
  EXPECT_EQ(result->psnr, std::numeric_limits<double>::infinity());
  EXPECT_EQ(result->mean_ratio, (std::array<double, 3>{1, 1, 1}));
}

TEST(Unit_CompareImages, FollowsTheDefinition) {
  const Image reference = filled(2, 1, 1, 2, 3);
  Image image = reference;
  image.values = {1, 2, 3, 1.5f, 2, 3};
  const auto result = compare_images(image, reference);
  ASSERT_TRUE(result);
  const double epsilon = 1e-2 * 2 * 2;
  EXPECT_NEAR(result->rel_mse, 0.25 / (1 + epsilon) / 6, 1e-12);
  EXPECT_NEAR(result->r_mse, std::sqrt(result->rel_mse), 1e-15);
  EXPECT_NEAR(result->mean_ratio[0], 1.25, 1e-12);
  EXPECT_NEAR(result->psnr, 10 * std::log10(9 / (0.25 / 6)), 1e-9);
  EXPECT_EQ(result->worst_x, 1);
  EXPECT_EQ(result->worst_y, 0);
  EXPECT_NEAR(result->worst_error, 0.25 / (1 + epsilon) / 3, 1e-12);
}

TEST(Unit_CompareImages, DoesNotDependOnTheScale) {
  const Image reference = filled(3, 3, 1, 2, 3);
  Image image = filled(3, 3, 1.125f, 1.75f, 3);
  const double before = compare_images(image, reference)->rel_mse;
  Image scaled = reference;
  for (float& v : scaled.values) v *= 1024;
  for (float& v : image.values) v *= 1024;
  EXPECT_NEAR(compare_images(image, scaled)->rel_mse, before, 1e-15);
}

TEST(Unit_CompareImages, TrimmingLeavesOutOnePixelInAThousand) {
  const Image reference = filled(100, 20, 1, 1, 1);
  Image image = filled(100, 20, 1.5f, 1, 1);
  image.pixel(7, 3)[0] = 1000;
  image.pixel(8, 3)[0] = 1000;
  const auto result = compare_images(image, reference);
  EXPECT_GT(result->rel_mse, 100);
  EXPECT_NEAR(result->rel_mse_trimmed, 0.25 / 1.01 / 3, 1e-12);
  EXPECT_EQ(result->worst_y, 3);
}

TEST(Unit_CompareImages, InvalidValuesAreCountedNotDropped) {
  const Image reference = filled(2, 2, 1, 1, 1);
  Image image = reference;
  image.values[4] = std::numeric_limits<float>::quiet_NaN();
  const auto result = compare_images(image, reference);
  EXPECT_EQ(result->invalid_values, 1u);
  EXPECT_TRUE(std::isnan(result->rel_mse));
}

TEST(Errors_CompareImages, SaysWhatDoesNotFit) {
  const auto size = compare_images(filled(2, 2, 1, 1, 1), filled(2, 3, 1, 1, 1));
  ASSERT_FALSE(size);
  EXPECT_EQ(size.diagnostics.list()[0].message,
            "the image has 2 x 2 pixels and the reference 2 x 3: they must be of one size");
  const auto channels = compare_images(Image(1, 1, {"X", "Y"}), filled(1, 1, 1, 1, 1));
  ASSERT_FALSE(channels);
  EXPECT_EQ(channels.diagnostics.list()[0].message, "the image has no channels R, G and B");
}

TEST(Unit_CompareImages, HeatRisesWithTheError) {
  const Image reference = filled(4, 1, 1, 1, 1);
  Image image = reference;
  image.values[3] = 1.01f;
  image.values[6] = 1.2f;
  image.values[9] = 40;
  const auto map = error_heatmap(image, reference);
  ASSERT_TRUE(map);
  double last = -1;
  for (int x = 0; x < 4; ++x) {
    const float* colour = map->pixel(x, 0);
    const double sum = colour[0] + colour[1] + colour[2];
    EXPECT_GT(sum, last);
    last = sum;
  }
  EXPECT_EQ(map->pixel(0, 0)[0], 0);
  EXPECT_EQ(map->pixel(3, 0)[2], 1);
}

}  // namespace
}  // namespace candela
