#include <gtest/gtest.h>

#include "renderer/math/constants.h"
#include "tests/scene_io/lab3/lab3_text.h"

namespace candela {
namespace {

using namespace description;
using test::error_in;
using test::said;
using test::scene_of;
using test::warning_in;

// The only light of `Lights: [{...}]` in a scene without ambient light.
template <class Kind>
Kind light_of(std::string_view keys) {
  const auto scene = scene_of(fmt::format("AmbientIntensity: [0, 0, 0]\nLights: [{{{}}}]\n", keys));
  if (scene.lights.size() != 1 || !std::holds_alternative<Kind>(scene.lights[0].kind)) {
    ADD_FAILURE() << "not one light of that kind: " << keys;
    return {};
  }
  return std::get<Kind>(scene.lights[0].kind);
}

std::string lights(std::string_view keys) {
  return fmt::format("Lights:\n  - {{{}}}\n", keys);
}

void expect_near(const Vec3d& a, const Vec3d& b) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-12 * (1 + std::abs(b[i])));
}

TEST(Unit_Lab3Lights, PointHasPiTimesItsIntensity) {
  const auto light =
      light_of<PointLight>("Type: Point, Position: [1, 2, 3], Intensity: [1, 10, 1e5]");
  EXPECT_EQ(light.position, Vec3d(1, 2, 3));
  expect_near(light.intensity, pi_double * Vec3d(1, 10, 1e5));
}

TEST(Unit_Lab3Lights, Defaults) {
  const auto point = light_of<PointLight>("");
  EXPECT_EQ(point.position, Vec3d(0.0));
  expect_near(point.intensity, Vec3d(pi_double));
  const auto sun = light_of<DirectionalLight>("Type: Directional");
  EXPECT_EQ(sun.to_light, Vec3d(1, 0, 0));
  expect_near(sun.irradiance, Vec3d(pi_double));
}

TEST(Unit_Lab3Lights, DirectionPointsToTheLight) {
  const auto sun =
      light_of<DirectionalLight>("Type: Directional, Direction: [3, 0, 4], Intensity: [2, 2, 1.5]");
  expect_near(sun.to_light, Vec3d(0.6, 0, 0.8));
  expect_near(sun.irradiance, pi_double * Vec3d(2, 2, 1.5));
  expect_near(light_of<DirectionalLight>("Type: Directional, Direction: [0, 1e-200, 0]").to_light,
              Vec3d(0, 1, 0));
}

TEST(Unit_Lab3Lights, SpotShinesAgainstItsDirection) {
  const auto spot = light_of<SpotLight>(
      "Type: Spot, Position: [0, 5, 0], Direction: [0, 2, 0], Intensity: [3, 3, 3], CutOff: 20, "
      "OuterCutOff: 30");
  EXPECT_EQ(spot.position, Vec3d(0, 5, 0));
  expect_near(spot.axis, Vec3d(0, -1, 0));
  expect_near(spot.intensity, Vec3d(3 * pi_double));
  EXPECT_NEAR(spot.inner_angle_radians, pi_double / 9, 1e-15);
  EXPECT_NEAR(spot.outer_angle_radians, pi_double / 6, 1e-15);
}

TEST(Unit_Lab3Lights, OneCutOffMakesAHardEdge) {
  for (const char* key : {"CutOff", "OuterCutOff"}) {
    const auto spot = light_of<SpotLight>(fmt::format("Type: Spot, {}: 90", key));
    EXPECT_NEAR(spot.inner_angle_radians, pi_double / 2, 1e-15);
    EXPECT_NEAR(spot.outer_angle_radians, pi_double / 2, 1e-15);
  }
}

TEST(Errors_Lab3Lights, Spots) {
  EXPECT_EQ(error_in(lights("Type: Spot")),
            "2:5: a Spot light needs CutOff or OuterCutOff, the half angle of its cone in degrees");
  EXPECT_EQ(error_in(lights("Type: Spot, CutOff: 181")),
            "2:26: CutOff: found '181', expected a half angle in degrees from 0 to 180");
  EXPECT_EQ(warning_in(lights("Type: Spot, CutOff: 30, OuterCutOff: 20")),
            "2:43: OuterCutOff 20 lies within CutOff 30: both are taken as 30");
  EXPECT_EQ(warning_in(lights("Type: Spot, CutOff: 30, Length: 20")),
            "2:30: Length is not used: a Spot light is a point");
}

TEST(Unit_Lab3Lights, AreaInBothSpellings) {
  for (const char* keys : {"p0: [0, 0, 0], p1: [2, 0, 0], p2: [0, 2, 0]",
                           "Position: [0, 0, 0], Position2: [2, 0, 0], Position3: [0, 2, 0]"}) {
    const auto area =
        light_of<TriangleLight>(fmt::format("Type: Area, Intensity: [4, 5, 6], {}", keys));
    EXPECT_EQ(area.vertices[0], Vec3d(0, 0, 0));
    EXPECT_EQ(area.vertices[1], Vec3d(2, 0, 0));
    EXPECT_EQ(area.vertices[2], Vec3d(0, 2, 0));
    EXPECT_EQ(area.radiance, Vec3d(4, 5, 6));  // a radiance: no pi
    EXPECT_FALSE(area.emits_both_sides);
  }
}

TEST(Unit_Lab3Lights, DirectionOfAnAreaChoosesItsSide) {
  const std::string corners = "Type: Area, p0: [0, 0, 0], p1: [2, 0, 0], p2: [0, 2, 0]";
  const auto same = light_of<TriangleLight>(corners + ", Direction: [1, 1, .1]");
  EXPECT_EQ(same.vertices[1], Vec3d(2, 0, 0));
  const auto turned = light_of<TriangleLight>(corners + ", Direction: [1, 1, -.1]");
  EXPECT_EQ(turned.vertices[1], Vec3d(0, 2, 0));
  EXPECT_EQ(turned.vertices[2], Vec3d(2, 0, 0));
  EXPECT_TRUE(light_of<TriangleLight>(corners + ", TwoSided: true").emits_both_sides);
  EXPECT_EQ(warning_in(lights(corners + ", Direction: [1, 0, 0]")),
            "2:74: Direction lies in the light's plane and chooses no side: the light shines to "
            "the side of (p1 - p0) x (p2 - p0)");
}

TEST(Errors_Lab3Lights, AreNamedOnceHoweverManyAliasesThereAre) {
  EXPECT_EQ(error_in("Lights: [&a {Intensity: 5}, *a, *a]\n"),
            "1:25: Intensity: found '5', expected a list of 3 numbers, such as [5, 5, 5]");
}

TEST(Errors_Lab3Lights, Areas) {
  EXPECT_EQ(error_in(lights("Type: Area")),
            "2:5: an Area light needs p0, p1 and p2, the corners of its triangle");
  EXPECT_EQ(error_in(lights("Type: Area, p0: [0, 0, 0], p1: [1, 0, 0]")),
            "2:5: an Area light needs p2, a corner of its triangle");
  EXPECT_EQ(error_in(lights("Type: Area, Position: [0, 0, 0], Position2: [1, 0, 0]")),
            "2:5: an Area light needs Position3, a corner of its triangle");
  EXPECT_EQ(error_in(lights("Type: Area, p0: [0, 0, 0], p1: [1, 1, 1], p2: [3, 3, 3]")),
            "2:5: the corners of this Area light lie on a line: its area is 0");
  EXPECT_EQ(error_in(lights("Type: Area, p0: [5, 5, 5], p1: [5, 5, 5], p2: [3, 2, 3]")),
            "2:5: the corners of this Area light lie on a line: its area is 0");
  EXPECT_EQ(warning_in(lights("Type: Area, p0: [0, 0, 0], p1: [1, 0, 0], p2: [0, 1, 0], Position: "
                              "[0, 0, 0]")),
            "2:5: both p0, p1, p2 and Position, Position2, Position3 are given: p0, p1, p2 count");
}

TEST(Unit_Lab3Lights, NeedlesAndTinyTrianglesAreLights) {
  (void)light_of<TriangleLight>("Type: Area, p0: [0, 0, 0], p1: [1, 0, 0], p2: [1, 1e-6, 0]");
  (void)light_of<TriangleLight>(
      "Type: Area, p0: [0, 0, 0], p1: [1e-180, 0, 0], p2: [0, 1e-180, 0]");
}

TEST(Errors_Lab3Lights, WhatIsNoLight) {
  EXPECT_EQ(error_in(lights("Type: Pont")),
            "2:12: Type: found 'Pont', expected Point, Spot, Directional or Area, did you mean "
            "'Point'?");
  EXPECT_EQ(error_in(lights("Intensity: [1, -1, 1]")),
            "2:21: Intensity: found '-1', expected a number of at least 0");
  EXPECT_EQ(error_in(lights("Intensity: 5")),
            "2:17: Intensity: found '5', expected a list of 3 numbers, such as [5, 5, 5]");
  EXPECT_EQ(error_in(lights("Type: Directional, Direction: [0, 0, 0]")),
            "2:36: Direction: found [0, 0, 0], expected a direction");
  EXPECT_EQ(error_in(lights("Type: Area, TwoSided: maybe, p0: [0, 0, 0], p1: [1, 0, 0], p2: [0, "
                            "1, 0]")),
            "2:28: TwoSided: found 'maybe', expected true or false");
}

TEST(Unit_Lab3Lights, KeysOfOtherKindsAreWarnedOf) {
  EXPECT_EQ(warning_in(lights("Type: Point, CutOff: 30")),
            "2:19: CutOff has no meaning for a Point light");
  EXPECT_EQ(warning_in(lights("Type: Directional, p0: [0, 0, 0]")),
            "2:25: p0 has no meaning for a Directional light");
  EXPECT_EQ(
      warning_in(lights("Type: Area, p0: [0, 0, 0], p1: [1, 0, 0], p2: [0, 1, 0], CutOff: 5")),
      "2:63: CutOff has no meaning for an Area light");
}

TEST(Unit_Lab3Lights, LampsThatAreGivenTwiceAreWarnedOf) {
  const std::string area =
      "Lights:\n  - {Type: Area, p0: [0, 0, 0], p1: [1, 0, 0], p2: [0, 1, 0]}\n";
  const auto lamp = [&](std::string_view emission) {
    return fmt::format("{}Materials: [{{Name: lamp, Emission: {}}}]\n", area, emission);
  };
  const std::string model = "Models: [{Mesh: triangle.obj, Material: lamp}]\n";
  EXPECT_EQ(warning_in(lamp("[17, 12, 4]") + model),
            "2:5: there are Area lights and materials with Emission ('lamp'): both shine; where "
            "they stand for the same lamp leave one out");
  EXPECT_TRUE(said(Severity::Warning, lamp("0") + model).empty());
  EXPECT_TRUE(said(Severity::Warning, lamp("5")).empty()) << "no model has it";
}

}  // namespace
}  // namespace candela
