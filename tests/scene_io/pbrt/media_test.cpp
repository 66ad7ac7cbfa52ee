// Media of pbrt scenes as candela describes them.
#include <gtest/gtest.h>

#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using namespace description;
using test::pbrt_scene;
using test::pbrt_warning;
using test::pbrt_world;
using test::pbrt_world_error;
using test::pbrt_world_warning;

const std::string green =
    "MakeNamedMedium \"green\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [ 1 2 3 ] \"rgb "
    "sigma_s\" [ 4 5 6 ] \"float scale\" 2 \"float g\" .25\n";

std::string named(const std::string& parameters) {
  return "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" " + parameters +
         "\nMediumInterface \"m\" \"\" Shape \"disk\"";
}

TEST(Unit_PbrtMedia, CoefficientsAndSidesAreTheFiles) {
  const auto scene = pbrt_world(green + "Material \"dielectric\"\nShape \"disk\"\n" +
                                "MediumInterface \"green\" \"\"\nShape \"disk\"\n" +
                                "MediumInterface \"\" \"green\"\nShape \"disk\"");
  ASSERT_EQ(scene.media.size(), 1u);
  EXPECT_EQ(scene.media[0].name, "green");
  EXPECT_EQ(scene.media[0].absorption, Vec3d(2, 4, 6));
  EXPECT_EQ(scene.media[0].scattering, Vec3d(8, 10, 12));
  EXPECT_EQ(scene.media[0].asymmetry, 0.25);
  ASSERT_EQ(scene.materials.size(), 3u);
  const MediumHandle none, medium(0);
  const auto expect_sides = [&](std::size_t i, MediumHandle inside, MediumHandle outside) {
    EXPECT_EQ(scene.materials[i].media.inside, inside) << i;
    EXPECT_EQ(scene.materials[i].media.outside, outside) << i;
  };
  expect_sides(0, none, none);
  expect_sides(1, medium, none);
  expect_sides(2, none, medium);
}

// A single name counts for both sides: the surface is within what surrounds it.
TEST(Unit_PbrtMedia, OneNameBoundsNothing) {
  const auto scene = pbrt_world(green + "MediumInterface \"green\" Shape \"disk\"");
  EXPECT_FALSE(scene.materials.at(0).media.inside);
  EXPECT_FALSE(scene.materials.at(0).media.outside);
}

TEST(Unit_PbrtMedia, TheCameraIsInTheMediumOutside) {
  const auto scene = pbrt_scene(green + "MediumInterface \"\" \"green\"\nCamera \"perspective\"\n" +
                                "MediumInterface \"\" \"\"\nWorldBegin\nShape \"disk\"");
  EXPECT_EQ(scene.cameras.at(0).medium, MediumHandle(0));
  EXPECT_FALSE(
      pbrt_scene(green + "MediumInterface \"green\" \"\"\nCamera \"perspective\"\n" + "WorldBegin")
          .cameras.at(0)
          .medium);
}

TEST(Unit_PbrtMedia, WithoutCoefficientsItIsMilk) {
  const Medium milk = pbrt_world(named("")).media.at(0);
  EXPECT_EQ(milk.scattering, Vec3d(2.55, 3.21, 3.77));
  EXPECT_EQ(milk.absorption, Vec3d(.0011, .0024, .014));
  const Medium ketchup =
      pbrt_world(named("\"string preset\" \"Ketchup\" \"float scale\" 10")).media.at(0);
  EXPECT_EQ(ketchup.scattering, Vec3d(.18, .07, .03) * 10.0);
  EXPECT_EQ(ketchup.absorption, Vec3d(.061, .97, 1.45) * 10.0);
}

// Nothing of them comes to the scene.
TEST(Unit_PbrtMedia, UnusedOnesAreChecked) {
  EXPECT_EQ(pbrt_world_error("MakeNamedMedium \"m\" \"string type\" \"homogenous\""),
            "2:17: 'homogenous' is no type of media, did you mean 'homogeneous'?");
  EXPECT_TRUE(pbrt_world(green).media.empty());
}

TEST(Errors_PbrtMedia, WhatIsNotRenderedIsNamed) {
  EXPECT_EQ(pbrt_world_error(green + "MediumInterface \"gren\" \"\"\nShape \"disk\""),
            "3:17: there is no medium 'gren', did you mean 'green'?");
  EXPECT_EQ(pbrt_world_error(green + "MediumInterface \"\" \"gren\"\nShape \"disk\""),
            "3:20: there is no medium 'gren', did you mean 'green'?");
  EXPECT_EQ(pbrt_world_warning("MakeNamedMedium \"m\" \"string type\" \"cloud\"\nMediumInterface "
                               "\"m\" \"\" Shape \"disk\" Shape \"disk\""),
            "2:17: media of type 'cloud' are not rendered: 'm' is as clear as air");
  EXPECT_EQ(pbrt_world_warning(named("\"string preset\" \"Ketchp\"")),
            "2:49: 'preset' is 'Ketchp', no medium that candela knows, did you mean 'Ketchup'?");
  EXPECT_EQ(pbrt_world_warning(named("\"rgb Le\" [ 1 1 1 ]")),
            "2:49: 'Le' is ignored: media do not shine");
}

}  // namespace
}  // namespace candela
