// Materials of pbrt scenes as candela describes them.
#include <gtest/gtest.h>

#include "renderer/description/validate.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using namespace description;
using test::expect_near;
using test::pbrt_world;
using test::pbrt_world_error;
using test::pbrt_world_warning;

Material material_of(const std::string& text) {
  const auto scene = pbrt_world("Material " + text + " Shape \"disk\"");
  EXPECT_EQ(scene.materials.size(), 1u);
  EXPECT_FALSE(validate(scene).has_errors()) << text;
  return scene.materials.empty() ? Material{} : scene.materials[0];
}

TEST(Unit_PbrtMaterials, RoughnessIsSquaredUnlessItSaysNo) {
  const auto width = [](const std::string& parameters) {
    return std::get<ConductorMaterial>(material_of("\"conductor\" " + parameters).model);
  };
  EXPECT_EQ(width("").roughness.factor, 0);
  EXPECT_NEAR(width("\"float roughness\" .25").roughness.factor, 0.5, 1e-12);
  EXPECT_EQ(width("\"float roughness\" .25 \"bool remaproughness\" false").roughness.factor, 0.25);
  EXPECT_EQ(width("\"float roughness\" 5e-7").roughness.factor, 0);  // smooth, as pbrt takes it
  const auto two = width("\"float uroughness\" .01 \"float vroughness\" .04");
  EXPECT_NEAR(two.roughness.factor, 0.1, 1e-12);
  ASSERT_TRUE(two.roughness_across);
  EXPECT_NEAR(two.roughness_across->factor, 0.2, 1e-12);
}

TEST(Unit_PbrtMaterials, IndicesOfRefraction) {
  const auto model_of = [](const std::string& words) {
    return pbrt_world("Material " + words + " Shape \"disk\"").materials.at(0).model;
  };
  const auto glass = [&](const std::string& eta) {
    return std::get<description::DielectricMaterial>(model_of("\"dielectric\" " + eta)).ior;
  };
  EXPECT_EQ(glass(""), 1.5);
  EXPECT_EQ(glass("\"float eta\" 1.25"), 1.25);
  EXPECT_NEAR(glass("\"rgb eta\" [ 1.25 1.25 1.25 ]"), 1.25, 1e-6);
  const auto skin = model_of("\"subsurface\"");
  EXPECT_EQ(std::get<description::CoatedDiffuseMaterial>(skin).coat.ior, 1.33);
}

TEST(Unit_PbrtMaterials, RoughnessByATextureIsRemappedToo) {
  const auto width = [](const std::string& remaps) {
    const auto scene = pbrt_world(
        "Texture \"t\" \"float\" \"checkerboard\"\nMaterial \"conductor\" \"texture roughness\" "
        "\"t\" " +
        remaps + " Shape \"disk\"");
    EXPECT_FALSE(validate(scene).has_errors());
    const auto metal = std::get<ConductorMaterial>(scene.materials.at(0).model);
    EXPECT_FALSE(metal.roughness_across);
    return scene.textures.at(metal.roughness.texture.index).kind;
  };
  EXPECT_EQ(std::get<SquareRootTexture>(width("")).input.texture.index, 0u);
  EXPECT_TRUE(std::holds_alternative<CheckerboardTexture>(width("\"bool remaproughness\" false")));
}

TEST(Unit_PbrtMaterials, ScaledSheetsOfTextures) {
  const auto scene = pbrt_world(
      "Texture \"t\" \"spectrum\" \"checkerboard\"\nMaterial \"diffusetransmission\" \"texture "
      "reflectance\" \"t\" \"rgb transmittance\" [ .5 .5 .5 ] \"float scale\" .5 Shape \"disk\"");
  const auto& sheet = std::get<DiffuseTransmissionMaterial>(scene.materials.at(0).model);
  const auto& product =
      std::get<ProductTexture>(scene.textures.at(sheet.reflectance.texture.index).kind);
  EXPECT_EQ(product.first.texture.index, 0u);
  EXPECT_EQ(product.second.factor, Vec3d(0.5));
  EXPECT_EQ(sheet.transmittance.factor, Vec3d(0.25));
}

// As in pbrt: a texture may come to less than nothing, a number is a mistake.
TEST(Unit_PbrtMaterials, TexturesReflectAtLeastNothing) {
  const auto scene = pbrt_world(
      "Texture \"t\" \"spectrum\" \"scale\" \"rgb tex\" [ 3 .5 .25 ] \"float scale\" -1\n"
      "Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"disk\"");
  EXPECT_EQ(std::get<DiffuseMaterial>(scene.materials.at(0).model).reflectance.factor, Vec3d(0.0));
}

TEST(Unit_PbrtMaterials, HairIsOfItsColour) {
  for (const std::string name : {"reflectance", "color"})
    EXPECT_EQ(
        std::get<DiffuseMaterial>(material_of("\"hair\" \"rgb " + name + "\" [ .9 .1 .2 ]").model)
            .reflectance.factor,
        Vec3d(0.9, 0.1, 0.2));
}

TEST(Unit_PbrtMaterials, MetalsByTheirReflectance) {
  const auto metal = std::get<ConductorMaterial>(
      material_of("\"conductor\" \"rgb reflectance\" [ .9 .5 0 ]").model);
  const Vec3d below = metal.eta - 1.0;
  const Vec3d above = metal.eta + 1.0;
  const Vec3d k2 = metal.k * metal.k;
  expect_near((below * below + k2) / (above * above + k2), {0.9, 0.5, 0});
}

TEST(Unit_PbrtMaterials, MetalsOfATexture) {
  const auto scene = pbrt_world(
      "Texture \"t\" \"spectrum\" \"checkerboard\"\nMaterial \"conductor\" \"texture reflectance\" "
      "\"t\" \"float roughness\" .01 Shape \"disk\"");
  const auto& metal = std::get<ConductorMaterial>(scene.materials.at(0).model);
  ASSERT_TRUE(metal.reflectance);
  EXPECT_EQ(metal.reflectance->texture.index, 0u);
  EXPECT_NEAR(metal.roughness.factor, 0.1, 1e-12);
}

TEST(Unit_PbrtMaterials, Types) {
  const auto coated = std::get<CoatedDiffuseMaterial>(
      material_of(
          "\"coateddiffuse\" \"float roughness\" .04 \"float eta\" 1.3 \"integer maxdepth\" 4")
          .model);
  EXPECT_EQ(coated.coat.ior, 1.3);
  EXPECT_NEAR(coated.coat.roughness.factor, 0.2, 1e-12);
  EXPECT_EQ(coated.coat.max_depth, 4);
  EXPECT_EQ(coated.coat.thickness, 0.01);
  const auto metal = std::get<CoatedConductorMaterial>(
      material_of(
          "\"coatedconductor\" \"float interface.roughness\" .01 \"float conductor.roughness\" "
          ".09 \"rgb conductor.eta\" [ 1 2 3 ]")
          .model);
  EXPECT_NEAR(metal.coat.roughness.factor, 0.1, 1e-12);
  EXPECT_NEAR(metal.roughness.factor, 0.3, 1e-12);
  EXPECT_EQ(metal.eta, Vec3d(1, 2, 3));
  EXPECT_EQ(std::get<DielectricMaterial>(
                material_of("\"dielectric\" \"spectrum eta\" \"glass-SF11\"").model)
                .ior,
            1.78472);
  EXPECT_TRUE(std::get<DielectricMaterial>(material_of("\"thindielectric\"").model).is_thin);
  EXPECT_TRUE(std::holds_alternative<InterfaceMaterial>(material_of("\"interface\"").model));
  const auto leaf = std::get<DiffuseTransmissionMaterial>(
      material_of(
          "\"diffusetransmission\" \"rgb reflectance\" [ 1 .5 0 ] \"rgb transmittance\" [ 1 0 0 ]")
          .model);
  EXPECT_EQ(leaf.reflectance.factor, Vec3d(0.5, 0.5, 0));
  const auto scaled = std::get<DiffuseTransmissionMaterial>(
      material_of("\"diffusetransmission\" \"rgb reflectance\" [ .25 .5 0 ] \"rgb transmittance\" "
                  "[ .25 0 .125 ] \"float scale\" 2")
          .model);
  EXPECT_EQ(scaled.reflectance.factor, Vec3d(0.5, 1, 0));
  EXPECT_EQ(scaled.transmittance.factor, Vec3d(0.5, 0, 0.25));
  EXPECT_TRUE(std::holds_alternative<DiffuseMaterial>(material_of("\"matte\"").model));
  EXPECT_TRUE(std::holds_alternative<CookTorranceMaterial>(material_of("\"plastic\"").model));
  EXPECT_TRUE(std::holds_alternative<MirrorMaterial>(material_of("\"mirror\"").model));
}

TEST(Unit_PbrtMaterials, MaterialsAndTexturesMayFollow) {
  const auto scene = pbrt_world(R"(NamedMaterial "later"
    Shape "disk"
    MakeNamedMaterial "later" "string type" "diffuse" "texture reflectance" "last"
    Texture "last" "spectrum" "scale" "rgb tex" [ .5 .25 .125 ] "float scale" .5)");
  EXPECT_EQ(std::get<DiffuseMaterial>(scene.materials.at(0).model).reflectance.factor,
            Vec3d(0.25, 0.125, 0.0625));
}

TEST(Unit_PbrtMaterials, HeightsAreLengthsInTheWorld) {
  const auto scene = pbrt_world(R"(
    Texture "h" "float" "imagemap" "string filename" "picture.png" "float scale" -3.5
    Material "diffuse" "texture displacement" "h"
    Shape "disk" Scale 3 3 3 Shape "disk")");
  ASSERT_EQ(scene.materials.size(), 1u);  // of whatever size their shapes are
  EXPECT_TRUE(scene.materials[0].height_texture.is_valid());
  EXPECT_TRUE(scene.materials[0].heights_are_lengths);
  EXPECT_EQ(scene.materials[0].height_scale, 1);
  EXPECT_FALSE(description::validate(scene).has_errors());
}

TEST(Errors_PbrtMaterials, SheetsThatMakeLight) {
  const std::string sheet = "Material \"diffusetransmission\" \"rgb reflectance\" [ .8 .8 .8 ] ";
  EXPECT_NE(pbrt_world_warning(sheet + "\"rgb transmittance\" [ .8 .8 .8 ] Shape \"disk\"")
                .find("more light than it gets"),
            std::string::npos);
  EXPECT_EQ(pbrt_world_warning(sheet + "\"rgb transmittance\" [ .2 .2 .2 ] Shape \"disk\""),
            "0 of them: ");
}

// pbrt looks at the one or the other.
TEST(Errors_PbrtMaterials, HeightsBesideAMapOfNormals) {
  const std::string both =
      "Texture \"h\" \"float\" \"checkerboard\" Material \"diffuse\" "
      "\"string normalmap\" \"picture.png\" \"texture displacement\" \"h\" Shape \"disk\"";
  EXPECT_EQ(pbrt_world_warning(both),
            "2:88: 'displacement' is ignored: the material has a normalmap");
  const auto scene = pbrt_world(both);
  EXPECT_TRUE(scene.materials.at(0).normal_map.is_valid());
  EXPECT_FALSE(scene.materials.at(0).height_texture.is_valid());
}

TEST(Errors_PbrtMaterials, WhatIsIgnored) {
  EXPECT_EQ(pbrt_world_warning("Material \"diffuse\" \"float sigma\" 20"),
            "2:20: 'sigma' is ignored: diffuse surfaces are Lambert's");
  EXPECT_EQ(pbrt_world_warning("Material \"diffuse\" \"float sigma\" 0"), "0 of them: ");
  EXPECT_EQ(pbrt_world_warning("Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ] "
                               "\"vector3 S\" [ 1 0 0  1 0 0  1 0 0 ]"),
            "2:57: 'S' is ignored: tangents are those of the texture coordinates");
}

TEST(Errors_PbrtMaterials, NumbersOutOfTheirRange) {
  const auto warning = [](const std::string& parameters) {
    return pbrt_world_warning("Material " + parameters);
  };
  EXPECT_EQ(warning("\"conductor\" \"float roughness\" -2"),
            "2:22: 'roughness' is -2, expected 0 to 1: 0 is used");
  EXPECT_EQ(warning("\"conductor\" \"float uroughness\" 3"),
            "2:22: 'uroughness' is 3, expected 0 to 1: 1 is used");
  EXPECT_EQ(warning("\"coateddiffuse\" \"float thickness\" -1"),
            "2:26: 'thickness' is -1, expected at least 0: 0 is used");
  EXPECT_EQ(warning("\"coateddiffuse\" \"integer maxdepth\" -1"),
            "2:26: 'maxdepth' is -1, expected 1 to 1000: 1 is used");
  EXPECT_EQ(warning("\"diffuse\" Shape \"disk\" \"float alpha\" -1"),
            "2:33: 'alpha' is -1, expected 0 to 1: 0 is used");
  EXPECT_EQ(warning("\"diffuse\" Shape \"loopsubdiv\" \"integer levels\" -3 \"integer indices\" "
                    "[ 0 1 2 ] \"point3 P\" [ 0 0 0 1 0 0 0 1 0 ]"),
            "2:39: 'levels' is -3, expected at least 0: 0 is used");
}

// In the space of their own directive.
TEST(Errors_PbrtMaterials, WhatIsWrongWithThem) {
  EXPECT_EQ(pbrt_world_error("MakeNamedMaterial \"a\" \"rgb reflectance\" [ 1 1 1 ]"),
            "2:19: the material 'a' has no type: expected \"string type\"");
  EXPECT_EQ(pbrt_world_error("Material \"difuse\""),
            "2:10: 'difuse' is no material, did you mean 'diffuse'?");
  EXPECT_EQ(pbrt_world_warning("Material \"diffuse\" \"rgb reflectance\" [ 2 1 1 ]"),
            "2:20: 'reflectance' is above 1: surfaces reflect at most all light");
  EXPECT_EQ(
      pbrt_world_warning("Material \"diffuse\" \"rgb reflectence\" [ 1 1 1 ]"),
      "2:20: 'reflectence' is not a parameter of Material \"diffuse\" and is ignored, did you "
      "mean 'reflectance'?");
}

}  // namespace
}  // namespace candela
