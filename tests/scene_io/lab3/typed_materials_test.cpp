// Materials with a Type: the extension.
#include <gtest/gtest.h>

#include "renderer/math/reflectance.h"
#include "scene_io/lab3/metals.h"
#include "tests/scene_io/lab3/lab3_text.h"

namespace candela {
namespace {

using namespace description;
using test::error_in;
using test::said;
using test::scene_of;
using test::warning_in;

std::string materials(std::string_view keys) {
  return fmt::format("Materials:\n  - {{Name: m, {}}}\n", keys);
}

template <class Model>
Model model_of(std::string_view keys) {
  const SceneDescription scene = scene_of(materials(keys));
  if (scene.materials.size() != 1 || !std::holds_alternative<Model>(scene.materials[0].model)) {
    ADD_FAILURE() << "not one such material: " << keys;
    return {};
  }
  return std::get<Model>(scene.materials[0].model);
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance = 1e-12) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance);
}

TEST(Unit_TypedMaterials, CookTorrance) {
  const auto material = model_of<CookTorranceMaterial>(
      "Type: cook_torrance, kd: .2, ks: [.8, .7, .6], roughness: .3, F0: [.56, .57, .58], fresnel: "
      "schlick, geometry: smith");
  EXPECT_EQ(material.diffuse.factor, Vec3d(0.2));
  EXPECT_EQ(material.specular.factor, Vec3d(0.8, 0.7, 0.6));
  EXPECT_EQ(material.roughness.factor, 0.3);
  EXPECT_EQ(material.f0, Vec3d(0.56, 0.57, 0.58));
  EXPECT_EQ(material.fresnel, FresnelModel::Schlick);
  EXPECT_EQ(material.geometry, GeometryModel::Smith);
  EXPECT_FALSE(material.ior);
  EXPECT_FALSE(material.eta_k);
}

TEST(Unit_TypedMaterials, CookTorranceDefaults) {
  const auto material = model_of<CookTorranceMaterial>("Type: cook_torrance");
  EXPECT_EQ(material.diffuse.factor, Vec3d(0.5));
  EXPECT_EQ(material.specular.factor, Vec3d(0.5));
  EXPECT_EQ(material.roughness.factor, 0.3);
  EXPECT_EQ(material.f0, Vec3d(0.04));
  EXPECT_EQ(material.fresnel, FresnelModel::Schlick);
  EXPECT_EQ(material.geometry, GeometryModel::SchlickGgx);
}

TEST(Unit_TypedMaterials, ReflectanceFromRefractiveIndices) {
  const auto glass =
      model_of<CookTorranceMaterial>("Type: cook_torrance, ior: 1.5, fresnel: exact");
  EXPECT_EQ(glass.fresnel, FresnelModel::Exact);
  EXPECT_EQ(glass.ior, 1.5);
  expect_near(glass.f0, Vec3d(0.04));
  const auto metal =
      model_of<CookTorranceMaterial>("Type: cook_torrance, eta: [1, 2, 3], k: 2, fresnel: exact");
  ASSERT_TRUE(metal.eta_k);
  EXPECT_EQ((*metal.eta_k)[0], Vec3d(1, 2, 3));
  EXPECT_EQ((*metal.eta_k)[1], Vec3d(2));
  expect_near(metal.f0, Vec3d(4.0 / 8, 5.0 / 13, 8.0 / 20));
}

TEST(Unit_TypedMaterials, CaseAndUnderscoresDoNotMatter) {
  const auto material =
      model_of<CookTorranceMaterial>("type: CookTorrance, Kd: .25, KS: .5, Roughness: .125");
  EXPECT_EQ(material.diffuse.factor, Vec3d(0.25));
  EXPECT_EQ(material.specular.factor, Vec3d(0.5));
  EXPECT_EQ(material.roughness.factor, 0.125);
}

TEST(Unit_TypedMaterials, AliasesOfColours) {
  for (const char* key : {"kd", "Diffuse", "Albedo", "BaseColor"})
    EXPECT_EQ(
        model_of<DiffuseMaterial>(fmt::format("Type: diffuse, {}: .25", key)).reflectance.factor,
        Vec3d(0.25));
  EXPECT_EQ(model_of<CookTorranceMaterial>("Type: cook_torrance, Specular: .25").specular.factor,
            Vec3d(0.25));
  EXPECT_EQ(model_of<MirrorMaterial>("Type: mirror, Reflectance: .25").reflectance.factor,
            Vec3d(0.25));
  EXPECT_EQ(model_of<MirrorMaterial>("Type: mirror, kd: .25").reflectance.factor, Vec3d(0.25));
  EXPECT_EQ(model_of<MirrorMaterial>("Type: mirror").reflectance.factor, Vec3d(1));
  EXPECT_EQ(model_of<DiffuseMaterial>("Type: diffuse").reflectance.factor, Vec3d(0.5));
  EXPECT_EQ(warning_in(materials("Type: diffuse, kd: .5, Albedo: .25")),
            "2:30: kd is overridden by Albedo");
}

TEST(Unit_TypedMaterials, ColourMapsAreDecodedByTheirKind) {
  for (const auto& [file, encoding] :
       {std::pair("picture.png", Encoding::Srgb), std::pair("sky.hdr", Encoding::Linear),
        std::pair("sky.exr", Encoding::Linear)}) {
    const auto scene = scene_of(materials(fmt::format("Type: diffuse, kd_map: {}", file)));
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_EQ(scene.images[0].encoding, encoding) << file;
  }
  for (const char* key : {"kd_map", "DiffuseMap", "AlbedoMap", "BaseColorMap", "reflectance_map"})
    EXPECT_TRUE(
        model_of<MirrorMaterial>(fmt::format("Type: mirror, {}: picture.png", key)).reflectance.map)
        << key;
  for (const char* key : {"ks_map", "SpecularMap"})
    EXPECT_TRUE(
        model_of<CookTorranceMaterial>(fmt::format("Type: cook_torrance, {}: picture.png", key))
            .specular.map)
        << key;
  EXPECT_EQ(warning_in(materials("Type: diffuse, kd: .5, kd_map: picture.png")),
            "2:30: kd is not used: kd_map replaces it");
}

TEST(Unit_TypedMaterials, OtherMapsAreLinear) {
  const auto scene =
      scene_of(materials("Type: cook_torrance, roughness_map: picture.png, opacity_map: other.png, "
                         "normal_map: rt.png"));
  ASSERT_EQ(scene.images.size(), 3u);
  for (const Image& image : scene.images) EXPECT_EQ(image.encoding, Encoding::Linear);
  const Material& material = scene.materials.at(0);
  EXPECT_TRUE(std::get<CookTorranceMaterial>(material.model).roughness.map);
  EXPECT_TRUE(material.opacity.map);
  EXPECT_EQ(material.opacity.channel, alpha_or_first);
  EXPECT_TRUE(material.normal_map);
  EXPECT_FALSE(material.height);
}

TEST(Unit_TypedMaterials, BumpMaps) {
  const auto scene = scene_of(materials("Type: diffuse, bump_map: picture.png, bump_scale: .1"));
  EXPECT_TRUE(scene.materials.at(0).height);
  EXPECT_EQ(scene.materials[0].height_scale, 0.1);
  // The normal map's normal, and the heights on top of it.
  const auto both =
      scene_of(materials("Type: diffuse, bump_map: picture.png, normal_map: other.png"));
  EXPECT_TRUE(both.materials.at(0).height && both.materials[0].normal_map);
}

TEST(Unit_TypedMaterials, Opacity) {
  EXPECT_EQ(scene_of(materials("Type: diffuse, opacity: .5")).materials.at(0).opacity.factor, 0.5);
  EXPECT_EQ(error_in(materials("Type: diffuse, opacity: 2")),
            "2:39: opacity: found '2', expected a number from 0 to 1");
  EXPECT_EQ(warning_in(materials("Type: diffuse, opacity: .5, opacity_map: picture.png")),
            "2:30: opacity is not used: opacity_map replaces it");
}

TEST(Unit_TypedMaterials, OpacityReplacesLab3sAlpha) {
  const std::string clear = "Diffuse: [1, 1, 1, .25], ";
  EXPECT_EQ(warning_in(materials(clear + "opacity: .5")),
            "2:40: opacity replaces this material's alpha of 0.25");
  EXPECT_EQ(warning_in(materials(clear + "opacity_map: picture.png")),
            "2:40: opacity_map replaces this material's alpha of 0.25");
  EXPECT_TRUE(said(Severity::Warning, materials(clear + "opacity: 1")).empty());
  EXPECT_TRUE(said(Severity::Warning, materials("Diffuse: [1, 1, 1, 1], opacity: .5")).empty());
}

TEST(Unit_TypedMaterials, Conductors) {
  const auto gold = model_of<ConductorMaterial>("Type: conductor, metal: Gold, roughness: .12");
  EXPECT_EQ(gold.eta, Vec3d(0.188, 0.544, 1.332));
  EXPECT_EQ(gold.k, Vec3d(3.403, 2.231, 1.869));
  EXPECT_EQ(gold.roughness.factor, 0.12);
  const auto unnamed = model_of<ConductorMaterial>("Type: conductor");
  EXPECT_EQ(unnamed.eta, lab3::metal_named("copper").eta);
  EXPECT_EQ(unnamed.k, lab3::metal_named("copper").k);
  const auto own = model_of<ConductorMaterial>("Type: conductor, eta: .5, k: [1, 2, 3]");
  EXPECT_EQ(own.eta, Vec3d(0.5));
  EXPECT_EQ(own.k, Vec3d(1, 2, 3));
  EXPECT_EQ(own.roughness.factor, 0);
  const auto f0 = model_of<ConductorMaterial>("Type: conductor, F0: [.9, .5, 0]");
  expect_near(normal_reflectance(f0.eta, f0.k), Vec3d(0.9, 0.5, 0));
}

TEST(Unit_TypedMaterials, MetalsReflectAsTheyLook) {
  for (const lab3::Metal& metal : lab3::metals()) {
    const Vec3d reflectance = normal_reflectance(metal.eta, metal.k);
    EXPECT_GT(reflectance.x, 0.45) << metal.name;
    EXPECT_LT(reflectance.x, 1) << metal.name;
    const auto named =
        model_of<CookTorranceMaterial>(fmt::format("Type: cook_torrance, metal: {}", metal.name));
    expect_near(named.f0, reflectance);
  }
  // Gold and copper are red, the others grey within a tenth.
  const Vec3d gold = normal_reflectance(lab3::metals()[0].eta, lab3::metals()[0].k);
  expect_near(gold, Vec3d(0.942, 0.704, 0.404), 0.001);
  const Vec3d silver = normal_reflectance(lab3::metals()[1].eta, lab3::metals()[1].k);
  expect_near(silver, Vec3d(0.98), 0.01);
}

TEST(Unit_TypedMaterials, Dielectrics) {
  const auto glass = model_of<DielectricMaterial>(
      "Type: dielectric, ior: 1.33, roughness: .15, transmittance: [.9, 1, .9]");
  EXPECT_EQ(glass.ior, 1.33);
  EXPECT_EQ(glass.roughness.factor, 0.15);
  EXPECT_EQ(glass.transmittance, Vec3d(0.9, 1, 0.9));
  EXPECT_FALSE(glass.is_thin);
  const auto pane = model_of<DielectricMaterial>("Type: thin_dielectric");
  EXPECT_TRUE(pane.is_thin);
  EXPECT_EQ(pane.ior, 1.5);
}

TEST(Unit_TypedMaterials, ReflectancesThatAddUpToMoreThanOneAreScaled) {
  const std::string keys = "Type: cook_torrance, kd: [.9, .2, .1], ks: [.9, .6, .9]";
  const auto material = model_of<CookTorranceMaterial>(keys);
  expect_near(material.diffuse.factor, Vec3d(0.5, 0.2, 0.1));
  expect_near(material.specular.factor, Vec3d(0.5, 0.6, 0.9));
  EXPECT_EQ(warning_in(materials(keys)),
            "2:5: kd + ks reaches 1.8 in a channel, more than 1: both are scaled down there");
  EXPECT_TRUE(said(Severity::Warning, materials("Type: cook_torrance, kd: .3, ks: .7")).empty());
}

TEST(Unit_TypedMaterials, EnergyCompensationIsAskedFor) {
  EXPECT_FALSE(model_of<ConductorMaterial>("Type: conductor").energy_compensation);
  EXPECT_TRUE(model_of<ConductorMaterial>("Type: conductor, energy_compensation: true")
                  .energy_compensation);
  EXPECT_TRUE(model_of<CookTorranceMaterial>(
                  "Type: cook_torrance, geometry: smith, energy_compensation: true")
                  .energy_compensation);
  EXPECT_EQ(error_in(materials("Type: cook_torrance, energy_compensation: true")),
            "2:36: energy_compensation puts back what geometry: smith loses; expected that "
            "geometry");
}

TEST(Errors_TypedMaterials, WhatIsNoType) {
  EXPECT_EQ(error_in(materials("Type: cook_torence")),
            "2:21: Type: found 'cook_torence', expected cook_torrance, diffuse, mirror, conductor, "
            "dielectric or thin_dielectric, did you mean 'cook_torrance'?");
  EXPECT_EQ(error_in(materials("Type: [a]")),
            "2:21: Type: found a list of 1 value, expected cook_torrance, diffuse, mirror, "
            "conductor, dielectric or thin_dielectric");
}

TEST(Errors_TypedMaterials, AnUnknownTypeIsAllThatIsSaidOfKeysOfAnyType) {
  const std::string text = materials(
      "Type: cook-torrance, kd: x, ks: .5, roughness: .3, metal: gold, Shininess: 3, "
      "opacity: 7, kdd: 1");
  EXPECT_EQ(error_in(text),
            "2:21: Type: found 'cook-torrance', expected cook_torrance, diffuse, mirror, "
            "conductor, dielectric or thin_dielectric, did you mean 'cook_torrance'?");
  const auto warnings = said(Severity::Warning, text);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], "2:105: unknown key 'kdd' in a material, did you mean 'kd'?");
}

TEST(Unit_TypedMaterials, AMisspeltTypeIsSaidOnce) {
  const std::string text = materials("Typ: diffuse, kd: .5, roughness: .3, Diffuse: [1, 0, 0]");
  EXPECT_EQ(warning_in(text), "2:15: unknown key 'Typ' in a material, did you mean 'Type'?");
  EXPECT_TRUE(std::holds_alternative<LabMaterial>(scene_of(text).materials.at(0).model));
}

TEST(Errors_TypedMaterials, ABrokenValueIsNotJudgedByItsDefault) {
  const auto expect_one_error = [](std::string_view keys, const std::string& sentence) {
    EXPECT_EQ(error_in(materials(keys)), sentence);
    EXPECT_TRUE(said(Severity::Warning, materials(keys)).empty()) << keys;
  };
  expect_one_error("Type: cook_torrance, kd: x, ks: .9",
                   "2:40: kd: found 'x', expected a number from 0 to 1");
  expect_one_error("Type: cook_torrance, kd: .9, ks: [1, 1]",
                   "2:48: ks: found a list of 2 values, expected a number or a list of 3 numbers");
  expect_one_error("Type: cook_torrance, energy_compensation: true, geometry: smithh",
                   "2:73: geometry: found 'smithh', expected schlick_ggx or smith, did you mean "
                   "'smith'?");
}

TEST(Errors_TypedMaterials, AnImageThatIsNotNamedReplacesNothing) {
  const auto expect_one_error = [](std::string_view keys, std::string_view place_and_key) {
    const std::string text = materials(keys);
    EXPECT_EQ(error_in(text),
              fmt::format("{}: found nothing, expected the name of a file", place_and_key));
    EXPECT_TRUE(said(Severity::Warning, text).empty()) << text;
  };
  expect_one_error("Type: diffuse, kd: .3, kd_map: ", "2:38: kd_map");
  expect_one_error("Type: conductor, roughness: .3, roughness_map: ", "2:47: roughness_map");
  expect_one_error("Type: diffuse, opacity: .3, opacity_map: ", "2:43: opacity_map");
  expect_one_error("Diffuse: [1, 0, 0], DiffuseMap: ", "2:35: DiffuseMap");
  expect_one_error("Shininess: 3, SpecularMap: ", "2:29: SpecularMap");
}

TEST(Errors_TypedMaterials, NumbersOutOfRange) {
  EXPECT_EQ(error_in(materials("Type: diffuse, kd: 1.5")),
            "2:34: kd: found '1.5', expected a number from 0 to 1");
  EXPECT_EQ(error_in(materials("Type: diffuse, kd: [.5, .5]")),
            "2:34: kd: found a list of 2 values, expected a number or a list of 3 numbers");
  EXPECT_EQ(error_in(materials("Type: cook_torrance, roughness: 0")),
            "2:47: roughness: found '0', expected a number above 0, at most 1");
  EXPECT_EQ(error_in(materials("Type: conductor, roughness: 1.5")),
            "2:43: roughness: found '1.5', expected a number from 0 to 1");
  EXPECT_EQ(error_in(materials("Type: dielectric, ior: .5")),
            "2:38: ior: found '.5', expected a refractive index from 1 to 1000");
  EXPECT_EQ(error_in(materials("Type: dielectric, ior: 1e30")),
            "2:38: ior: found '1e30', expected a refractive index from 1 to 1000");
  EXPECT_EQ(error_in(materials("Type: conductor, F0: 1")),
            "2:36: F0: found '1', expected a number of at least 0, below 1");
}

TEST(Errors_TypedMaterials, Reflectances) {
  EXPECT_EQ(error_in(materials("Type: conductor, eta: 1")),
            "2:32: eta and k belong together: the other one is missing");
  EXPECT_EQ(error_in(materials("Type: conductor, metal: gold, eta: 1, k: 1")),
            "2:32: both eta and metal are given, expected one of F0, eta and k, metal");
  EXPECT_EQ(error_in(materials("Type: cook_torrance, F0: .5, ior: 2")),
            "2:44: both F0 and ior are given, expected one of F0, ior, eta and k, metal");
  EXPECT_EQ(error_in(materials("Type: cook_torrance, fresnel: exact")),
            "2:36: fresnel: exact needs ior, eta and k, or metal");
  EXPECT_EQ(error_in(materials("Type: conductor, metal: golf")),
            "2:39: metal: found 'golf', expected gold, silver, copper, aluminium, aluminum, "
            "chromium, iron, nickel or titanium, did you mean 'gold'?");
  EXPECT_EQ(error_in(materials("Type: cook_torrance, geometry: smithy")),
            "2:46: geometry: found 'smithy', expected schlick_ggx or smith, did you mean 'smith'?");
}

TEST(Unit_TypedMaterials, KeysOfOtherTypesAreExplained) {
  EXPECT_EQ(warning_in(materials("Type: diffuse, metal: gold")),
            "2:30: key 'metal' has no meaning for Type: diffuse (it has for cook_torrance, "
            "conductor)");
  EXPECT_EQ(warning_in(materials("Type: diffuse, Shininess: 5")),
            "2:30: key 'Shininess' belongs to materials without a Type; this one is Type: diffuse");
  EXPECT_EQ(warning_in(materials("Type: diffuse, kdd: 5")),
            "2:30: unknown key 'kdd' in a material, did you mean 'kd'?");
}

}  // namespace
}  // namespace candela
