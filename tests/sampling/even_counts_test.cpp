#include "renderer/sampling/even_counts.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace candela {
namespace {

TEST(Unit_EvenCounts, ArePowersOfTwoAndHalfAsManyAgain) {
  const double counts[] = {1, 1.5, 2, 3, 4, 6, 8, 12, 16};
  for (int level = 0; level < 9; ++level) EXPECT_EQ(even_count(level), counts[level]);
  EXPECT_EQ(even_count(60), 0x1p30);
}

TEST(Unit_EvenCounts, TheNearestIsSoByRatio) {
  const auto distance = [](double count, int level) {
    return std::abs(std::log(even_count(level) / count));
  };
  for (double count = 1; count < 1e9; count *= 1.0371) {
    const int level = nearest_level(count);
    EXPECT_LE(distance(count, level), distance(count, level + 1)) << count;
    EXPECT_LE(distance(count, level), distance(count, std::max(level - 1, 0))) << count;
  }
}

TEST(Unit_EvenCounts, LevelsBeginWhereTheyAreTheNearest) {
  for (int level = 1; level < 60; ++level) {
    EXPECT_EQ(nearest_level(lower_end_of_level(level) * (1 + 1e-12)), level);
    EXPECT_EQ(nearest_level(lower_end_of_level(level) * (1 - 1e-12)), level - 1);
    EXPECT_EQ(nearest_level(even_count(level)), level);
  }
}

}  // namespace
}  // namespace candela
