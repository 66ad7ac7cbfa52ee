// The time that a picture may take.
#include "integrators/time_budget.h"

#include <gtest/gtest.h>

#include "integrators/guiding/choose_guide.h"
#include "integrators/render_rounds.h"
#include "integrators/reuse/choose_reuse.h"
#include "integrators/roulette/choose_roulette.h"
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
  EXPECT_NEAR(TimeBudget(1000, earlier).samples_in_time(5, 0.5), 25, 3);
  EXPECT_EQ(TimeBudget({}, earlier).samples_in_time(5), std::numeric_limits<double>::infinity());
}

// Of 1000 seconds 60 are gone before the first sample: five in 40 are 117 in 940.
TEST(Unit_TimeBudget, TheRateIsThatOfSamplesAlone) {
  const Clock::time_point earlier = Clock::now() - std::chrono::seconds(100);
  TimeBudget budget(1000, earlier);
  budget.begin_samples(earlier + std::chrono::seconds(60));
  EXPECT_NEAR(budget.samples_in_time(5), 117.5, 10);
  EXPECT_EQ(budget.samples_in_time(5, 0.05), 0);
}

TEST(Unit_TimeBudget, NothingIsTriedThatThereIsNoTimeFor) {
  RenderOptions options;
  options.chooses_roulette = options.chooses_reuse = true;
  options.guiding = Guiding::On;
  options.plan.roulette_threshold = 0.25f;
  const TileFunction never = [](const TilePass&, Film&) -> TileCounts {
    ADD_FAILURE() << "something is rendered";
    return {};
  };
  const auto is_over = [] { return true; };
  const RouletteChoice roulette = choose_roulette(options, never, is_over);
  EXPECT_EQ(roulette.plan.roulette_threshold, 0.25f);
  EXPECT_EQ(roulette.samples, 0u);
  EXPECT_FALSE(choose_reuse(options, options.plan, never, is_over).reuses_paths);
  EXPECT_EQ(choose_guide(options, never, is_over).field, nullptr);
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
