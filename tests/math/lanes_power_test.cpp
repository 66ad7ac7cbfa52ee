// Four lanes at once against the library's scalar functions in double.
#include "renderer/math/lanes_power.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/base/floating_point_traps.h"

namespace candela {
namespace {

Float4 all(float x) {
  return Float4{x, x, x, x};
}

TEST(Unit_LanesPower, PowerStaysWithinItsStatedError) {
  double largest = 0;
  const auto last = std::bit_cast<std::uint32_t>(0x1p56f);
  for (auto bits = std::bit_cast<std::uint32_t>(0x1p-56f); bits < last; bits += 997) {
    const auto x = std::bit_cast<float>(bits);
    const double expected = std::pow(static_cast<double>(x), 2.2);
    const double found = static_cast<double>(power_2_2(all(x))[0]);
    largest = std::max(largest, std::abs(found - expected) / expected);
  }
  EXPECT_LT(largest, 1e-6);
  EXPECT_GT(largest, 1e-8);  // or nothing was measured
}

TEST(Unit_LanesPower, PowerIsExactAtItsEndsAndTakesAnyFloat) {
  const FloatingPointTraps traps(Traps::Off);  // what is fed is not always a number
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const Float4 ends = power_2_2(Float4{0, 1, -1, std::numeric_limits<float>::quiet_NaN()});
  EXPECT_EQ(ends[0], 0);
  EXPECT_EQ(ends[1], 1);
  EXPECT_EQ(ends[2], 0);
  EXPECT_EQ(ends[3], 0);
  const Float4 far = power_2_2(Float4{1e-30f, infinity, 0x1p56f, -infinity});
  EXPECT_EQ(far[0], 0);
  EXPECT_EQ(far[1], far[2]);
  EXPECT_TRUE(std::isfinite(far[1]));
  EXPECT_EQ(far[3], 0);
  const Float4 small = power_2_2(Float4{-0.0f, -1e-38f, -0.01f, 1e-45f});
  for (int i = 0; i < 4; ++i) EXPECT_EQ(small[i], 0) << i;
}

TEST(Unit_LanesPower, PowerNeverFallsBetweenTheStepsOfEightBits) {
  float earlier = 0;
  for (int i = 0; i <= 4 * 255; ++i) {
    const float value = power_2_2(all(static_cast<float>(i) / (4 * 255.0f)))[2];
    ASSERT_GE(value, earlier) << i;
    ASSERT_LE(value, 1) << i;
    earlier = value;
  }
}

TEST(Unit_LanesPower, LanesDoNotMix) {
  const Float4 mixed = power_2_2(Float4{0.1f, 0.5f, 2.0f, 7.0f});
  for (int i = 0; i < 4; ++i) {
    const float x = Float4{0.1f, 0.5f, 2.0f, 7.0f}[i];
    EXPECT_EQ(mixed[i], power_2_2(all(x))[0]);
  }
}

TEST(Unit_LanesPower, OneFloatHasTheBitsOfALane) {
  const FloatingPointTraps traps(Traps::Off);  // not all are numbers
  for (std::uint32_t bits = 0; bits < 0xffff'0000; bits += 9973) {
    const auto x = std::bit_cast<float>(bits);
    ASSERT_EQ(power_2_2(x), power_2_2(all(x))[1]) << x;
  }
}

}  // namespace
}  // namespace candela
