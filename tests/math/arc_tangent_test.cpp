#include <gtest/gtest.h>

#include "renderer/math/transcendental.h"

namespace candela {
namespace {

// Points on rays of all slopes, including near the seams of the reduction (tan(pi/8), 1).
TEST(Unit_ArcTangent, IsWithinItsBoundOfTheLibrarys) {
  double worst = 0;
  for (int i = 0; i < 400'000; ++i) {
    const double angle = (i - 200'000) * (3.14159265358979 / 200'000);
    const auto y = static_cast<float>(std::sin(angle) * (1 + i % 7));
    const auto x = static_cast<float>(std::cos(angle) * (1 + i % 7));
    const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
    const double error = std::abs(static_cast<double>(arc_tangent(y, x)) - exact);
    if (exact != 0) worst = std::max(worst, error / std::abs(exact));
  }
  EXPECT_LT(worst, 4e-7);
}

TEST(Unit_ArcTangent, KnowsTheAxesAndTheExtremes) {
  const float half_pi = 1.57079632679489661923f;
  EXPECT_EQ(arc_tangent(0.0f, 1.0f), 0.0f);
  EXPECT_EQ(arc_tangent(0.0f, -1.0f), 2 * half_pi);
  EXPECT_EQ(arc_tangent(-0.0f, -1.0f), -2 * half_pi);
  EXPECT_EQ(arc_tangent(1.0f, 0.0f), half_pi);
  EXPECT_EQ(arc_tangent(-1.0f, 0.0f), -half_pi);
  EXPECT_EQ(arc_tangent(0.0f, 0.0f), 0.0f);
  EXPECT_EQ(arc_tangent(3e38f, 3e38f), half_pi / 2);
  EXPECT_EQ(arc_tangent(1e-38f, 1e-38f), half_pi / 2);
  EXPECT_EQ(arc_tangent(1e-30f, 1e30f), 0.0f);
}

}  // namespace
}  // namespace candela
