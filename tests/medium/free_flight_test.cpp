#include "renderer/medium/free_flight.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

Medium medium_of(const Rgb& absorption, const Rgb& scattering) {
  Medium medium;
  medium.extinction = absorption + scattering;
  medium.scattering = scattering;
  return medium;
}

constexpr std::uint32_t steps = 1u << 16;

// All random numbers, evenly.
template <class Visit>
void for_all_numbers(const Visit& visit) {
  for (std::uint32_t i = 0; i < steps; ++i) visit((i << 16) + (1u << 15));
}

void expect_near(const Vec3d& found, const Vec3d& expected, double allowed) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], allowed) << c;
}

Vec3d beer(const Vec3d& depth) {
  return {std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)};
}

const Rgb throughputs[] = {{1, 1, 1}, {0.7f, 0.01f, 0.2f}, {0, 0.5f, 0}, {1, 0, 1e-6f}};

// Light through three media one after another, the middle one of which only absorbs: in every
// channel that carries light, what passes is Beer's law.
TEST(Unit_FreeFlight, WhatPassesIsBeersLaw) {
  const Medium first = medium_of({0.1f, 0.5f, 0}, {0.3f, 1, 0.2f});
  const Medium glass = medium_of({1, 0.2f, 0.5f}, Rgb(0));
  const Medium last = medium_of(Rgb(0), {2, 0, 1});
  for (const Rgb& throughput : throughputs) {
    Vec3d passed(0.0);
    for_all_numbers([&](std::uint32_t bits) {
      FreeFlight flight = start_flight(throughput, bits);
      if (fly_through(first, 0.8f, flight) < infinity) return;
      EXPECT_EQ(fly_through(glass, 0.4f, flight), infinity);
      if (fly_through(last, 0.25f, flight) < infinity) return;
      passed += Vec3d(throughput * passing_weight(flight)) / double{steps};
    });
    const Vec3d depth{0.32 + 0.4 + 0.5, 1.2 + 0.08, 0.16 + 0.2 + 0.25};
    expect_near(passed, Vec3d(throughput) * beer(depth), 1e-4);
  }
}

// The mean over collisions of weight * f(place) is the integral of sigma_s T f along the way.
TEST(Unit_FreeFlight, CollisionsAreWhereLightScatters) {
  const Medium glass = medium_of({1, 0.2f, 0.5f}, Rgb(0));
  const Medium milk = medium_of({0.1f, 0.5f, 0}, {0.3f, 3, 0.2f});
  const double length = 2;
  const auto f = [](double x) { return 1 + x * x; };
  for (const Rgb& throughput : throughputs) {
    Vec3d scattered(0.0);
    for_all_numbers([&](std::uint32_t bits) {
      FreeFlight flight = start_flight(throughput, bits);
      EXPECT_EQ(fly_through(glass, 0.5f, flight), infinity);
      const float way = fly_through(milk, static_cast<float>(length), flight);
      if (way == infinity) return;
      ASSERT_LE(way, static_cast<float>(length));
      scattered +=
          Vec3d(throughput * collision_weight(flight, milk)) * f(double{way}) / double{steps};
    });
    Vec3d expected(0.0);
    constexpr int panels = 10'000;
    for (int i = 0; i < panels; ++i) {
      const double x = (i + 0.5) / panels * length;
      expected += beer(Vec3d(milk.extinction) * x) * f(x) * (length / panels);
    }
    expected *= Vec3d(throughput) * Vec3d(milk.scattering) * beer({0.5, 0.1, 0.25});
    expect_near(scattered, expected, 2e-4);
  }
}

// Whatever channel decided, no weight exceeds what the path carries in all of them.
TEST(Unit_FreeFlight, WeightsStayBelowTheSumOfTheChannels) {
  const Medium ink = medium_of({0, 40, 1000}, {0.5f, 1, 2000});
  for (const Rgb& throughput : throughputs) {
    const float most = (throughput.x + throughput.y + throughput.z) * 1.0001f;
    for_all_numbers([&](std::uint32_t bits) {
      FreeFlight flight = start_flight(throughput, bits);
      const float way = fly_through(ink, 3, flight);
      const Rgb weight =
          throughput * (way < infinity ? collision_weight(flight, ink) : passing_weight(flight));
      ASSERT_TRUE(is_finite(weight));
      ASSERT_LE(max_component(weight), most);
    });
  }
}

TEST(Unit_FreeFlight, EndlessMediaLetNothingPass) {
  const Medium fog = medium_of(Rgb(0), {0.1f, 0.2f, 0});
  Vec3d passed(0.0);
  for_all_numbers([&](std::uint32_t bits) {
    FreeFlight flight = start_flight(Rgb(1), bits);
    if (fly_through(fog, infinity, flight) == infinity)
      passed += Vec3d(passing_weight(flight)) / double{steps};
  });
  expect_near(passed, {0, 0, 1}, 1e-4);  // blue is as clear as air
}

TEST(Unit_FreeFlight, MediaThatOnlyAbsorbHaveNoNoise) {
  const Medium glass = medium_of({0.5f, 2, 0}, Rgb(0));
  FreeFlight flight;  // no random number
  EXPECT_EQ(fly_through(glass, 2, flight), infinity);
  expect_near(Vec3d(passing_weight(flight)), beer({1, 4, 0}), 1e-7);
}

}  // namespace
}  // namespace candela
