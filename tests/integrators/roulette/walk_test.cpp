// What another roulette would have made of a walk, held against playing it.
#include "integrators/roulette/walk.h"

#include <gtest/gtest.h>

#include <random>

#include "integrators/path/media_step.h"
#include "integrators/path/path_step.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

// Without roulette.
Walk walk_of_four_steps() {
  return {{{0.8f, 1, Rgb(1, 0, 0.5f)},
           {0.5f, 1, Rgb(1.5f, 0, 0.5f)},
           {0.45f, 1, Rgb(1.5f, 0.2f, 0.5f)},
           {0.2f, 1, Rgb(2, 0.2f, 0.5f)}},
          Rgb(2.5f, 0.3f, 0.5f)};
}

// The walk goes on as long as it survives; survivors stand for the ended.
Walk played(const Walk& walk, Roulette roulette, std::mt19937& random) {
  Walk found;
  Rgb brought(0);
  float weight = 1;
  for (std::uint32_t i = 0;; ++i) {
    const bool is_last = i == walk.steps.size();
    const Rgb until = is_last ? walk.radiance : walk.steps[i].radiance;
    found.radiance += weight * (until - brought);
    brought = until;
    if (is_last) return found;
    PathState path;
    path.throughput = Rgb(walk.steps[i].throughput * weight);
    const float before = path.throughput.x;
    const float u = std::generate_canonical<float, 24>(random);
    if (!survives_roulette(u, i, roulette, path)) return found;
    found.steps.push_back({before, path.survival, found.radiance});
    weight /= path.survival;
  }
}

double squared_error(const Walk& found, const Walk& truth) {
  const double off = static_cast<double>(found.radiance.x - truth.radiance.x);
  return off * off;
}

// Walks by one roulette tell what another one has and takes, which is seen by playing that.
TEST(Statistical_RouletteOutcome, IsWhatTheOtherRouletteHas) {
  const Walk walk = walk_of_four_steps();
  std::mt19937 random(3);
  for (const Roulette own : {Roulette{0.1f, 9}, Roulette{2, 1}, Roulette{4, 0}})
    for (const Roulette other : {Roulette{1, 0}, Roulette{1, 2}, Roulette{2, 1}, Roulette{4, 0}}) {
      statistics::Moments told, seen, bounces_told, bounces_seen;
      for (int i = 0; i < 100'000; ++i) {
        const Walk by_own = played(walk, own, random);
        const Walk by_other = played(walk, other, random);
        const RouletteOutcome outcome = expected_under(by_own, other);
        told.add(squared_error(by_own, walk) + outcome.variance.x);
        seen.add(squared_error(by_other, walk));
        bounces_told.add(outcome.bounces);
        bounces_seen.add(static_cast<double>(by_other.steps.size()));
      }
      EXPECT_GT(statistics::welch_p_value(told, seen), 1e-4) << told.mean() << " " << seen.mean();
      EXPECT_GT(statistics::welch_p_value(bounces_told, bounces_seen), 1e-4)
          << bounces_told.mean() << " " << bounces_seen.mean();
    }
}

TEST(Unit_RouletteOutcome, NoneWherePathsAreSpared) {
  const RouletteOutcome spared = expected_under(walk_of_four_steps(), {1, 4});
  EXPECT_EQ(spared.variance, Vec3d(0));
  EXPECT_EQ(spared.bounces, 4);
  const RouletteOutcome empty = expected_under({{}, Rgb(1)}, {1, 0});
  EXPECT_EQ(empty.variance, Vec3d(0));
  EXPECT_EQ(empty.bounces, 0);
}

// The same roulette takes nothing, within media too, where paths survive more often.
TEST(Unit_RouletteOutcome, IsNoneOfTheWalksOwnRoulette) {
  Walk walk;
  for (int i = 0; i < 500; ++i) walk.steps.push_back({1, highest_survival_in_media, Rgb(0)});
  walk.radiance = Rgb(1);
  const RouletteOutcome same = expected_under(walk, {1, 0});
  EXPECT_EQ(same.variance, Vec3d(0));
  EXPECT_EQ(same.bounces, 500);
}

TEST(Unit_RouletteOutcome, IsOfTheRadianceThatTheFilmHas) {
  Walk walk = walk_of_four_steps();
  const RouletteOutcome plain = expected_under(walk, {1, 0});
  walk.multiply_radiance(Mat3d(2, 0, 0, 0, 1, 0, 0, 0, 0));
  const RouletteOutcome balanced = expected_under(walk, {1, 0});
  EXPECT_FLOAT_EQ(balanced.variance.x, 4 * plain.variance.x);
  EXPECT_FLOAT_EQ(balanced.variance.y, plain.variance.y);
  EXPECT_EQ(balanced.variance.z, 0);
}

}  // namespace
}  // namespace candela
