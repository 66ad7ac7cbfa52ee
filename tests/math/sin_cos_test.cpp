#include <gtest/gtest.h>

#include <cmath>

#include "renderer/math/transcendental.h"

namespace candela {
namespace {

double error_of(const SinCos& found, double angle) {
  return std::max(std::abs(static_cast<double>(found.sin) - std::sin(angle)),
                  std::abs(static_cast<double>(found.cos) - std::cos(angle)));
}

TEST(Unit_SinCos, IsWithinItsBoundOfTheLibrarys) {
  double octant = 0;
  double turn = 0;
  double wide = 0;
  for (int i = -1'000'000; i <= 1'000'000; ++i) {
    const float x = static_cast<float>(i) * 1e-6f;
    const float in_octant = x * 0.78539816f;
    octant = std::max(octant, error_of(sin_cos_of_octant(in_octant), double{in_octant}));
    const float turns = std::abs(x);
    turn = std::max(turn, error_of(sin_cos_of_turns(turns), 2 * M_PI * double{turns}));
    wide = std::max(wide, error_of(sin_cos(x * 1e4f), double{x * 1e4f}));
  }
  EXPECT_LT(octant, 6.5e-8);
  EXPECT_LT(turn, 1.2e-7);
  EXPECT_LT(wide, 1.2e-7);
}

TEST(Unit_SinCos, KnowsTheAxes) {
  EXPECT_EQ(sin_cos_of_turns(0).cos, 1);
  EXPECT_EQ(sin_cos_of_turns(0.25f).sin, 1);
  EXPECT_EQ(sin_cos_of_turns(0.25f).cos, 0);
  EXPECT_EQ(sin_cos_of_turns(0.5f).cos, -1);
  EXPECT_EQ(sin_cos_of_turns(0.75f).sin, -1);
  EXPECT_EQ(sin_cos_of_turns(1).cos, 1);
  EXPECT_EQ(sin_cos(0).sin, 0);
}

TEST(Unit_SinCos, SwapsOnlyWhereAsked) {
  float a = 1.5f;
  float b = -0.0f;
  swap_if(false, a, b);
  EXPECT_EQ(a, 1.5f);
  swap_if(true, a, b);
  EXPECT_EQ(b, 1.5f);
  EXPECT_TRUE(std::signbit(a));
}

}  // namespace
}  // namespace candela
