// Lights of pbrt scenes as candela describes them.
#include <cmath>

#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "renderer/math/colour.h"
#include "renderer/math/constants.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using namespace description;
using test::expect_near;
using test::pbrt_world;
using test::pbrt_world_error;
using test::pbrt_world_warning;

TEST(Unit_PbrtLights, PlacesAndDirections) {
  const auto scene = pbrt_world(R"(Translate 0 0 10
    Rotate 90 1 0 0
    LightSource "point" "point3 from" [ 0 1 0 ] "float power" 100
    LightSource "distant" "point3 from" [ 0 5 0 ] "point3 to" [ 0 0 0 ] "float illuminance" 3
    LightSource "spot" "point3 to" [ 0 1 0 ] "float coneangle" 40 "float conedeltaangle" 10)");
  const auto& point = std::get<PointLight>(scene.lights.at(0).kind);
  expect_near(point.position, {0, 0, 11});
  expect_near(point.intensity, Vec3d(100 / (4 * pi_double)));
  const auto& distant = std::get<DirectionalLight>(scene.lights.at(1).kind);
  expect_near(distant.to_light, {0, 0, 1});
  expect_near(distant.irradiance, Vec3d(3.0));
  const auto& spot = std::get<SpotLight>(scene.lights.at(2).kind);
  expect_near(spot.axis, {0, 0, 1});
  EXPECT_NEAR(spot.inner_angle_radians, 30 * pi_double / 180, 1e-12);
  EXPECT_NEAR(spot.outer_angle_radians, 40 * pi_double / 180, 1e-12);
}

// The cosine of the negative angle where pbrt's fall would begin is that of the angle.
TEST(Unit_PbrtLights, ConesThatFallFromBeyondTheirAxis) {
  const auto scene = pbrt_world(
      "LightSource \"spot\" \"float coneangle\" 20 \"float conedeltaangle\" 35\n"
      "LightSource \"spot\" \"float coneangle\" 20 \"float conedeltaangle\" 50");
  const auto inner = [&](std::size_t i) {
    return std::get<SpotLight>(scene.lights.at(i).kind).inner_angle_radians * 180 / pi_double;
  };
  EXPECT_NEAR(inner(0), 15, 1e-12);
  EXPECT_NEAR(inner(1), 20, 1e-12);
}

// Each of the file's skies is one of the description; compile() adds them up.
TEST(Unit_PbrtLights, SkiesAreKeptApart) {
  const auto plain = pbrt_world(
      "LightSource \"infinite\" \"rgb L\" [ 1 2 3 ]\nLightSource \"infinite\" \"rgb L\" [ 1 1 1 ]");
  ASSERT_EQ(plain.lights.size(), 2u);
  expect_near(std::get<ConstantEnvironment>(plain.lights[0].kind).radiance, {1, 2, 3});
  expect_near(std::get<ConstantEnvironment>(plain.lights[1].kind).radiance, Vec3d(1.0));
  const auto turned = pbrt_world(
      "Rotate 90 0 0 1\nLightSource \"infinite\" \"string filename\" \"picture.exr\" \"float "
      "scale\" 2");
  const auto& map = std::get<EqualAreaEnvironment>(turned.lights.at(0).kind);
  expect_near(map.world_from_map[0], {0, 1, 0});
  expect_near(map.world_from_map[2], {0, 0, 1});
  EXPECT_EQ(map.scale, Vec3d(2.0));
  EXPECT_EQ(turned.images.at(0).encoding, Encoding::Linear);
}

// pbrt samples them though no ray meets them.
TEST(Unit_PbrtLights, ConesWithoutAnInsideGiveNothing) {
  const auto scene = pbrt_world("LightSource \"spot\" \"float coneangle\" 0 \"float power\" 100");
  expect_near(std::get<SpotLight>(scene.lights.at(0).kind).intensity, Vec3d(0.0));
}

TEST(Errors_PbrtLights, BrightnessBelowZero) {
  EXPECT_EQ(pbrt_world_error("LightSource \"point\" \"float scale\" -1"),
            "2:21: 'scale' is -1, expected at least 0");
  EXPECT_EQ(pbrt_world_error("AreaLightSource \"diffuse\" \"float scale\" -2 Shape \"disk\""),
            "2:27: 'scale' is -2, expected at least 0");
  EXPECT_EQ(pbrt_world_warning("LightSource \"point\" \"float power\" 0"),
            "2:21: 'power' is 0, expected above 0: it is ignored");
  EXPECT_EQ(pbrt_world_warning("LightSource \"point\" \"float power\" -1 Shape \"disk\""),
            "0 of them: ");
  EXPECT_EQ(pbrt_world_warning("AreaLightSource \"diffuse\" \"float power\" -2 Shape \"disk\""),
            "2:27: 'power' is -2, expected above 0: it is ignored");
}

TEST(Errors_PbrtLights, InvisibleLampsAreNamed) {
  EXPECT_EQ(
      pbrt_world_warning("AreaLightSource \"diffuse\" Shape \"disk\" \"float alpha\" 0 "
                         "Shape \"sphere\" \"float alpha\" 0"),
      "2:33: lamps of an \"alpha\" of 0, which pbrt samples though no ray meets them, are not "
      "supported: it is left out");
}

TEST(Unit_PbrtLights, AnEmptyTypeEndsAnAreaLight) {
  const auto scene = pbrt_world(R"(AreaLightSource "diffuse" Shape "disk"
                                   AreaLightSource "" Shape "sphere")");
  ASSERT_EQ(scene.instances.size(), 2u);
  const auto emission_of = [&](std::size_t i) {
    const auto& mesh = scene.meshes.at(scene.instances[i].mesh.index);
    return scene.materials.at(mesh.materials.at(0).index).emission;
  };
  EXPECT_EQ(emission_of(0), Vec3d(1.0));
  EXPECT_EQ(emission_of(1), Vec3d(0.0));
}

// 2 pi r^2 of a disk: pbrt gives each of a mesh's triangles the whole power.
TEST(Unit_PbrtLights, AreaLightsOfAPower) {
  const std::string disk = "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  2 0 0  0 2 0 ]";
  const auto emission = [&](const std::string& parameters) {
    const auto scene = pbrt_world("AreaLightSource \"diffuse\" " + parameters + disk);
    return scene.materials.at(0).emission;
  };
  expect_near(emission("\"rgb L\" [ 1 2 3 ] \"float scale\" 2 "), {2, 4, 6});
  expect_near(emission("\"float power\" 10 "), Vec3d(10 / (2 * pi_double)));
  expect_near(emission("\"float power\" 10 \"bool twosided\" true "), Vec3d(10 / (4 * pi_double)));
}

// pbrt's have a radiance each then.
TEST(Errors_PbrtLights, PowersOfUnequalTriangles) {
  const auto warning = [](const std::string& points) {
    return pbrt_world_warning(
        "AreaLightSource \"diffuse\" \"float power\" 10 Shape \"trianglemesh\" \"point3 P\" [ " +
        points + " ] \"integer indices\" [ 0 1 2  0 2 3 ]");
  };
  EXPECT_EQ(warning("0 0 0  2 0 0  2 2 0  0 3 0"),
            "2:50: the power of a lamp is that of each of its triangles or patches, which differ "
            "in area: all shine alike here, with as much power in all");
  EXPECT_EQ(warning("0 0 0  2 0 0  2 2 0  0 2 0"), "0 of them: ");
  EXPECT_EQ(
      pbrt_world_warning("AreaLightSource \"diffuse\" \"float power\" 10 Shape \"cylinder\" "
                         "Shape \"bilinearmesh\" \"point3 P\" [ 0 0 0  2 0 0  0 3 0  2 2 0 ]"),
      "0 of them: ");
}

// Of curved shapes it is the whole's, whatever they are made of here: 4 pi^2 r^2, 2 pi^2 r h.
TEST(Unit_PbrtLights, CurvedShapesOfAPower) {
  const auto emission = [&](const std::string& shape) {
    const auto scene = pbrt_world("AreaLightSource \"diffuse\" \"float power\" 10 " + shape);
    return scene.materials.at(0).emission;
  };
  const Vec3d whole(10 / (4 * pi_double * pi_double * 9));
  expect_near(emission("Scale 3 3 3 Shape \"sphere\""), whole);
  expect_near(emission("Shape \"sphere\" \"float radius\" 3 \"float zmin\" 0"), 2.0 * whole);
  expect_near(emission("Shape \"cylinder\" \"float radius\" 3"),
              Vec3d(10 / (2 * pi_double * pi_double * 3 * 2)));
}

// A patch is one light, of however many triangles it is made here.
TEST(Unit_PbrtLights, PatchesOfAPower) {
  const auto emission = [&](const std::string& rest) {
    const auto scene = pbrt_world(
        "AreaLightSource \"diffuse\" \"float power\" 100 \"bool twosided\" true "
        "Shape \"bilinearmesh\" \"point3 P\" [ -2 -2 0  2 -2 0  -2 2 0  2 2 " +
        rest);
    return scene.materials.at(0).emission;
  };
  const Vec3d one(100 / (2 * pi_double * 16));
  expect_near(emission("0 ]"), one);
  EXPECT_NEAR(emission("0.01 ]").x, one.x, 1e-5);
  expect_near(emission("0  2 6 0 -2 6 0 ] \"integer indices\" [ 0 1 2 3  2 3 5 4 ]"), one);
  const auto quad = pbrt_world(
      "AreaLightSource \"diffuse\" \"float power\" 100 \"bool twosided\" true "
      "Shape \"plymesh\" \"string filename\" \"quad.ply\"");
  expect_near(quad.materials.at(0).emission, one);
}

TEST(Unit_PbrtLights, ShapesOfOneMaterialAndLightShareIt) {
  const auto scene = pbrt_world(R"(Material "diffuse"
    Shape "disk"
    AreaLightSource "diffuse" "rgb L" [ 1 1 1 ]
    Shape "sphere"
    Shape "cylinder"
    AreaLightSource "diffuse" "rgb L" [ 2 1 1 ]
    Shape "sphere" "float radius" 2)");
  EXPECT_EQ(scene.materials.size(), 3u);
}

}  // namespace
}  // namespace candela
