// Materials of pbrt-v3 as the reader leaves them.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "renderer/description/validate.h"
#include "tests/scene_io/pbrt/pbrt_text.h"

namespace candela {
namespace {

using namespace description;
using test::pbrt_world;
using test::pbrt_world_warning;

const std::string textures = R"(
  Texture "board" "spectrum" "checkerboard"
  Texture "squares" "float" "checkerboard"
)";

// Of a disk that wears it; valid.
SceneDescription disk_of(const std::string& material) {
  SceneDescription scene = pbrt_world("LightSource \"point\"\n" + textures + "Material " +
                                      material + "\nShape \"disk\"");
  EXPECT_TRUE(validate(scene).list().empty()) << material;
  return scene;
}

template <class Model>
Model model_of(const SceneDescription& scene) {
  return std::get<Model>(scene.materials.at(scene.meshes.at(0).materials.at(0).index).model);
}

template <class Kind>
Kind texture_of(const SceneDescription& scene, TextureHandle handle) {
  return std::get<Kind>(scene.textures.at(handle.index).kind);
}

// A texture replaces a factor, so that both together are a product.
TEST(Unit_PbrtV3Materials, TranslucentOnesScaleTheirTextures) {
  const SceneDescription scene =
      disk_of(R"("translucent" "texture Kd" "board" "rgb reflect" [ .4 .4 .4 ])");
  const auto leaf = model_of<DiffuseTransmissionMaterial>(scene);
  const auto reflected = texture_of<ProductTexture>(scene, leaf.reflectance.texture);
  const auto transmitted = texture_of<ProductTexture>(scene, leaf.transmittance.texture);
  EXPECT_TRUE(reflected.first.texture);
  EXPECT_EQ(reflected.first.texture, transmitted.first.texture);
  EXPECT_EQ(reflected.second.factor, Vec3d(0.4));
  EXPECT_EQ(transmitted.second.factor, Vec3d(0.5));
  const auto even =
      model_of<DiffuseTransmissionMaterial>(disk_of(R"("translucent" "rgb Kd" [ .6 .4 .2 ])"));
  EXPECT_EQ(even.reflectance.factor, Vec3d(0.3, 0.2, 0.1));
}

TEST(Unit_PbrtV3Materials, TexturesOfRoughnessAreRemappedAsNumbersAre) {
  const SceneDescription scene = disk_of(R"("metal" "texture roughness" "squares")");
  const auto width =
      texture_of<ProductTexture>(scene, model_of<ConductorMaterial>(scene).roughness.texture);
  EXPECT_TRUE(texture_of<SquareRootTexture>(scene, width.first.texture).input.texture);
  for (const double roughness : {.001, .003, .01, .03, .1, .2, .3, .37}) {
    const auto metal = model_of<ConductorMaterial>(
        disk_of(fmt::format(R"("metal" "float roughness" {})", roughness)));
    const double by_texture = width.second.factor.x * std::sqrt(roughness);
    EXPECT_NEAR(by_texture / metal.roughness.factor, 1, 0.1) << roughness;
  }
  const SceneDescription plain =
      disk_of(R"("metal" "texture roughness" "squares" "bool remaproughness" false)");
  EXPECT_NO_THROW(
      texture_of<CheckerboardTexture>(plain, model_of<ConductorMaterial>(plain).roughness.texture));
}

TEST(Unit_PbrtV3Materials, MetalsAndGlassMayBeBrushed) {
  const auto metal = model_of<ConductorMaterial>(disk_of(
      R"("metal" "float uroughness" .05 "float vroughness" .2 "bool remaproughness" false)"));
  EXPECT_EQ(metal.roughness.factor, 0.05);
  EXPECT_EQ(metal.roughness_across.value().factor, 0.2);
  const auto even = model_of<DielectricMaterial>(
      disk_of(R"("glass" "float uroughness" .05 "float vroughness" .05)"));
  EXPECT_FALSE(even.roughness_across);
}

// Kd + Ks may be above 1 there: what is reflected straight on stays, and the sum is at most 1.
TEST(Unit_PbrtV3Materials, HighlightsGiveWayToWhatIsDiffuse) {
  const auto plastic = model_of<CookTorranceMaterial>(
      disk_of(R"("plastic" "rgb Kd" [ .8 .2 1 ] "rgb Ks" [ .5 .5 .5 ])"));
  EXPECT_EQ(plastic.diffuse.factor, Vec3d(0.8, 0.2, 1));
  EXPECT_NEAR(plastic.specular.factor.x, 0.2, 1e-12);
  EXPECT_EQ(plastic.specular.factor.y, 0.5);
  EXPECT_EQ(plastic.specular.factor.z, 0);
  EXPECT_NEAR(plastic.specular.factor.x * plastic.f0.x, 0.5 * 0.04, 1e-12);
  EXPECT_NEAR(plastic.f0.y, 0.04, 1e-12);
  const auto dark = model_of<CookTorranceMaterial>(disk_of(R"("plastic" "rgb Kd" [ .3 .3 .3 ])"));
  EXPECT_EQ(dark.fresnel, FresnelModel::Exact);
}

// As far as texels are no brighter than .8.
TEST(Unit_PbrtV3Materials, HighlightsGiveWayToTexturesToo) {
  const auto plastic = model_of<CookTorranceMaterial>(
      disk_of(R"("plastic" "texture Kd" "board" "rgb Ks" [ .5 .5 .5 ])"));
  EXPECT_NEAR(plastic.specular.factor.x, 0.2, 1e-12);
  EXPECT_NEAR(plastic.specular.factor.x * plastic.f0.x, 0.5 * 0.04, 1e-12);
  const auto substrate = model_of<CookTorranceMaterial>(
      disk_of(R"("substrate" "texture Kd" "board" "rgb Ks" [ .05 .05 .05 ])"));
  EXPECT_NEAR(substrate.specular.factor.x, 1 - 0.8 * 0.95, 1e-12);
  EXPECT_NEAR(substrate.specular.factor.x * substrate.f0.x, 0.05, 1e-12);
}

// Straight on Ks is reflected, and Kd (1 - Ks) is diffuse.
TEST(Unit_PbrtV3Materials, SubstratesReflectWhatTheyScatterLess) {
  const auto even = model_of<CookTorranceMaterial>(
      disk_of(R"("substrate" "rgb Kd" [ .5 .5 .5 ] "rgb Ks" [ .05 .05 .05 ])"));
  EXPECT_NEAR(even.diffuse.factor.x, 0.475, 1e-12);
  EXPECT_NEAR(even.specular.factor.x, 0.525, 1e-12);
  EXPECT_NEAR(even.specular.factor.x * even.f0.x, 0.05, 1e-12);
  const SceneDescription scene =
      disk_of(R"("substrate" "texture Kd" "board" "rgb Ks" [ .1 .1 .1 ])");
  const auto textured = model_of<CookTorranceMaterial>(scene);
  EXPECT_EQ(texture_of<ProductTexture>(scene, textured.diffuse.texture).second.factor, Vec3d(0.9));
}

TEST(Unit_PbrtV3Materials, SayNothingWhereNothingIsLost) {
  for (const char* material : {R"("plastic" "float roughness" .1 "float vroughness" .1)",
                               R"("uber" "float uroughness" .1 "float vroughness" .1)",
                               R"("translucent" "rgb Ks" [ 0 0 0 ] "float roughness" .1)"}) {
    const std::string said =
        pbrt_world_warning(std::string("Material ") + material + " Shape \"disk\"");
    EXPECT_TRUE(said.starts_with("2:10: ") && said.ends_with("the nearest model is used")) << said;
  }
}

// Beside the warning that they are of pbrt-v3.
TEST(Errors_PbrtV3Materials, SayWhatTheyLeaveOut) {
  const std::pair<std::string, std::string> cases[] = {
      {R"("glass" "texture Kt" "board")", "'Kt' must be a colour here, no texture: 1 is used"},
      {R"("substrate" "texture Ks" "board")",
       "'Ks' must be a colour here, no texture: 0.04 is used"},
      {R"("glass" "rgb Kr" [ .5 .5 .5 ])",
       "'Kr' is ignored: glass reflects as Fresnel's equations say"},
      {R"("plastic" "float vroughness" .2)",
       "'vroughness' is ignored: highlights are as wide along v as along u here"},
      {R"("translucent" "rgb Ks" [ .5 .5 .5 ])",
       "'Ks' is ignored: translucent materials are diffuse here"}};
  for (const auto& [material, warning] : cases) {
    const std::string said =
        pbrt_world_warning(textures + "Material " + material + "\nShape \"disk\"");
    EXPECT_NE(said.find(warning), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace candela
