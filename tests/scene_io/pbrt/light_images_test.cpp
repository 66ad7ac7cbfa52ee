// Lights that images shape, as the reader leaves them.
#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "renderer/math/constants.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using namespace description;
using test::pbrt_world;
using test::pbrt_world_error;
using test::pbrt_world_warning;

void expect_near(const Vec3d& a, const Vec3d& b) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-9);
}

TEST(Unit_PbrtLightImages, GoniometricMapsLookUpAlongY) {
  const auto scene = pbrt_world(R"(Translate 0 0 5
    Rotate 90 0 0 1
    LightSource "goniometric" "rgb I" [ 1 2 3 ] "float scale" 2 "float power" 7
      "string filename" "picture.png")");
  const auto& light = std::get<GoniometricLight>(scene.lights.at(0).kind);
  expect_near(light.position, {0, 0, 5});
  expect_near(light.intensity, {2, 4, 6});
  EXPECT_EQ(light.power, 7);
  expect_near(light.world_from_map[0], {0, 1, 0});   // x
  expect_near(light.world_from_map[1], {0, 0, 1});   // the light's z
  expect_near(light.world_from_map[2], {-1, 0, 0});  // the light's y
  EXPECT_EQ(scene.images.at(light.image.index).encoding, Encoding::Srgb);
  EXPECT_FALSE(validate(scene).has_errors());
  EXPECT_FALSE(
      std::get<GoniometricLight>(pbrt_world("LightSource \"goniometric\"").lights.at(0).kind)
          .image.is_valid());
}

TEST(Unit_PbrtLightImages, Projections) {
  const auto scene = pbrt_world(
      "Scale -2 2 2 LightSource \"projection\" \"string filename\" \"picture.exr\" \"float fov\" "
      "40 \"float scale\" 3");
  const auto& light = std::get<ProjectionLight>(scene.lights.at(0).kind);
  EXPECT_EQ(light.angle_degrees, 40);
  expect_near(light.intensity, Vec3d(3.0));
  expect_near(light.world_from_map[0], {-1, 0, 0});
  expect_near(light.world_from_map[2], {0, 0, 1});
  EXPECT_EQ(scene.images.at(light.image.index).encoding, Encoding::Linear);
  EXPECT_FALSE(light.power);
  EXPECT_FALSE(validate(scene).has_errors());
}

TEST(Unit_PbrtLightImages, SurfacesThatEmitAnImage) {
  const auto material = [](const std::string& parameters) {
    const auto scene =
        pbrt_world("AreaLightSource \"diffuse\" \"string filename\" \"picture.png\" " + parameters +
                   "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  2 0 0  0 2 0 ]");
    EXPECT_FALSE(validate(scene).has_errors());
    EXPECT_EQ(scene.meshes.at(0).uvs.size(), 3u);  // pbrt's own
    EXPECT_EQ(scene.images.at(0).wrap, Wrap::Clamp);
    return scene.materials.at(0);
  };
  EXPECT_TRUE(material("").emission_map.is_valid());
  expect_near(material("\"float scale\" 4 ").emission, Vec3d(4.0));
  EXPECT_FALSE(material("\"float scale\" 4 ").emission_is_maps_mean);
  expect_near(material("\"float power\" 10 ").emission, Vec3d(10 / (2 * pi_double)));
  EXPECT_TRUE(material("\"float power\" 10 ").emission_is_maps_mean);
}

// Magenta light would be a picture that looks finished.
TEST(Errors_PbrtLightImages, FilesThatAreNotThere) {
  const std::string file = "\"string filename\" \"none.exr\" ";
  for (const std::string& text :
       {"LightSource \"infinite\" " + file, "LightSource \"goniometric\" " + file,
        "LightSource \"projection\" " + file,
        "AreaLightSource \"diffuse\" " + file + "Shape \"disk\""}) {
    const std::string error = pbrt_world_error(text);
    EXPECT_TRUE(error.ends_with("none.exr': no such file for an image")) << error;
  }
  EXPECT_EQ(pbrt_world("Texture \"t\" \"spectrum\" \"imagemap\" " + file +
                       "Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"disk\"")
                .images.size(),
            1u);
}

TEST(Errors_PbrtLightImages, SkiesOfAnImageAndMore) {
  const std::string sky = "LightSource \"infinite\" \"string filename\" \"picture.exr\" ";
  const std::string old_sky = "LightSource \"infinite\" \"string mapname\" \"picture.exr\" ";
  const auto scale = [](const std::string& text) {
    return std::get<EqualAreaEnvironment>(pbrt_world(text).lights.at(0).kind).scale;
  };
  EXPECT_EQ(pbrt_world_warning(sky + "\"float illuminance\" 10"),
            "2:56: 'illuminance' is ignored: the image's own radiance counts");
  EXPECT_EQ(pbrt_world_warning(sky + "\"rgb L\" [ 3 3 3 ]"),
            "2:56: 'L' multiplies the image, as in pbrt-v3; pbrt-v4 takes one of them");
  EXPECT_EQ(scale(sky + "\"rgb L\" [ 3 3 3 ]"), Vec3d(3.0));
  // No word of what pbrt does not read, and where pbrt-v3 has it.
  EXPECT_EQ(pbrt_world_warning(sky + "\n#candela: \"rgb L\" [ 3 3 3 ]"), "0 of them: ");
  EXPECT_EQ(pbrt_world_warning(old_sky + "\"rgb L\" [ 3 3 3 ]"), "0 of them: ");
}

TEST(Errors_PbrtLightImages, WhatIsWrongWithThem) {
  EXPECT_EQ(pbrt_world_error("LightSource \"projection\""),
            "2:13: a projection without its file: expected \"string filename\"");
  EXPECT_EQ(pbrt_world_error("LightSource \"projection\" \"string filename\" \"picture.png\" "
                             "\"float fov\" 180"),
            "2:58: 'fov' is 180, expected degrees above 0 and below 180");
  EXPECT_EQ(pbrt_world_warning("LightSource \"goniometric\" \"string mapname\" \"picture.png\""),
            "2:27: 'mapname' is not a parameter of LightSource \"goniometric\" and is ignored");
  EXPECT_EQ(
      pbrt_world_warning("AreaLightSource \"diffuse\" \"rgb L\" [ 1 2 3 ] \"string filename\" "
                         "\"picture.png\" Shape \"disk\""),
      "2:27: 'L' is ignored: the image says what is emitted");
}

}  // namespace
}  // namespace candela
