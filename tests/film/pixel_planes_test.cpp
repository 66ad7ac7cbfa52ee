#include "renderer/film/pixel_planes.h"

#include <gtest/gtest.h>

#include <random>

namespace candela {
namespace {

constexpr int width = 21, height = 17;

std::size_t at(int x, int y) {
  return static_cast<std::size_t>(y * width + x);
}

Plane random_plane() {
  std::mt19937_64 random(3);
  Plane plane(static_cast<std::size_t>(width * height));
  for (double& number : plane) number = std::uniform_real_distribution<double>(-1, 1)(random);
  return plane;
}

double sum_within(int radius, int x, int y, const Plane& plane) {
  double sum = 0;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx) sum += plane[at(x + dx, y + dy)];
  return sum;
}

TEST(Unit_PixelPlanes, TheMeanOfNineIsThatOfThreeTimesThree) {
  const Plane plane = random_plane();
  const Plane means = mean_of_nine(plane, width);
  for (int y = 1; y < height - 1; ++y)
    for (int x = 1; x < width - 1; ++x)
      EXPECT_NEAR(means[at(x, y)], sum_within(1, x, y, plane) / 9, 1e-15) << x << "," << y;
}

TEST(Unit_PixelPlanes, TheSumNearByLeavesOutTheMiddle) {
  Plane plane = random_plane();
  const auto others_near = [&](int x, int y) {
    Plane others = plane;
    others[at(x, y)] = 0;
    return sum_within(4, x, y, others);
  };
  const Plane sums = sum_near_by(plane, width);
  for (int y = 4; y < height - 4; ++y)
    for (int x = 4; x < width - 4; ++x)
      EXPECT_NEAR(sums[at(x, y)], others_near(x, y), 1e-13) << x << "," << y;
  plane[at(10, 8)] = 1e30;  // next to which nothing else would be left
  EXPECT_NEAR(sum_near_by(plane, width)[at(10, 8)], others_near(10, 8), 1e-13);
}

TEST(Unit_PixelPlanes, NoiseInPhaseAddsUpByItsDeviations) {
  const Planes variances{Plane{1, 0, 4}, Plane{4, 0, 4}, Plane{9, 9, 4}};
  EXPECT_EQ(variance_in_phase(variances), (Plane{4, 1, 4}));
}

TEST(Unit_PixelPlanes, SmallOnesHaveNoSums) {
  EXPECT_EQ(mean_of_nine(Plane{1, 2}, 1), (Plane{0, 0}));
  EXPECT_EQ(sum_near_by(Plane{1, 2}, 1), (Plane{0, 0}));
}

}  // namespace
}  // namespace candela
