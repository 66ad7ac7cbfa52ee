#include "renderer/light/light_sampler.h"

#include <gtest/gtest.h>

#include "renderer/light/light_power.h"
#include "renderer/light/make_light.h"
#include "renderer/sampling/hash.h"
#include "tests/statistics/chi_square.h"

namespace candela {
namespace {

const std::array<Vec3f, 3> unit_triangle{Vec3f(0), {1, 0, 0}, {0, 1, 0}};

Light triangle_of(float radiance) {
  return make_triangle_light(unit_triangle, Rgb(radiance), false);
}

LightSampler sampler_of(const std::vector<Light>& lights) {
  std::vector<double> powers;
  for (const Light& light : lights) powers.push_back(light_power(light, nullptr, 2));
  return LightSampler(lights, powers);
}

double probability_sum(const LightSampler& sampler, std::size_t count) {
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) sum += static_cast<double>(sampler.probability(i));
  return sum;
}

TEST(Unit_LightPower, IsTheFlux) {
  EXPECT_NEAR(light_power(make_point_light(Vec3f(0), Rgb(2)), nullptr, 3), 8 * pi_double, 1e-5);
  EXPECT_NEAR(light_power(make_directional_light({1, 0, 0}, Rgb(2)), nullptr, 3), 18 * pi_double,
              1e-5);
  EXPECT_NEAR(light_power(triangle_of(2), nullptr, 3), pi_double, 1e-6);
  EXPECT_NEAR(light_power(make_triangle_light(unit_triangle, Rgb(2), true), nullptr, 3),
              2 * pi_double, 1e-6);
  Environment environment;
  environment.mean_luminance = 0.5;
  EXPECT_NEAR(light_power(make_environment_light(), &environment, 3),
              0.5 * 4 * pi_double * pi_double * 9, 1e-5);
}

TEST(Unit_LightSampler, IsEmptyWithoutLights) {
  const LightSampler sampler = sampler_of({});
  EXPECT_TRUE(sampler.always().empty());
  EXPECT_FALSE(sampler.has_table());
  EXPECT_FALSE(LightSampler().has_table());
}

TEST(Unit_LightSampler, AlwaysSamplesFewDeltaLightsAndPicksAmongTheRest) {
  const std::vector<Light> lights{make_point_light(Vec3f(0), Rgb(1)), triangle_of(1),
                                  make_directional_light({0, 1, 0}, Rgb(1)), triangle_of(3)};
  const LightSampler sampler = sampler_of(lights);
  EXPECT_EQ(sampler.always(), (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(sampler.probability(0), 0.0f);
  EXPECT_NEAR(sampler.probability(1), 0.25, 1e-7);
  EXPECT_NEAR(sampler.probability(3), 0.75, 1e-7);
}

TEST(Unit_LightSampler, PicksAllByPowerWhereDeltaLightsAreMany) {
  std::vector<Light> lights(LightSampler::delta_limit, make_point_light(Vec3f(0), Rgb(1)));
  lights.push_back(triangle_of(1));
  EXPECT_EQ(sampler_of(lights).always().size(), LightSampler::delta_limit);
  lights.push_back(make_point_light(Vec3f(1), Rgb(2)));
  const LightSampler many = sampler_of(lights);
  EXPECT_TRUE(many.always().empty());
  EXPECT_NEAR(many.probability(5) / many.probability(0), 2, 1e-6);
  EXPECT_NEAR(probability_sum(many, lights.size()), 1, 1e-7);
}

// Black delta lights do not count towards the limit either.
TEST(Unit_LightSampler, DropsBlackLights) {
  std::vector<Light> lights(10, make_point_light(Vec3f(0), Rgb(0)));
  lights.push_back(triangle_of(0));
  EXPECT_FALSE(sampler_of(lights).has_table());
  EXPECT_TRUE(sampler_of(lights).always().empty());
  lights.push_back(make_point_light(Vec3f(0), Rgb(1)));
  lights.push_back(triangle_of(1));
  const LightSampler sampler = sampler_of(lights);
  EXPECT_EQ(sampler.always(), (std::vector<std::uint32_t>{11}));
  EXPECT_EQ(sampler.probability(12), 1.0f);
  EXPECT_EQ(sampler.probability(10), 0.0f);
}

TEST(Unit_LightSampler, LeavesDimLightsATenthOfAnEqualShare) {
  const LightSampler sampler =
      sampler_of({triangle_of(1e12f), triangle_of(1e-12f), triangle_of(0), triangle_of(1e12f)});
  EXPECT_NEAR(sampler.probability(1), 0.1 / 3, 0.004);
  EXPECT_EQ(sampler.probability(2), 0.0f);
  EXPECT_NEAR(probability_sum(sampler, 4), 1, 1e-7);
}

TEST(Unit_LightSampler, HoldsPowersSixtyDecadesApart) {
  const std::vector<Light> lights{triangle_of(1e-30f), triangle_of(1), triangle_of(1e30f)};
  const LightSampler sampler = sampler_of(lights);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_GT(sampler.probability(i), 0.0f);
    EXPECT_TRUE(std::isfinite(1 / sampler.probability(i)));
  }
  EXPECT_NEAR(probability_sum(sampler, 3), 1, 1e-7);
}

TEST(Statistical_LightSampler, FrequenciesFitTheProbabilities) {
  std::vector<Light> lights;
  for (int i = 0; i < 300; ++i) lights.push_back(triangle_of(static_cast<float>(i % 17)));
  const LightSampler sampler = sampler_of(lights);
  constexpr std::uint64_t count = 1'000'000;
  std::vector<double> observed(lights.size(), 0), expected;
  for (std::uint64_t i = 0; i < count; ++i) {
    const LightPick pick = sampler.pick(static_cast<std::uint32_t>(mix_bits(i) >> 32));
    ASSERT_EQ(pick.probability, sampler.probability(pick.light));
    observed[pick.light] += 1;
  }
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    expected.push_back(static_cast<double>(sampler.probability(i)) * count);
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, 0.01);
}

// Evenly spaced numbers see each light's share, and what is left of them is even again.
void expect_even_shares(const std::vector<Light>& lights) {
  const LightSampler sampler = sampler_of(lights);
  ASSERT_TRUE(sampler.tells_rest());
  constexpr std::uint32_t count = 1u << 16, parts = 4;
  std::vector<std::array<int, parts>> seen(lights.size());
  float last = 0;
  std::uint32_t last_light = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const LightPick pick = sampler.pick(i << 16);
    ASSERT_EQ(pick.probability, sampler.probability(pick.light));
    ASSERT_TRUE(pick.rest >= 0 && pick.rest < 1);
    ASSERT_TRUE(pick.light > last_light || (pick.light == last_light && pick.rest >= last))
        << "neighbours side by side";
    ++seen[pick.light][static_cast<std::size_t>(pick.rest * parts)];
    last = pick.rest;
    last_light = pick.light;
  }
  for (std::uint32_t light = 0; light < lights.size(); ++light)
    for (const int part : seen[light])
      EXPECT_NEAR(part, count * static_cast<double>(sampler.probability(light)) / parts, 1.5)
          << light;
}

TEST(Unit_LightSampler, WhatIsLeftOfAFewLightsNumberIsUniform) {
  expect_even_shares({triangle_of(1), triangle_of(0), triangle_of(3), triangle_of(0.5)});
}

// Dim ones side by side are as many as one look into the guide may find.
TEST(Unit_LightSampler, FindsEachOfManyUnequalLights) {
  std::vector<Light> lights;
  for (int i = 0; i < 60; ++i) lights.push_back(triangle_of(i / 5 % 2 == 0 ? 1.0f : 0.01f));
  lights.push_back(triangle_of(4));
  expect_even_shares(lights);
}

// A number that chooses among thousands has not enough left; nor has that of a light that is rarely
// picked.
TEST(Unit_LightSampler, OnlyFewLightsShareANumber) {
  EXPECT_TRUE(sampler_of({triangle_of(1)}).tells_rest());
  EXPECT_EQ(sampler_of({triangle_of(1)}).pick(0x80000000u).rest, 0.5f);
  EXPECT_TRUE(sampler_of(std::vector<Light>(1000, triangle_of(1))).tells_rest());
  EXPECT_FALSE(sampler_of(std::vector<Light>(1100, triangle_of(1))).tells_rest());
  std::vector<Light> one_dim(200, triangle_of(1));
  one_dim.push_back(triangle_of(1e-3f));
  EXPECT_FALSE(sampler_of(one_dim).tells_rest());
}

}  // namespace
}  // namespace candela
