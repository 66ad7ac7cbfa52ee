// Mixtures of materials as the reader leaves them.
#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/description/validate.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using namespace description;
using test::pbrt_world;
using test::pbrt_world_error;
using test::pbrt_world_warning;

const std::string parts = R"(
  MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [ .5 0 0 ]
  MakeNamedMaterial "glass" "string type" "dielectric"
  MakeNamedMaterial "nothing" "string type" "interface"
  Texture "squares" "float" "checkerboard"
)";

SceneDescription disk_of(const std::string& materials) {
  SceneDescription scene = pbrt_world(parts + materials + "\nShape \"disk\"");
  EXPECT_FALSE(validate(scene).has_errors());
  return scene;
}

std::string mix_of(const std::string& first, const std::string& second,
                   const std::string& amount = "") {
  return "Material \"mix\" \"string materials\" [ \"" + first + "\" \"" + second + "\" ] " + amount;
}

const Material& worn_by_disk(const SceneDescription& scene) {
  return scene.materials.at(scene.meshes.at(0).materials.at(0).index);
}

TEST(Unit_PbrtMixtures, PartsStandBeforeThem) {
  const SceneDescription scene = disk_of(mix_of("red", "glass", "\"texture amount\" \"squares\""));
  ASSERT_EQ(scene.materials.size(), 3u);
  const auto& mix = std::get<MixMaterial>(worn_by_disk(scene).model);
  EXPECT_EQ(scene.materials.at(mix.first.index).name, "red");
  EXPECT_EQ(scene.materials.at(mix.second.index).name, "glass");
  EXPECT_EQ(mix.amount.texture.index, 0u);
  EXPECT_EQ(
      std::get<MixMaterial>(worn_by_disk(disk_of(mix_of("red", "glass"))).model).amount.factor,
      0.5);
}

TEST(Unit_PbrtMixtures, OfMixtures) {
  const SceneDescription scene =
      disk_of("MakeNamedMaterial \"both\" \"string type\" " + mix_of("red", "glass").substr(9) +
              mix_of("both", "red", "\"float amount\" .25"));
  const auto& outer = std::get<MixMaterial>(worn_by_disk(scene).model);
  EXPECT_EQ(outer.amount.factor, 0.25);
  const auto& inner = std::get<MixMaterial>(scene.materials.at(outer.first.index).model);
  EXPECT_EQ(inner.first, outer.second);  // red is there once
  EXPECT_EQ(scene.materials.size(), 4u);
}

TEST(Unit_PbrtMixtures, OfOnePartAreThatPart) {
  for (const std::string& text :
       {mix_of("red", "glass", "\"float amount\" 0"), mix_of("glass", "red", "\"float amount\" 1"),
        mix_of("red", "red")})
    EXPECT_TRUE(std::holds_alternative<DiffuseMaterial>(worn_by_disk(disk_of(text)).model)) << text;
}

// pbrt-v3's amount is that of the first.
TEST(Unit_PbrtMixtures, OfTheThirdVersion) {
  const SceneDescription scene = disk_of(
      "Material \"mix\" \"string namedmaterial1\" \"red\" \"string namedmaterial2\" "
      "\"glass\" \"rgb amount\" [ .1 .2 .3 ]");
  const auto& mix = std::get<MixMaterial>(worn_by_disk(scene).model);
  EXPECT_EQ(scene.materials.at(mix.second.index).name, "red");
  EXPECT_NEAR(mix.amount.factor, 0.2, 1e-12);
}

// Meshes that have none get pbrt's.
TEST(Unit_PbrtMixtures, OfTheThirdVersionLookAtCoordinates) {
  const SceneDescription scene = pbrt_world(
      parts +
      "Texture \"board\" \"spectrum\" \"checkerboard\"\n"
      "MakeNamedMaterial \"board\" \"string type\" \"diffuse\" \"texture reflectance\" \"board\"\n"
      "Material \"mix\" \"string namedmaterial1\" \"red\" \"string namedmaterial2\" \"board\"\n"
      "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ]");
  EXPECT_EQ(scene.meshes.at(0).uvs.size(), 3u);
}

TEST(Unit_PbrtMixtures, WithAnInterfaceHaveHoles) {
  const SceneDescription first = disk_of(mix_of("nothing", "red", "\"float amount\" .3"));
  EXPECT_TRUE(std::holds_alternative<DiffuseMaterial>(worn_by_disk(first).model));
  EXPECT_EQ(worn_by_disk(first).opacity.factor, 0.3);
  EXPECT_NEAR(worn_by_disk(disk_of(mix_of("red", "nothing", "\"float amount\" .3"))).opacity.factor,
              0.7, 1e-12);
  const SceneDescription textured =
      disk_of(mix_of("red", "nothing", "\"texture amount\" \"squares\""));
  const ScalarInput& opacity = worn_by_disk(textured).opacity;
  const auto& complement = std::get<MixTexture>(textured.textures.at(opacity.texture.index).kind);
  EXPECT_EQ(complement.first.factor, Vec3d(1.0));
  EXPECT_EQ(complement.second.factor, Vec3d(0.0));
  EXPECT_EQ(complement.amount.texture.index, 0u);
  // With the shape's own alpha.
  const SceneDescription thin = pbrt_world(parts + mix_of("nothing", "red", "\"float amount\" .5") +
                                           " Shape \"disk\" \"float alpha\" .5");
  EXPECT_EQ(worn_by_disk(thin).opacity.factor, 0.25);
}

// Media are the shape's, whatever parts its mixture has.
TEST(Unit_PbrtMixtures, BoundTheShapesMedium) {
  const SceneDescription scene = pbrt_world(
      parts +
      "MakeNamedMedium \"green\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [ 1 2 3 ] "
      "\"rgb sigma_s\" [ 0 0 0 ]\n" +
      mix_of("red", "glass") + "\nMediumInterface \"green\" \"\"\nShape \"disk\"");
  EXPECT_EQ(worn_by_disk(scene).media.inside, MediumHandle(0));
  EXPECT_FALSE(worn_by_disk(scene).media.outside);
}

TEST(Errors_PbrtMixtures, WhatIsWrongWithThem) {
  EXPECT_EQ(pbrt_world_warning(parts + mix_of("red", "glass", "\"float amount\" -2")),
            "7:53: 'amount' is -2, expected 0 to 1: 0 is used");
  EXPECT_EQ(pbrt_world_warning("MakeNamedMaterial \"red\" \"string type\" \"diffuse\" "
                               "MakeNamedMaterial \"nothing\" \"string type\" \"interface\"\n" +
                               mix_of("red", "nothing", "\"float amount\" .5") +
                               " Texture \"t\" \"float\" \"checkerboard\" "
                               "Shape \"disk\" \"texture alpha\" \"t\""),
            "3:114: the alpha of shapes whose mixture has an interface is ignored");
  EXPECT_EQ(pbrt_world_error("Material \"mix\" \"float amount\" .5"),
            "2:10: a mix without its two materials: expected \"string materials\"");
  EXPECT_EQ(pbrt_world_error("MakeNamedMaterial \"red\" \"string type\" \"diffuse\" " +
                             mix_of("red", "rde")),
            "2:64: there is no material 'rde', did you mean 'red'?");
  EXPECT_EQ(
      pbrt_world_error("MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string materials\" [ "
                       "\"n\" \"n\" ] MakeNamedMaterial \"n\" \"string type\" \"mix\" \"string "
                       "materials\" [ \"m\" \"m\" ]"),
      "2:92: mixtures of mixtures more than 16 deep, or of themselves");
}

std::string named_mix(const std::string& name, const std::string& first,
                      const std::string& second) {
  return "MakeNamedMaterial \"" + name + "\" \"string type\" " + mix_of(first, second).substr(9) +
         "\n";
}

// Worn by a shape or not.
TEST(Errors_PbrtMixtures, OfThemselves) {
  const std::string red = "MakeNamedMaterial \"red\" \"string type\" \"diffuse\"\n";
  const std::string itself = red + named_mix("m", "red", "m");
  const std::string each_other = red + named_mix("m", "red", "n") + named_mix("n", "red", "m");
  const std::string old = red +
                          "MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string "
                          "namedmaterial1\" \"red\" \"string namedmaterial2\" \"m\"\n";
  for (const std::string& materials : {itself, each_other, old})
    for (const char* shape :
         {"", "NamedMaterial \"m\" Shape \"disk\"", "NamedMaterial \"red\" Shape \"disk\""})
      EXPECT_NE(pbrt_world_error(materials + shape).find("deep, or of themselves"),
                std::string::npos)
          << materials << shape;
}

// In whatever order they are written.
TEST(Errors_PbrtMixtures, OfTooManyMixtures) {
  const auto chain = [](std::size_t length, bool parts_come_first) {
    std::vector<std::string> mixtures;
    for (std::size_t i = 1; i <= length; ++i)
      mixtures.push_back(named_mix("m" + std::to_string(i), "m" + std::to_string(i - 1), "red"));
    if (!parts_come_first) std::reverse(mixtures.begin(), mixtures.end());
    std::string text =
        "MakeNamedMaterial \"m0\" \"string type\" \"diffuse\" "
        "MakeNamedMaterial \"red\" \"string type\" \"diffuse\"\n";
    for (const std::string& mixture : mixtures) text += mixture;
    return text + "NamedMaterial \"m" + std::to_string(length) + "\" Shape \"disk\"";
  };
  for (const bool parts_come_first : {true, false}) {
    EXPECT_EQ(pbrt_world(chain(16, parts_come_first)).materials.size(), 18u);
    EXPECT_NE(pbrt_world_error(chain(17, parts_come_first)).find("more than 16 deep"),
              std::string::npos);
  }
}

TEST(Errors_Validate, MixturesOfWhatIsNotThere) {
  SceneDescription scene = disk_of(mix_of("red", "glass"));
  auto& mix = std::get<MixMaterial>(scene.materials.back().model);
  mix.first = MaterialHandle(scene.materials.size() - 1);  // itself
  EXPECT_TRUE(validate(scene).has_errors());
  mix.first = MaterialHandle(std::size_t{0});
  EXPECT_FALSE(validate(scene).has_errors());
  scene.materials[0].model = InterfaceMaterial{};
  EXPECT_TRUE(validate(scene).has_errors());
}

// Rays through holes keep their medium, as those that miss a shape by its alpha do.
TEST(Errors_PbrtMixtures, InterfacesBetweenMediaHaveNoHoles) {
  const std::string media =
      "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" MediumInterface \"fog\" \"\"\n";
  EXPECT_EQ(
      pbrt_world_warning(parts + media + mix_of("nothing", "glass") + "\nShape \"disk\""),
      "9:7: an interface in a mixture between media lets rays through, but they stay in their "
      "medium, which pbrt's leave");
  const std::string disk =
      parts + media + "NamedMaterial \"nothing\"\nShape \"disk\" \"float alpha\" ";
  EXPECT_EQ(pbrt_world_warning(disk + ".5"),
            "9:7: the alpha of an interface between media is ignored");
  // What is not there bounds nothing.
  const SceneDescription absent = pbrt_world(disk + "0");
  EXPECT_FALSE(worn_by_disk(absent).media.inside);
  EXPECT_TRUE(worn_by_disk(pbrt_world(disk + "1")).media.inside);
}

}  // namespace
}  // namespace candela
