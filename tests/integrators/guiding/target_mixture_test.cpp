// Mixtures of distributions about targets: their samples follow their density, and they turn with
// the place that they are seen from.
#include <gtest/gtest.h>

#include "integrators/guiding/target_mixture.h"
#include "tests/statistics/direction_sampling.h"
#include "tests/statistics/distributions.h"

namespace candela {
namespace {

struct Target {
  Vec3f place;
  float spread;
  float weight;
};

TargetMixture mixture_of(const std::vector<Target>& targets) {
  TargetMixture mixture;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Target& target = targets[i];
    mixture.x.set(i, target.place.x);
    mixture.y.set(i, target.place.y);
    mixture.z.set(i, target.place.z);
    mixture.inverse_spread2.set(i, 2 / (target.spread * target.spread));
    mixture.weight.set(i, target.weight);
  }
  mixture.share = 0.5f;
  return mixture;
}

// Narrow and wide, near and far, one within its own spread, and lanes that are not used.
const std::vector<Target> some_targets{{{0, 0, 2}, 0.4f, 0.3f},
                                       {{1, 0.5f, -0.5f}, 0.3f, 0.25f},
                                       {{-300, 500, 100}, 200, 0.2f},
                                       {{0.1f, -0.1f, 0}, 1, 0.15f},
                                       {{-1, -1, -1}, 0.6f, 0.1f}};

TEST(Statistical_TargetMixture, SamplesFollowTheDensity) {
  const TargetMixture mixture = mixture_of(some_targets);
  for (const Vec3f from : {Vec3f(0.0f), Vec3f(0.3f, -0.2f, 0.5f)}) {
    const TargetsSeen seen(mixture, from);
    const auto sample = [&](float choice, Vec2f u) {
      return std::optional(seen.sample(choice, u).wi);
    };
    const auto density = [&](const Vec3f& wi) { return static_cast<double>(seen.pdf(wi)); };
    const auto result =
        statistics::test_directions(sample, density, {.rings = 16, .sectors = 24}, 5, 400'000);
    EXPECT_NEAR(result.integral, 1, 1e-4);
    EXPECT_GT(result.chi_square.p_value, statistics::sidak_level(0.01, 2))
        << result.chi_square.statistic;
  }
}

TEST(Unit_TargetMixture, SamplesSayTheirDensity) {
  const TargetMixture mixture = mixture_of(some_targets);
  const TargetsSeen seen(mixture, Vec3f(0.2f));
  for (int i = 0; i < 64; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / 64;
    const GuidedDirection guided = seen.sample(u, {1 - u, 0.37f});
    EXPECT_NEAR(length(guided.wi), 1, 1e-5);
    EXPECT_EQ(guided.pdf, seen.pdf(guided.wi));
  }
}

// Half of a narrow distribution lies within its spread.
TEST(Unit_TargetMixture, ATargetIsAsWideAsItSays) {
  const TargetMixture mixture = mixture_of({{{0, 0, 10}, 0.5f, 1}});
  const TargetsSeen seen(mixture, Vec3f(0.0f));
  const Vec3f middle = seen.sample(0, {0.5f, 0.1f}).wi;
  EXPECT_NEAR(std::acos(middle.z), 0.05, 0.001);
}

TEST(Unit_TargetMixture, TurnsWithThePlaceItIsSeenFrom) {
  const TargetMixture mixture = mixture_of({{{0, 0, 1}, 0.1f, 1}});
  for (const Vec3f from : {Vec3f(0.0f), Vec3f(1, 0, 1), Vec3f(0.2f, -0.4f, 3)}) {
    const TargetsSeen seen(mixture, from);
    const Vec3f towards = normalize(Vec3f(0, 0, 1) - from);
    EXPECT_GT(seen.pdf(towards), 5 * seen.pdf(normalize(towards + Vec3f(0, 0.5f, 0))));
  }
}

// Even at the target itself.
TEST(Unit_TargetMixture, IsFiniteEverywhere) {
  const TargetMixture mixture = mixture_of({{{0, 0, 1}, 1e-4f, 1}});
  for (const Vec3f from : {Vec3f(0, 0, 1), Vec3f(0, 0, 1.00001f), Vec3f(1e6f)}) {
    const TargetsSeen seen(mixture, from);
    for (const Vec2f u : {Vec2f(0.0f), Vec2f(0.5f), Vec2f(0x1.fffffep-1f)}) {
      const GuidedDirection guided = seen.sample(0x1.fffffep-1f, u);
      EXPECT_TRUE(std::isfinite(guided.pdf) && guided.pdf > 0);
      EXPECT_NEAR(length(guided.wi), 1, 1e-4);
    }
  }
}

}  // namespace
}  // namespace candela
