#include "integrators/roulette/walk_log.h"

#include <gtest/gtest.h>

#include <limits>

namespace candela {
namespace {

// A path that is lost where a ray can not be traced would make all sums over walks unknown.
TEST(Unit_WalkLog, LostPathsAreNoWalks) {
  const Ray ray{};
  WalkLog log;
  for (const float radiance : {1.0f, std::numeric_limits<float>::quiet_NaN(), 2.0f}) {
    log.leave(0, {.ray = ray});
    log.radiance_so_far(0, Rgb(0.5f));
    log.end(0, Rgb(radiance));
  }
  ASSERT_EQ(log.walks().size(), 2u);
  EXPECT_EQ(log.walks()[0].radiance, Rgb(1));
  EXPECT_EQ(log.walks()[1].radiance, Rgb(2));
  EXPECT_EQ(log.walks()[1].steps.size(), 1u);
}

}  // namespace
}  // namespace candela
