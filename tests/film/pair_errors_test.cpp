#include "renderer/film/pair_errors.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

// A picture under a white balance may have channels on both sides of black: what is near by lies on
// the one, the pixel, which is known well, on the other, and is held against its own size.
TEST(Unit_PairErrors, APixelKeepsItsSideOfBlack) {
  constexpr double epsilon = 1e-8;
  NeighbourLevel level;
  level.structure = Vec3d(1.0);
  level.own_variance = Vec3d(1e-9);
  level.company = 1;
  for (const double side : {1.0, -1.0}) {
    level.mean = Vec3d(-0.002 * side);
    LevelLanes near{};
    near.set(0, level);
    SampleSumLanes whole{}, a{}, b{};
    whole.set(0, {Vec3d(0.12 * side), 4});
    a.set(0, {Vec3d(0.032 * side), 1});
    b.set(0, {Vec3d(0.028 * side), 1});
    Lanes<double> errors{};
    add_errors_of_pair(near, whole, a, b, epsilon, errors);
    const double variance = 0.004 * 0.004 / (2 * 4);
    EXPECT_NEAR(errors[0] / (variance / (0.03 * 0.03 + epsilon)), 1, 1e-3);
  }
}

}  // namespace
}  // namespace candela
