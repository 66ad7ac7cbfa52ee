// Traps are on in the tests of builds that have them, and scopes turn them on and off.
#include "renderer/base/floating_point_traps.h"

#include <gtest/gtest.h>

#include <optional>

#include "renderer/base/parallel.h"

namespace candela {
namespace {

class TrapsInTests : public testing::Environment {
 public:
  void SetUp() override { traps_.emplace(Traps::On); }
  void TearDown() override { traps_.reset(); }

 private:
  std::optional<FloatingPointTraps> traps_;
};
[[maybe_unused]] const testing::Environment* const traps_in_tests =
    testing::AddGlobalTestEnvironment(new TrapsInTests);

double quotient(double a, double b) {
  const volatile double divisor = b;
  const volatile double result = a / divisor;  // not left out, whether somebody asks or not
  return result;
}

TEST(Unit_FloatingPointTraps, OffLetsInvalidOperationsPass) {
  const FloatingPointTraps off(Traps::Off);
  EXPECT_TRUE(std::isinf(quotient(1, 0)));
  EXPECT_TRUE(std::isnan(quotient(0, 0)));
}

#if defined(CANDELA_FLOATING_POINT_TRAPS)
TEST(Unit_FloatingPointTraps, OnEndsTheProgram) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH((void)quotient(1, 0), "");
  EXPECT_DEATH((void)quotient(0, 0), "");
  EXPECT_DEATH(
      {
        const FloatingPointTraps off(Traps::Off);
        { const FloatingPointTraps on(Traps::On); }
        with_threads(2, [] { parallel_for(64, [](std::size_t) { (void)quotient(1, 0); }); });
      },
      "");
}
#endif

}  // namespace
}  // namespace candela
