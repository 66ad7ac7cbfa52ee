// Materials without a Type: lab3's own, with the traps that docs/scene_format.md
// names ("Materials").
#include <gtest/gtest.h>

#include "tests/scene_io/lab3/lab3_text.h"

namespace candela {
namespace {

using namespace description;
using test::error_in;
using test::said;
using test::scene_of;
using test::warning_in;

std::string materials(std::string_view keys) {
  return fmt::format("Materials:\n  - {{Name: m{}{}}}\n", keys.empty() ? "" : ", ", keys);
}

SceneDescription scene_with(std::string_view keys) {
  return scene_of(materials(keys));
}

LabMaterial material_of(std::string_view keys) {
  const SceneDescription scene = scene_with(keys);
  if (scene.materials.size() != 1 ||
      !std::holds_alternative<LabMaterial>(scene.materials[0].model)) {
    ADD_FAILURE() << "not one lab material: " << keys;
    return {};
  }
  return std::get<LabMaterial>(scene.materials[0].model);
}

std::string file_name(const SceneDescription& scene, ImageHandle image) {
  if (!image) return "none";
  return scene.images.at(image.index).path.substr(test::lab3_folder().size());
}

TEST(Unit_Lab3Materials, Defaults) {
  const SceneDescription scene = scene_with("");
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].name, "m");
  EXPECT_EQ(scene.materials[0].emission, Vec3d(0.0));
  EXPECT_EQ(scene.materials[0].opacity.factor, 1);
  const auto& lab = std::get<LabMaterial>(scene.materials[0].model);
  EXPECT_EQ(lab.diffuse.factor, Vec3d(1.0));
  EXPECT_EQ(lab.alpha, 1);
  EXPECT_EQ(lab.specular.factor, Vec3d(0.0));
  EXPECT_EQ(lab.shininess, 0);
  EXPECT_FALSE(lab.diffuse.map);
  EXPECT_FALSE(lab.specular.map);
}

TEST(Unit_Lab3Materials, DiffuseKeepsItsNumbersAsWritten) {
  const LabMaterial material = material_of("Diffuse: [.5, .25, .125, .75]");
  EXPECT_EQ(material.diffuse.factor, Vec3d(0.5, 0.25, 0.125));
  EXPECT_EQ(material.alpha, 0.75);
  EXPECT_EQ(material_of("Diffuse: [.5, .25, .125]").alpha, 1);
}

TEST(Unit_Lab3Materials, LaterSynonymsOverrideInTheLabsOrderNotTheFiles) {
  for (const char* keys : {"BaseColor: [.3, .3, .3], Diffuse: [.1, .1, .1], Albedo: [.2, .2, .2]",
                           "Diffuse: [.1, .1, .1], Albedo: [.2, .2, .2], BaseColor: [.3, .3, .3]"})
    EXPECT_EQ(material_of(keys).diffuse.factor, Vec3d(0.3));
  EXPECT_EQ(material_of("Albedo: [.2, .2, .2], Diffuse: [.1, .1, .1]").diffuse.factor, Vec3d(0.2));
  EXPECT_EQ(material_of("Metallic: [.4, .4, .4, 9], Specular: [.1, .1, .1, 7]").shininess, 9);
  EXPECT_EQ(material_of("Smoothness: 3, Glossiness: 2, Shininess: 1").shininess, 3);
  EXPECT_EQ(material_of("Glossiness: 2, Shininess: 1").shininess, 2);
  EXPECT_EQ(warning_in(materials("Diffuse: [.1, .1, .1], Albedo: [.2, .2, .2]")),
            "2:15: Diffuse is overridden by Albedo");
}

TEST(Unit_Lab3Materials, ShininessIsTheFourthNumberOrItsOwnKey) {
  EXPECT_EQ(material_of("Specular: [.4, .4, .4, 32.]").shininess, 32);
  EXPECT_EQ(material_of("Specular: [.4, .4, .4, 32.], Shininess: 64").shininess, 64);
  EXPECT_EQ(material_of("Specular: [.25, .25, .25], Shininess: 64").shininess, 64);
  EXPECT_EQ(material_of("Specular: [.25, .25, .25]").shininess, 1);  // the missing number is 1
  EXPECT_EQ(material_of("Shininess: 64").shininess, 64);
}

TEST(Unit_Lab3Materials, MissingEntriesAreOne) {
  const LabMaterial material = material_of("Metallic: [.5], Diffuse: [.5, .25]");
  EXPECT_EQ(material.specular.factor, Vec3d(0.5, 1, 1));
  EXPECT_EQ(material.shininess, 1);
  EXPECT_EQ(material.diffuse.factor, Vec3d(0.5, 0.25, 1));
  EXPECT_EQ(warning_in(materials("Metallic: [.5]")),
            "2:25: Metallic: found a list of 1 value, expected 3 or 4 numbers; lab3 takes 1 for "
            "what is missing");
}

TEST(Unit_Lab3Materials, FactorsAreClampedAsTheLabStoresThem) {
  EXPECT_EQ(material_of("Diffuse: [2, -1, .5, 3]").diffuse.factor, Vec3d(1, 0, 0.5));
  EXPECT_EQ(material_of("Diffuse: [2, -1, .5, 3]").alpha, 1);
  EXPECT_EQ(material_of("Shininess: 1000").shininess, 256);
  EXPECT_EQ(material_of("Specular: [1, 1, 1, 300]").shininess, 256);
  EXPECT_EQ(warning_in(materials("Diffuse: [.5, .5, 1.5]")),
            "2:33: Diffuse: 1.5 is taken as 1: lab3 stores 0 to 1 only");
  EXPECT_EQ(warning_in(materials("Shininess: 1000")),
            "2:26: Shininess: 1000 is taken as 256: lab3 stores 0 to 256 only");
}

TEST(Unit_Lab3Materials, MapsReplaceFactors) {
  const std::string keys =
      "DiffuseMap: picture.png, Specular: [.5, .5, .5], Shininess: 8, SpecularMap: other.png";
  const SceneDescription scene = scene_with(keys);
  const auto& lab = std::get<LabMaterial>(scene.materials.at(0).model);
  EXPECT_EQ(file_name(scene, lab.diffuse.map), "picture.png");
  EXPECT_EQ(scene.images.at(lab.diffuse.map.index).encoding, Encoding::LabGamma);
  EXPECT_EQ(scene.images.at(lab.diffuse.map.index).wrap, Wrap::Repeat);
  EXPECT_EQ(scene.images.at(lab.diffuse.map.index).span.column, 27u);
  EXPECT_EQ(file_name(scene, lab.specular.map), "other.png");
  EXPECT_EQ(scene.images.at(lab.specular.map.index).encoding, Encoding::Linear);
  const auto warnings = said(Severity::Warning, materials(keys));
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0],
            "2:40: Specular is not used: SpecularMap replaces it (lab3 does not multiply them)");
  EXPECT_EQ(warnings[1],
            "2:64: Shininess is not used: SpecularMap replaces it (lab3 does not multiply them)");
}

TEST(Unit_Lab3Materials, MapsHaveSynonymsToo) {
  SceneDescription scene = scene_with("AlbedoMap: picture.png, MetallicMap: other.png");
  const auto& lab = std::get<LabMaterial>(scene.materials.at(0).model);
  EXPECT_EQ(file_name(scene, lab.diffuse.map), "picture.png");
  EXPECT_EQ(file_name(scene, lab.specular.map), "other.png");
  scene = scene_with("BaseColorMap: other.png, DiffuseMap: picture.png");
  EXPECT_EQ(file_name(scene, std::get<LabMaterial>(scene.materials.at(0).model).diffuse.map),
            "other.png");
}

TEST(Unit_Lab3Materials, EqualImagesAreOne) {
  const SceneDescription scene = scene_of(
      "Materials:\n  - {Name: a, DiffuseMap: picture.png}\n  - {Name: b, DiffuseMap: picture.png}\n"
      "  - {Name: c, SpecularMap: picture.png}\n");
  EXPECT_EQ(scene.images.size(), 2u);  // the third is decoded in another way
}

TEST(Unit_Lab3Materials, HeightMaps) {
  const SceneDescription scene = scene_with("HeightMap: picture.png");
  EXPECT_EQ(file_name(scene, scene.materials.at(0).height), "picture.png");
  EXPECT_EQ(scene.images.at(0).encoding, Encoding::Linear);
  EXPECT_EQ(scene.materials[0].height_scale, 0.02);
  EXPECT_EQ(scene_with("HeightMap: picture.png, bump_scale: .5").materials.at(0).height_scale, 0.5);
  EXPECT_EQ(warning_in(materials("bump_scale: .5")),
            "2:15: bump_scale has no effect without a HeightMap");
}

TEST(Unit_Lab3Materials, BlendIsReadAndIgnored) {
  EXPECT_EQ(material_of("Blend: Transparent").alpha, 1);
  EXPECT_EQ(material_of("Blend: Opaque, Diffuse: [1, 1, 1, .5]").alpha, 0.5);
  EXPECT_EQ(error_in(materials("Blend: Opaqe")),
            "2:22: Blend: found 'Opaqe', expected Opaque or Transparent, did you mean 'Opaque'?");
}

TEST(Unit_Lab3Materials, EmissionByAPicture) {
  const SceneDescription scene = scene_with("EmissionMap: glow.png");
  const auto& material = scene.materials.at(0);
  EXPECT_EQ(material.emission, Vec3d(1));
  EXPECT_EQ(scene.images.at(material.emission_map.index).encoding, Encoding::Srgb);
  EXPECT_EQ(scene_with("EmissionMap: glow.exr, Emission: 5").materials.at(0).emission, Vec3d(5));
  EXPECT_EQ(scene_with("EmissionMap: glow.exr").images.at(0).encoding, Encoding::Linear);
}

TEST(Unit_Lab3Materials, EmissionOnAnyMaterial) {
  const SceneDescription scene = scene_with("Emission: [17, 12, 4], TwoSided: yes");
  EXPECT_EQ(scene.materials.at(0).emission, Vec3d(17, 12, 4));
  EXPECT_TRUE(scene.materials[0].emits_both_sides);
  EXPECT_EQ(scene_with("Emission: 5").materials.at(0).emission, Vec3d(5));
  EXPECT_FALSE(scene_with("Emission: 5").materials.at(0).emits_both_sides);
  EXPECT_EQ(error_in(materials("Emission: [1, 2]")),
            "2:25: Emission: found a list of 2 values, expected a number or a list of 3 numbers");
  EXPECT_EQ(error_in(materials("Emission: -1")),
            "2:25: Emission: found '-1', expected a number of at least 0");
  EXPECT_EQ(warning_in(materials("TwoSided: true")),
            "2:15: TwoSided has no effect without Emission");
}

TEST(Unit_Lab3Materials, OfEqualNamesTheLastCounts) {
  const std::string text =
      "Materials:\n  - {Name: a}\n  - {Name: a}\nModels:\n  - {Mesh: triangle.obj, Material: a}\n";
  const SceneDescription scene = scene_of(text);
  EXPECT_EQ(scene.meshes.at(0).materials.at(0).index, 1u);
  EXPECT_EQ(warning_in(text), "3:12: material 'a' is defined twice: the last one counts");
}

TEST(Errors_Lab3Materials, WhatIsNoMaterial) {
  EXPECT_EQ(error_in(materials("Diffuse: .5")),
            "2:24: Diffuse: found '.5', expected a list of 3 or 4 numbers, such as [.5, .5, .5]");
  EXPECT_EQ(error_in(materials("Diffuse: [1, 1, 1, 1, 1]")),
            "2:24: Diffuse: found a list of 5 values, expected at most 4 numbers");
  EXPECT_EQ(error_in(materials("Shininess: [5]")),
            "2:26: Shininess: found a list of 1 value, expected a number");
  EXPECT_EQ(error_in(materials("DiffuseMap: [a.png]")),
            "2:27: DiffuseMap: found a list of 1 value, expected the name of a file");
  EXPECT_EQ(error_in("Materials: [{Name: [a]}]\n"),
            "1:20: Name: found a list of 1 value, expected a name");
  EXPECT_EQ(warning_in("Materials: [{Diffuse: [1, 1, 1]}]\n"),
            "1:13: this material has no Name: no model can use it by name");
}

TEST(Errors_Lab3Materials, MapsThatAreNoFiles) {
  EXPECT_EQ(error_in(materials("DiffuseMap: folder")),
            "2:27: 'folder': this is a folder where an image was expected");
  EXPECT_EQ(error_in(materials("DiffuseMap: pipe")),
            "2:27: 'pipe': this is a FIFO where an image was expected");
  EXPECT_EQ(error_in(materials("HeightMap: /dev/zero")),
            "2:26: '/dev/zero': this is a device where an image was expected");
}

TEST(Unit_Lab3Materials, MissingMapsAreLeftToTheTextureStore) {
  const SceneDescription scene = scene_with("DiffuseMap: not_there.png");
  EXPECT_EQ(file_name(scene, ImageHandle(0)), "not_there.png");
}

TEST(Unit_Lab3Materials, LetterCaseOfFilesMayDiffer) {
  const SceneDescription scene = scene_with("DiffuseMap: Picture.PNG");
  EXPECT_EQ(file_name(scene, ImageHandle(0)), "picture.png");
  const std::string warning = warning_in(materials("DiffuseMap: Picture.PNG"));
  EXPECT_TRUE(warning.ends_with("is taken for 'Picture.PNG': letter case differs")) << warning;
}

TEST(Unit_Lab3Materials, KeysOfTypedMaterialsAreExplained) {
  EXPECT_EQ(warning_in(materials("roughness: .3")),
            "2:15: key 'roughness' belongs to materials with a Type (cook_torrance, conductor, "
            "dielectric); this one has none");
  EXPECT_EQ(warning_in(materials("kd: .3")),
            "2:15: key 'kd' belongs to materials with a Type (cook_torrance, diffuse, mirror); "
            "this one has none");
  EXPECT_EQ(warning_in(materials("Difuse: [1, 1, 1]")),
            "2:15: unknown key 'Difuse' in a material, did you mean 'Diffuse'?");
}

}  // namespace
}  // namespace candela
