// Several skies as one: what it sends from every direction, and how it is sampled.
#include "renderer/light/sum_environments.h"

#include <gtest/gtest.h>

#include "renderer/math/colour.h"
#include "tests/light/directions.h"
#include "tests/light/map_images.h"
#include "tests/statistics/moments.h"

namespace candela {
namespace {

using light_test::Cap;
using light_test::random_direction;
using light_test::write_byte_map;
using light_test::write_float_map;

// Skies in one store.
struct Skies {
  TextureStore textures;
  std::vector<Environment> maps;
  Diagnostics diagnostics;

  template <class Map>
  void add(const description::Image& image, const Mat3d& world_from_map = Mat3d(1.0),
           const Vec3d& scale = Vec3d(1.0)) {
    Map map;
    map.image = description::ImageHandle(std::size_t{0});
    map.world_from_map = world_from_map;
    map.scale = scale;
    maps.push_back(build_environment(map, std::span(&image, 1), textures, diagnostics));
  }
  [[nodiscard]] Vec3d radiance(const Vec3f& d) const {
    Vec3d sum(0.0);
    for (const Environment& map : maps) sum += Vec3d(environment_radiance(map, textures, d));
    return sum;
  }
};

Mat3d turn(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {Vec3d(c, s, 0), Vec3d(-s, c, 0), Vec3d(0, 0, 1)};
}

Vec3f varied_texel(int x, int y) {
  const float spot = (x * 5 + y * 3) % 23 == 0 ? 20.0f : 0.0f;
  return {1 + 0.1f * static_cast<float>(x) + spot, 0.2f * static_cast<float>(y), spot};
}
Vec3f other_texel(int x, int y) {
  return {static_cast<float>((x * y) % 7), 3, static_cast<float>(x)};
}

// a + b . d of the direction d in the world, as an image of equal areas whose axes are turned.
constexpr double base = 2;
Vec3d smooth(const Vec3d& d) {
  return Vec3d(base) + Vec3d(d.x, 0.5 * d.y - d.z, d.z);
}
description::Image smooth_map(const std::string& name, int side, const Mat3d& world_from_map) {
  return write_float_map(name, side, side, [&](int x, int y) {
    const Vec2f st((static_cast<float>(x) + 0.5f) / static_cast<float>(side),
                   (static_cast<float>(y) + 0.5f) / static_cast<float>(side));
    return Vec3f(smooth(world_from_map * Vec3d(square_to_equal_area_sphere(st))));
  });
}

void expect_near(const Rgb& found, const Vec3d& expected, double share) {
  for (int c = 0; c < 3; ++c)
    ASSERT_NEAR(double{found[c]}, expected[c], share * (expected[c] + 0.1)) << c;
}

// The sum of bilinear interpolations over one grid is that of the sums, to rounding.
TEST(Unit_SumOfSkies, OfOneGridIsExactEverywhere) {
  const Vec3d constant(0.25, 0.5, 4);
  for (const bool is_square : {true, false}) {
    Skies skies;
    const int height = is_square ? 16 : 8;
    const auto a = write_float_map(fmt::format("sum_a{}", height), 16, height, varied_texel);
    const auto b = write_float_map(fmt::format("sum_b{}", height), 16, height, other_texel);
    if (is_square) {
      skies.add<description::EqualAreaEnvironment>(a, turn(0.3), Vec3d(1, 2, 3));
      skies.add<description::EqualAreaEnvironment>(b, turn(0.3));
    } else {
      skies.add<description::LatLongEnvironment>(a, turn(0.3), Vec3d(1, 2, 3));
      skies.add<description::LatLongEnvironment>(b, turn(0.3));
    }
    const EnvironmentSum sum = sum_environments(constant, skies.maps, skies.textures);
    EXPECT_EQ(sum.resampled_side, 0);
    EXPECT_EQ(sum.environment.mapping, skies.maps[0].mapping);
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const Vec3f d = random_direction(i, 1);
      expect_near(environment_radiance(sum.environment, skies.textures, d),
                  skies.radiance(d) + constant, 3e-6);
    }
  }
}

TEST(Unit_SumOfSkies, OfDifferentGridsIsTheClosedForm) {
  Skies skies;
  skies.add<description::EqualAreaEnvironment>(smooth_map("sum_s64", 64, turn(0.3)), turn(0.3));
  skies.add<description::EqualAreaEnvironment>(smooth_map("sum_s100", 100, turn(2)), turn(2));
  const EnvironmentSum sum = sum_environments(Vec3d(1.0), skies.maps, skies.textures);
  EXPECT_EQ(sum.resampled_side, 200);
  statistics::Moments squares;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Vec3f d = random_direction(i, 2);
    const Vec3d expected = Vec3d(1.0) + 2.0 * smooth(Vec3d(d));
    const Vec3d off = Vec3d(environment_radiance(sum.environment, skies.textures, d)) - expected;
    // At the squares' edges lookups end half a texel early: .028 and .018 radians.
    ASSERT_LT(max_component(glm::abs(off)), 0.06) << i;
    squares.add(dot(off, off) / 3);
  }
  EXPECT_LT(std::sqrt(squares.mean()), 0.01);
}

// Texels that differ as much as they can, of all mappings: the mean over the sphere is kept.
TEST(Statistical_SumOfSkies, HasTheLightOfAll) {
  Skies skies;
  skies.add<description::EqualAreaEnvironment>(write_float_map("sum_e", 16, 16, varied_texel),
                                               turn(1), Vec3d(2.0));
  skies.add<description::LatLongEnvironment>(write_float_map("sum_l", 12, 9, other_texel), turn(2));
  const EnvironmentSum sum = sum_environments(Vec3d(0.5), skies.maps, skies.textures);
  EXPECT_EQ(sum.resampled_side, 64);
  statistics::Moments off;
  for (std::uint64_t i = 0; i < 400'000; ++i) {
    const Vec3f d = random_direction(i, 3);
    off.add(luminance(Vec3d(environment_radiance(sum.environment, skies.textures, d))) -
            luminance(skies.radiance(d)));
  }
  EXPECT_GT(off.p_value(0.5), 1e-4) << off.mean();
  EXPECT_LT(off.standard_error(), 0.002);
}

// A sun of one texel, wherever it falls between those of the sum.
TEST(Unit_SumOfSkies, ASunKeepsItsLight) {
  const auto sun = write_float_map(
      "sum_sun", 64, 64, [](int x, int y) { return Vec3f(x == 41 && y == 23 ? 1e4f : 0); });
  const auto night = write_float_map("sum_night", 66, 66, [](int, int) { return Vec3f(0); });
  for (int i = 0; i < 24; ++i) {
    Skies skies;
    skies.add<description::EqualAreaEnvironment>(sun, turn(0.26 * i + 0.1));
    skies.add<description::EqualAreaEnvironment>(night);
    const EnvironmentSum sum = sum_environments(Vec3d(0.0), skies.maps, skies.textures);
    EXPECT_EQ(sum.resampled_side, 132);
    EXPECT_NEAR(sum.environment.mean_luminance / skies.maps[0].mean_luminance, 1, 0.02) << i;
  }
}

TEST(Statistical_SumOfSkies, TheDensityIntegratesToOneAndFollowsTheSum) {
  Skies skies;
  skies.add<description::EqualAreaEnvironment>(write_float_map("sum_p", 16, 16, varied_texel),
                                               turn(1));
  skies.add<description::LatLongEnvironment>(write_float_map("sum_q", 12, 9, other_texel), turn(2));
  const EnvironmentSum sum = sum_environments(Vec3d(0.5), skies.maps, skies.textures);
  const auto pdf = [&](const Vec3f& d) { return double{environment_pdf(sum.environment, d)}; };
  const statistics::Moments whole = light_test::random_integral(Cap{}, 400'000, pdf);
  EXPECT_GT(whole.p_value(1), 1e-4) << whole.mean();
  statistics::Moments estimate;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const EnvironmentSample s = sample_environment(sum.environment, light_test::random_pair(i, 5));
    const Rgb seen = environment_radiance(sum.environment, skies.textures, s.direction);
    estimate.add(luminance(Vec3d(seen)) / double{s.pdf});
  }
  EXPECT_GT(estimate.p_value(sum.environment.mean_luminance * 4 * pi_double), 1e-4);
  EXPECT_LT(estimate.standard_error() / estimate.mean(), 0.003);  // uniform: .008
}

// lab3's gamma decodes what is filtered, so sums of texels are not sums of lookups.
TEST(Unit_SumOfSkies, WhatIsDecodedAfterFilteringIsResampled) {
  Skies skies;
  const auto image =
      write_byte_map("sum_g", 8, 8, [](int x, int) { return Vec3f(x < 4 ? 0 : 255); });
  skies.add<description::EqualAreaEnvironment>(image);
  EXPECT_EQ(sum_environments(Vec3d(1.0), skies.maps, skies.textures).resampled_side, 64);
}

TEST(Errors_SumOfSkies, InfiniteSumsAreTheLargestNumber) {
  Skies skies;
  const auto image = write_float_map("sum_inf", 2, 2, [](int, int) { return Vec3f(2e38f); });
  skies.add<description::EqualAreaEnvironment>(image);
  skies.add<description::EqualAreaEnvironment>(image);
  const EnvironmentSum sum = sum_environments(Vec3d(0.0), skies.maps, skies.textures);
  const Rgb seen = environment_radiance(sum.environment, skies.textures, {0.6f, 0, 0.8f});
  EXPECT_GT(seen.x, 3.3e38f);
}

}  // namespace
}  // namespace candela
