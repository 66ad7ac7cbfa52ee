#include "renderer/film/student_t.h"

#include <gtest/gtest.h>

#include "tests/statistics/distributions.h"

namespace candela {
namespace {

// Against the inverse of the distribution, which is computed in another way.
TEST(Unit_StudentT, IsTheDistributionsQuantile) {
  for (const double degrees : {1.0, 1.2, 1.5, 1.9})
    EXPECT_NEAR(student_t_95(degrees) / statistics::t_quantile(0.975, degrees), 1, 3e-2) << degrees;
  for (const double degrees : {2.0, 2.5})
    EXPECT_NEAR(student_t_95(degrees) / statistics::t_quantile(0.975, degrees), 1, 2e-3) << degrees;
  for (double degrees = 3; degrees < 1e6; degrees *= 1.37)
    EXPECT_NEAR(student_t_95(degrees) / statistics::t_quantile(0.975, degrees), 1, 2e-5) << degrees;
}

TEST(Unit_StudentT, BelowOneDegreeIsOne) {
  EXPECT_EQ(student_t_95(0.2), student_t_95(1));
}

}  // namespace
}  // namespace candela
