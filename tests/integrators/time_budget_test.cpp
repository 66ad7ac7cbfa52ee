// The time that a picture may take.
#include "integrators/time_budget.h"

#include <gtest/gtest.h>

#include "integrators/render_rounds.h"
#include "tests/integrators/synthetic_tile.h"

namespace candela {
namespace {

using Clock = TimeBudget::Clock;

TEST(Unit_TimeBudget, IsSpentFromItsStartOn) {
  const Clock::time_point earlier = Clock::now() - std::chrono::seconds(100);
  EXPECT_TRUE(TimeBudget(99, earlier).is_spent());
  EXPECT_FALSE(TimeBudget(5000, earlier).is_spent());
  EXPECT_TRUE(TimeBudget(900, earlier).is_spent(0.1));
  EXPECT_FALSE(TimeBudget({}, earlier).is_spent());
  EXPECT_NEAR(TimeBudget(1000, earlier).samples_in_time(5), 50, 5);
  EXPECT_EQ(TimeBudget({}, earlier).samples_in_time(5), std::numeric_limits<double>::infinity());
}

// Whatever came before the first sample counts.
TEST(Unit_TimeBudget, RoundsHaveWhatIsLeftOfIt) {
  RenderOptions options;
  options.width = options.height = 8;
  options.samples_per_pixel = 64;
  options.time_limit_seconds = 1000;
  const auto render = [&](Clock::time_point start) {
    Film film(8, 8, {0, 0, 8, 8}, 0, 4);
    const TileFunction grey = [](const TilePass& pass, Film& target) {
      return test::synthetic_tile(pass, target, [](std::uint64_t, int, int) { return 0.5; });
    };
    return render_rounds(options, grey, film, nullptr, nullptr, true, start).stop;
  };
  EXPECT_EQ(render(Clock::now()), StopReason::Samples);
  EXPECT_EQ(render(Clock::now() - std::chrono::seconds(2000)), StopReason::Time);
}

}  // namespace
}  // namespace candela
