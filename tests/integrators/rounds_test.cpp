#include "integrators/rounds.h"

#include <gtest/gtest.h>

#include <vector>

namespace candela {
namespace {

// Where rounds end when the error falls as 1 / samples from 1 at one sample.
std::vector<std::uint32_t> ends(double wanted, std::uint32_t replicates, std::uint32_t most) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t done = 0; done < most;) {
    const std::optional<ErrorGoal> goal =
        done > 0 ? std::optional(ErrorGoal{1.0 / done, wanted}) : std::nullopt;
    if (goal && goal->relmse <= wanted) break;
    done = round_end(done, replicates, most, goal);
    all.push_back(done);
  }
  return all;
}

TEST(Unit_Rounds, GrowByLessThanAThirdNearAGoal) {
  const auto all = ends(1.0 / 1000, 4, 1u << 30);
  EXPECT_EQ(all.front(), 16u);
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double growth = 4 * all[i - 1] < 1000 ? 2 : 1.3;
    EXPECT_LE(all[i], std::max(all[i - 1] * growth, all[i - 1] + 4.0));
    EXPECT_GT(all[i], all[i - 1]);
    EXPECT_EQ(all[i] % 4, 0u);
  }
  EXPECT_EQ(all.back(), 1008u);  // the first whole block that suffices
}

TEST(Unit_Rounds, DoubleTowardsAGoalThatIsFarAway) {
  EXPECT_EQ(round_end(64, 4, 1u << 30, ErrorGoal{4.1e-3, 1e-3}), 128u);
  EXPECT_EQ(round_end(64, 4, 1u << 30, ErrorGoal{3.9e-3, 1e-3}), 80u);
}

TEST(Unit_Rounds, DoubleWithoutAGoalUpToTheLimit) {
  EXPECT_EQ(round_end(0, 4, 100, {}), 16u);
  EXPECT_EQ(round_end(16, 4, 100, {}), 32u);
  EXPECT_EQ(round_end(64, 4, 100, {}), 100u);
  EXPECT_EQ(round_end(0, 4, 3, {}), 3u);
  EXPECT_EQ(round_end(0, 1, 1, {}), 1u);
}

TEST(Unit_Rounds, WithoutAGoalAreWholeBlocksFromTheFirstOn) {
  for (const std::uint32_t replicates : {1u, 2u, 3u, 4u, 5u, 16u, 32u})
    for (std::uint32_t done = 0, rounds = 0; rounds < 5; ++rounds) {
      done = round_end(done, replicates, 1u << 30, {});
      EXPECT_EQ(done % 16, 0u) << replicates;
      EXPECT_EQ(done % replicates, 0u);
      EXPECT_GE(done, 4 * replicates);
    }
}

TEST(Unit_Rounds, GoOnWhereTheErrorIsNotKnown) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(round_end(16, 4, 1u << 30, ErrorGoal{infinite, 1e-3}), 20u);
  EXPECT_EQ(round_end(1u << 29, 4, 1u << 30, ErrorGoal{infinite, 1e-30}), 697932176u);
}

TEST(Unit_Rounds, TowardsAGoalAreWholeBlocksOnceTheyMayBe) {
  const auto all = ends(1.0 / 60, 4, 1u << 30);
  EXPECT_EQ(all, (std::vector<std::uint32_t>{16, 20, 24, 28, 32, 40, 48, 60}));
  std::uint32_t last = 64;
  for (const std::uint32_t replicates : {1u, 2u, 3u, 4u, 16u})
    for (std::uint32_t done = 64 * replicates; done < 100000; done = last) {
      last = round_end(done, replicates, 1u << 30, ErrorGoal{1.0 / done, 0.3 / done});
      EXPECT_EQ(last % 16, 0u);
      EXPECT_EQ(last % replicates, 0u);
      EXPECT_LE(last, largest_growth * done);
    }
}

std::vector<std::uint32_t> pass_ends(bool is_long) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t done = 0; done < 50; done = all.back()) {
    const SampleRange pass = next_pass(done, 50, is_long);
    EXPECT_EQ(pass.first, done);
    all.push_back(pass.end);
  }
  return all;
}

TEST(Unit_Rounds, PassesEndAtMultiplesOfSixteen) {
  EXPECT_EQ(pass_ends(false), (std::vector<std::uint32_t>{16, 32, 48, 50}));
}

TEST(Unit_Rounds, LongRendersBeginWithOneSample) {
  EXPECT_EQ(pass_ends(true), (std::vector<std::uint32_t>{1, 16, 32, 48, 50}));
}

}  // namespace
}  // namespace candela
