// Point, spot and directional lights.
#include <gtest/gtest.h>

#include "renderer/light/light_power.h"
#include "renderer/light/make_light.h"
#include "renderer/light/sample_light.h"
#include "tests/light/directions.h"

namespace candela {
namespace {

constexpr double degree = pi_double / 180;

TEST(Unit_PointLight, GivesThePlaneItsIrradiance) {
  const Light light = make_point_light({1, 2, 3}, Rgb(10, 20, 30));
  const Vec3f p(4, 0, -1);
  const LightSample s = sample_light({}, light, light_test::at(p), {0, 0});
  const double distance2 = 9 + 4 + 16;
  EXPECT_TRUE(s.is_delta);
  EXPECT_EQ(s.pdf, 1.0f);
  EXPECT_NEAR(length(s.shadow_ray.origin + s.shadow_ray.direction - Vec3f(1, 2, 3)), 0, 1e-6);
  // E = I cos / d^2 = I h / d^3 at a height h over the plane y = 0.
  EXPECT_NEAR(s.radiance.y * s.wi.y, 20 * 2 / std::pow(distance2, 1.5), 1e-7);
}

TEST(Unit_PointLight, StaysFiniteWhereItTouches) {
  const Light light = make_point_light({1, 2, 3}, Rgb(1e10f));
  EXPECT_FALSE(sample_light({}, light, light_test::at({1, 2, 3}), {0, 0}).is_valid());
  for (const float d : {1e-6f, 1e-3f, 1.0f}) {
    const LightSample s = sample_light({}, light, light_test::at({1 + d, 2, 3}), {0, 0});
    EXPECT_TRUE(is_finite(s.radiance) && is_finite(s.wi));
  }
  const Light at_origin = make_point_light(Vec3f(0), Rgb(1));
  for (const float d : {1e-38f, 1e-25f, 1e-19f})
    EXPECT_TRUE(is_finite(sample_light({}, at_origin, light_test::at({d, 0, 0}), {0, 0}).radiance))
        << d;
}

TEST(Unit_DirectionalLight, FacesTheSurfaceWithItsIrradiance) {
  const Light light = make_directional_light({0, 30, 40}, Rgb(7));
  const LightSample s = sample_light({}, light, light_test::at({5, 6, 7}), {0, 0});
  EXPECT_TRUE(s.is_delta && s.is_valid());
  EXPECT_EQ(s.shadow_ray.t_max, infinity);
  EXPECT_EQ(s.wi, Vec3f(0, 0.6f, 0.8f));
  EXPECT_EQ(s.radiance, Rgb(7));
}

// What a spot sends at an angle from its axis.
double spot_share(const Light& light, double angle) {
  return static_cast<double>(
      spot_falloff(light, Vec3f(Vec3d(std::sin(angle), 0, -std::cos(angle)))));
}

TEST(Unit_SpotLight, FallsSmoothlyInTheCosine) {
  const double inner = 20 * degree, outer = 50 * degree;
  const Light light = make_spot_light({0, 0, 0}, {0, 0, -3}, Rgb(1), inner, outer);
  EXPECT_EQ(spot_share(light, 0), 1);
  EXPECT_EQ(spot_share(light, inner * 0.999), 1);
  EXPECT_EQ(spot_share(light, outer * 1.001), 0);
  EXPECT_EQ(spot_share(light, pi_double), 0);
  for (double angle = inner; angle < outer; angle += degree) {
    const double t = (std::cos(angle) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
    EXPECT_NEAR(spot_share(light, angle), t * t * (3 - 2 * t), 3e-6) << angle / degree;
  }
}

// Angles that cosines in float cannot tell from 0: 1 - cos(0.005 degrees) = 3.8e-9.
TEST(Unit_SpotLight, IsExactForVeryNarrowCones) {
  const double inner = 0.005 * degree, outer = 0.01 * degree;
  const Light light = make_spot_light({0, 0, 0}, {0, 0, -1}, Rgb(1), inner, outer);
  EXPECT_EQ(spot_share(light, 0.0049 * degree), 1);
  EXPECT_EQ(spot_share(light, 0.0101 * degree), 0);
  const double middle = std::sqrt((inner * inner + outer * outer) / 2);  // half way in the cosine
  EXPECT_NEAR(spot_share(light, middle), 0.5, 1e-3);
}

TEST(Unit_SpotLight, HasAHardEdgeWhereTheAnglesAreEqual) {
  const Light light = make_spot_light({0, 0, 0}, {0, 0, -1}, Rgb(1), 30 * degree, 30 * degree);
  EXPECT_EQ(spot_share(light, 29.99 * degree), 1);
  EXPECT_EQ(spot_share(light, 30.01 * degree), 0);
  const Light all = make_spot_light({0, 0, 0}, {0, 0, -1}, Rgb(1), pi_double, pi_double);
  EXPECT_EQ(spot_share(all, 179.9 * degree), 1);
}

TEST(Unit_SpotLight, FluxOfTheConeIsItsPower) {
  const double angles[][2] = {{0, 30}, {20, 50}, {60, 60}, {80, 180}, {0.01, 0.02}};
  for (const auto& [inner, outer] : angles) {
    const Light light =
        make_spot_light({0, 0, 0}, {1, -2, 0.5}, Rgb(3), inner * degree, outer * degree);
    const light_test::Cap cone{frame_from_normal(light.edge1), std::cos(outer * degree * 1.05)};
    const double flux = light_test::integral(
        cone, 500, [&](const Vec3f& w) { return 3 * static_cast<double>(spot_falloff(light, w)); });
    EXPECT_NEAR(flux / light_power(light, nullptr, 1), 1, 2e-3) << inner << " " << outer;
  }
}

TEST(Unit_SpotLight, SendsNothingOutsideOfItsCone) {
  const Light light = make_spot_light({0, 0, 2}, {0, 0, -1}, Rgb(8), 10 * degree, 20 * degree);
  const LightSample below = sample_light({}, light, light_test::at({0, 0, 0}), {0, 0});
  EXPECT_TRUE(below.is_valid() && below.is_delta);
  EXPECT_EQ(below.radiance, Rgb(2));
  EXPECT_FALSE(sample_light({}, light, light_test::at({0, 0, 4}), {0, 0}).is_valid());
  EXPECT_FALSE(sample_light({}, light, light_test::at({2, 0, 0}), {0, 0}).is_valid());
}

}  // namespace
}  // namespace candela
