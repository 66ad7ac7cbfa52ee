// Lights by what they may send to a cell: what is picked, how often, and that nothing is left out.
#include "renderer/light/light_cells.h"

#include <gtest/gtest.h>

#include <random>

#include "renderer/light/light_power.h"
#include "renderer/light/light_sampler.h"
#include "renderer/light/make_light.h"
#include "renderer/sampling/hash.h"
#include "tests/statistics/chi_square.h"

namespace candela {
namespace {

constexpr std::uint32_t behind_first_hit = 1;

Bounds3f unit_box() {
  Bounds3f box;
  box.include(Vec3f(-1));
  box.include(Vec3f(1));
  return box;
}

Vec3f random_point(std::mt19937_64& random) {
  std::uniform_real_distribution<float> along(-1, 1);
  const float x = along(random), y = along(random);
  return {x, y, along(random)};
}

// Small triangles in all directions, every seventh of them lit on both sides, and some points.
std::vector<Light> scattered_lights(int count) {
  std::mt19937_64 random(7);
  std::vector<Light> lights;
  for (int i = 0; i < count; ++i) {
    const Vec3f at = random_point(random);
    if (i % 11 == 3)
      lights.push_back(make_point_light(at, Rgb(0.001f)));
    else
      lights.push_back(make_triangle_light(
          {at, at + 0.05f * random_point(random), at + 0.05f * random_point(random)},
          Rgb(static_cast<float>(i % 5)), i % 7 == 0));
  }
  return lights;
}

LightSampler sampler_of(const std::vector<Light>& lights) {
  std::vector<double> powers;
  for (const Light& light : lights) powers.push_back(light_power(light, nullptr, 2));
  LightSampler sampler(lights, powers);
  sampler.make_cells(lights, unit_box());
  return sampler;
}

Vec2f random_place(std::uint64_t i) {
  const std::uint64_t bits = hash_counter(3, i);
  return {unit_float(static_cast<std::uint32_t>(bits)),
          unit_float(static_cast<std::uint32_t>(bits >> 32))};
}

// At some points of the box: probabilities sum to one, and numbers pick as often as they say.
void expect_exact_picks(const std::vector<Light>& lights) {
  const LightSampler sampler = sampler_of(lights);
  std::mt19937_64 random(8);
  for (int place = 0; place < 5; ++place) {
    const std::uint32_t cell = sampler.cell_of(random_point(random), 0);
    ASSERT_NE(cell, LightCells::everywhere);
    constexpr std::uint64_t count = 400'000;
    std::vector<double> observed(lights.size(), 0), expected;
    for (std::uint64_t i = 0; i < count; ++i) {
      const LightPick pick =
          sampler.pick(static_cast<std::uint32_t>(mix_bits(i) >> 32), cell, random_place(i));
      ASSERT_EQ(pick.probability, sampler.probability(pick.light, cell));
      observed[pick.light] += 1;
    }
    double sum = 0;
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
      expected.push_back(static_cast<double>(sampler.probability(i, cell)) * count);
      sum += static_cast<double>(sampler.probability(i, cell));
    }
    EXPECT_NEAR(sum, 1, 1e-5);
    EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, 0.002) << place;
  }
}

TEST(Statistical_LightCells, PickFewLightsAsOftenAsTheySay) {
  expect_exact_picks(scattered_lights(60));
}

// More than a list holds: the others by power.
TEST(Statistical_LightCells, PickManyLightsAsOftenAsTheySay) {
  expect_exact_picks(scattered_lights(3000));
}

// Of so many others that what is left of one number could not tell them apart, each of such numbers
// picks all by power, since the place on the light has a say.
TEST(Statistical_LightCells, PickOthersByPowerWhateverTheNumber) {
  const std::vector<Light> lights = scattered_lights(1 << 15);
  const LightSampler sampler = sampler_of(lights);
  const std::uint32_t cell = sampler.cell_of(Vec3f(0.1f), 0);
  ASSERT_TRUE(sampler.cells().has_others());
  std::uint32_t number = 0;  // among the others', which are the list's last
  while (sampler.cells().pick(number, cell).light != Light::none) number += 1 << 12;
  constexpr double count = 1 << 19;
  std::vector<double> observed(lights.size() >> 7, 0), expected(lights.size() >> 7, 0);
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i)
    observed[sampler.pick(number, cell, random_place(i)).light >> 7] += 1;
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    expected[i >> 7] += count * static_cast<double>(sampler.probability(i));
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, 0.002);
}

// A flat box with many lights has no more cells than a cube.
TEST(Unit_LightCells, AreNotMoreInFlatBoxes) {
  const std::vector<Light> lights = scattered_lights(3000);
  std::vector<double> powers(lights.size(), 1.0);
  const auto cells_of = [&](const Vec3f& half) {
    Bounds3f box;
    box.include(-half);
    box.include(half);
    LightSampler sampler(lights, powers);
    sampler.make_cells(lights, box);
    return sampler.cells().count();
  };
  const std::size_t of_cube = cells_of(Vec3f(1));
  EXPECT_GT(of_cube, 100u);
  for (const Vec3f& flat : {Vec3f(1, 1, 1e-3f), Vec3f(1, 1e-6f, 1), Vec3f(1e-3f, 1e-3f, 1)}) {
    EXPECT_LE(cells_of(flat), 1.3 * static_cast<double>(of_cube));
    EXPECT_GE(cells_of(flat), 60u);
  }
}

// Never is a light left out that shines on a point of the cell.
TEST(Unit_LightCells, PickAllThatMayMatter) {
  for (const int count : {60, 3000}) {
    const std::vector<Light> lights = scattered_lights(count);
    const LightSampler sampler = sampler_of(lights);
    std::mt19937_64 random(9);
    for (int place = 0; place < 500; ++place) {
      const Vec3f point = random_point(random);
      const std::uint32_t cell = sampler.cell_of(point, 0);
      for (std::uint32_t i = 0; i < lights.size(); ++i) {
        const Light& light = lights[i];
        const bool is_in_front = light.is_delta() || light.emits_both_sides ||
                                 dot(light.normal, point - light.position) > 0;
        if (is_in_front && sampler.probability(i) > 0) {
          ASSERT_GT(sampler.probability(i, cell), 0.0f) << i << " of " << count;
        }
      }
    }
  }
}

// Eight lamps that look up; below them nothing is to be picked, so that it is by power.
TEST(Unit_LightCells, LeaveOutWhatIsBehindAndPreferWhatIsNear) {
  std::vector<Light> lights;
  for (int i = 0; i < 8; ++i) {
    const float x = -0.9f + 0.25f * static_cast<float>(i);
    lights.push_back(
        make_triangle_light({Vec3f(x, 0, 0), {x + 0.01f, 0, 0}, {x, 0.01f, 0}}, Rgb(1), false));
  }
  lights.push_back(make_triangle_light({Vec3f(0, 0, 0.5f), {0, 1e-2f, 0.5f}, {1e-2f, 0, 0.5f}},
                                       Rgb(1), false));  // looks down
  const LightSampler sampler = sampler_of(lights);
  const std::uint32_t above = sampler.cell_of({-0.9f, 0, 0.9f}, 0);
  EXPECT_GT(sampler.probability(0, above), 2 * sampler.probability(7, above));
  EXPECT_EQ(sampler.probability(8, above), 0.0f);
  const std::uint32_t below = sampler.cell_of({0.5f, 0.5f, -0.9f}, 0);
  EXPECT_EQ(sampler.probability(8, below), 1.0f);
}

// Few lights are picked by power from the second hit on; many are not.
TEST(Unit_LightCells, AreAskedWhereThatPays) {
  const LightSampler few = sampler_of(scattered_lights(60));
  EXPECT_NE(few.cell_of(Vec3f(0), 0), LightCells::everywhere);
  EXPECT_EQ(few.cell_of(Vec3f(0), behind_first_hit), LightCells::everywhere);
  EXPECT_TRUE(few.tells_rest());
  const LightSampler many = sampler_of(scattered_lights(3000));
  EXPECT_NE(many.cell_of(Vec3f(0), behind_first_hit), LightCells::everywhere);
  EXPECT_FALSE(many.tells_rest());
}

// Nor where lights are fewer than eight, or have no place.
TEST(Unit_LightCells, NeedLightsEnoughThatHaveAPlace) {
  std::vector<Light> lights = scattered_lights(60);
  EXPECT_EQ(sampler_of({lights.begin(), lights.begin() + 3}).cell_of(Vec3f(0), 0),
            LightCells::everywhere);
  for (int i = 0; i < 5; ++i) lights.push_back(make_directional_light({0, 0, 1}, Rgb(1)));
  EXPECT_EQ(sampler_of(lights).cell_of(Vec3f(0), 0), LightCells::everywhere);
}

// Points that rounding put beside the box belong to it.
TEST(Unit_LightCells, KnowPointsBesideTheBox) {
  const std::vector<Light> lights = scattered_lights(60);
  const LightSampler sampler = sampler_of(lights);
  EXPECT_EQ(sampler.cell_of(Vec3f(1.0001f), 0), sampler.cell_of(Vec3f(0.9999f), 0));
  EXPECT_EQ(sampler.cell_of(Vec3f(-1.0001f), 0), sampler.cell_of(Vec3f(-0.9999f), 0));
}

}  // namespace
}  // namespace candela
