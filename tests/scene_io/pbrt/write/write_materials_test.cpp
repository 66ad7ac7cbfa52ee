// Every model of a material comes back as it was, with all its numbers.
#include <gtest/gtest.h>

#include "scene_io/pbrt/write/write_pbrt.h"
#include "tests/scene_io/pbrt/write/round_trip.h"
#include "tests/scenes/description.h"

namespace candela::pbrt {
namespace {

using namespace description;

// A scene with one surface of the material.
SceneDescription scene_of(Material material) {
  SceneDescription scene = test::empty_scene();
  test::set_camera(scene, {0, 0, 5}, {0, 0, 0});
  const MaterialHandle handle = test::add_material(scene, DiffuseMaterial{});
  material.name = "the \"one\" \\ and only";
  scene.materials[handle.index] = std::move(material);
  test::add_mesh(scene, test::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), handle);
  return scene;
}

struct Outcome {
  Material material;
  std::string text;
  std::vector<std::string> lost;
};

Outcome outcome_of(const Material& material) {
  const test::RoundTrip trip = test::round_trip(scene_of(material));
  Outcome outcome{{}, trip.written.text, {}};
  for (const Diagnostic& d : trip.diagnostics.list()) outcome.lost.push_back(d.message);
  if (trip.scene.instances.empty()) return outcome;
  const Mesh& mesh = trip.scene.meshes[trip.scene.instances[0].mesh.index];
  outcome.material = trip.scene.materials[mesh.materials[0].index];
  return outcome;
}

template <class Model>
Outcome outcome_of_model(const Model& model) {
  Material material;
  material.model = model;
  Outcome outcome = outcome_of(material);
  EXPECT_TRUE(std::holds_alternative<Model>(outcome.material.model)) << outcome.text;
  if (!std::holds_alternative<Model>(outcome.material.model)) outcome.material.model = Model{};
  return outcome;
}

const Vec3d odd(0.1, 1.0 / 3, 0.7);
constexpr double odd_width = 0.123456789012345678;

TEST(Unit_WriteMaterials, Diffuse) {
  const Outcome back = outcome_of_model(DiffuseMaterial{{odd, {}, {}}});
  EXPECT_EQ(std::get<DiffuseMaterial>(back.material.model).reflectance.factor, odd);
  EXPECT_EQ(back.material.name, "the \"one\" \\ and only");
  EXPECT_EQ(back.lost.size(), 0u);
  EXPECT_EQ(back.text.find("string model"), std::string::npos);
}

TEST(Unit_WriteMaterials, Conductor) {
  ConductorMaterial metal;
  metal.eta = odd;
  metal.k = Vec3d(3, 2.5, odd_width);
  metal.roughness.factor = odd_width;
  metal.roughness_across = ScalarInput{0.5, {}, 0, {}};
  const Outcome back = outcome_of_model(metal);
  const auto& m = std::get<ConductorMaterial>(back.material.model);
  EXPECT_EQ(m.eta, metal.eta);
  EXPECT_EQ(m.k, metal.k);
  EXPECT_EQ(m.roughness.factor, odd_width);
  ASSERT_TRUE(m.roughness_across);
  EXPECT_EQ(m.roughness_across->factor, 0.5);
  EXPECT_FALSE(m.energy_compensation);
  EXPECT_EQ(back.lost.size(), 0u);
}

TEST(Unit_WriteMaterials, EnergyCompensationIsLostForPbrtOnly) {
  ConductorMaterial metal;
  metal.roughness.factor = 0.5;
  metal.energy_compensation = true;
  const Outcome back = outcome_of_model(metal);
  EXPECT_TRUE(std::get<ConductorMaterial>(back.material.model).energy_compensation);
  ASSERT_EQ(back.lost.size(), 1u);
  EXPECT_NE(back.lost[0].find("and only"), std::string::npos) << back.lost[0];
}

TEST(Unit_WriteMaterials, RoughGlass) {
  DielectricMaterial glass;
  glass.ior = 1.7;
  glass.roughness.factor = odd_width;
  const Outcome back = outcome_of_model(glass);
  const auto& m = std::get<DielectricMaterial>(back.material.model);
  EXPECT_EQ(m.ior, glass.ior);
  EXPECT_EQ(m.roughness.factor, odd_width);
  EXPECT_EQ(back.lost.size(), 0u);
}

TEST(Unit_WriteMaterials, ColouredAndThinGlass) {
  DielectricMaterial glass;
  glass.transmittance = odd;
  glass.is_thin = true;
  const Outcome back = outcome_of_model(glass);
  const auto& m = std::get<DielectricMaterial>(back.material.model);
  EXPECT_EQ(m.transmittance, odd);
  EXPECT_TRUE(m.is_thin);
  EXPECT_EQ(back.lost.size(), 1u);
}

TEST(Unit_WriteMaterials, Coats) {
  Coat coat;
  coat.ior = 1.3;
  coat.roughness.factor = odd_width;
  coat.thickness = 0.02;
  coat.max_depth = 6;
  const auto expect_coat = [&](const Coat& back) {
    EXPECT_EQ(back.ior, 1.3);
    EXPECT_EQ(back.roughness.factor, odd_width);
    EXPECT_EQ(back.thickness, 0.02);
    EXPECT_EQ(back.max_depth, 6);
  };
  const Outcome paint = outcome_of_model(CoatedDiffuseMaterial{{odd, {}, {}}, coat});
  const auto& p = std::get<CoatedDiffuseMaterial>(paint.material.model);
  EXPECT_EQ(p.reflectance.factor, odd);
  expect_coat(p.coat);
  CoatedConductorMaterial metal;
  metal.eta = odd;
  metal.k = Vec3d(1, 2, 3);
  metal.roughness.factor = 0.25;
  metal.coat = coat;
  const Outcome lacquer = outcome_of_model(metal);
  const auto& m = std::get<CoatedConductorMaterial>(lacquer.material.model);
  EXPECT_EQ(m.eta, odd);
  EXPECT_EQ(m.k, metal.k);
  EXPECT_EQ(m.roughness.factor, 0.25);
  expect_coat(m.coat);
  EXPECT_EQ(paint.lost.size() + lacquer.lost.size(), 0u);
}

TEST(Unit_WriteMaterials, TransmissionAndNothing) {
  const Outcome leaf =
      outcome_of_model(DiffuseTransmissionMaterial{{odd / 2.0, {}, {}}, {odd / 3.0, {}, {}}});
  const auto& m = std::get<DiffuseTransmissionMaterial>(leaf.material.model);
  EXPECT_EQ(m.reflectance.factor, odd / 2.0);
  EXPECT_EQ(m.transmittance.factor, odd / 3.0);
  EXPECT_EQ(outcome_of_model(InterfaceMaterial{}).lost.size(), 0u);
}

TEST(Unit_WriteMaterials, MirrorsThatPbrtDoesNotHave) {
  const Outcome back = outcome_of_model(MirrorMaterial{{odd, {}, {}}});
  EXPECT_EQ(std::get<MirrorMaterial>(back.material.model).reflectance.factor, odd);
  EXPECT_EQ(back.lost.size(), 1u);
  EXPECT_NE(back.text.find("\"string type\" \"conductor\""), std::string::npos);
}

TEST(Unit_WriteMaterials, CookTorranceIsAMixtureForPbrt) {
  CookTorranceMaterial steel;
  steel.diffuse.factor = Vec3d(0.2, 0.1, 0.05);
  steel.specular.factor = Vec3d(0.6, 0.8, 0.3);
  steel.roughness.factor = odd_width;
  steel.f0 = odd;
  steel.ior = 1.4;
  steel.eta_k = {Vec3d(1, 2, 3), Vec3d(4, 5, 6)};
  steel.fresnel = FresnelModel::Exact;
  steel.geometry = GeometryModel::Smith;
  steel.energy_compensation = true;
  const Outcome back = outcome_of_model(steel);
  const auto& m = std::get<CookTorranceMaterial>(back.material.model);
  EXPECT_EQ(m.diffuse.factor, steel.diffuse.factor);
  EXPECT_EQ(m.specular.factor, steel.specular.factor);
  EXPECT_EQ(m.roughness.factor, odd_width);
  EXPECT_EQ(m.f0, odd);
  EXPECT_EQ(m.ior, steel.ior);
  EXPECT_EQ(m.eta_k, steel.eta_k);
  EXPECT_EQ(m.fresnel, steel.fresnel);
  EXPECT_EQ(m.geometry, steel.geometry);
  EXPECT_TRUE(m.energy_compensation);
  ASSERT_EQ(back.lost.size(), 1u);
  EXPECT_NE(back.text.find("\"float amount\" 0.8\n"), std::string::npos) << back.text;
}

TEST(Unit_WriteMaterials, LabMaterialsWithHolesOfTheirOwn) {
  LabMaterial lab;
  lab.diffuse.factor = odd;
  lab.alpha = 0.75;
  lab.specular.factor = Vec3d(0.3);
  lab.shininess = 17.5;
  Material material;
  material.model = lab;
  material.opacity.factor = 0.5;
  const Outcome back = outcome_of(material);
  ASSERT_TRUE(std::holds_alternative<LabMaterial>(back.material.model)) << back.text;
  const auto& m = std::get<LabMaterial>(back.material.model);
  EXPECT_EQ(m.diffuse.factor, odd);
  EXPECT_EQ(m.alpha, 0.75);
  EXPECT_EQ(m.specular.factor, lab.specular.factor);
  EXPECT_EQ(m.shininess, 17.5);
  EXPECT_EQ(back.material.opacity.factor, 0.5);
}

// What no other model reads: pbrt's alpha of the shape comes from lab3's.
TEST(Unit_WriteMaterials, LabAlphaDoesNotCountTwice) {
  LabMaterial lab;
  lab.alpha = 0.25;
  const Outcome back = outcome_of_model(lab);
  EXPECT_NE(back.text.find("\"float alpha\" 0.25"), std::string::npos) << back.text;
  EXPECT_EQ(back.material.opacity.factor, 1);
  EXPECT_EQ(back.lost.size(), 0u);  // without a highlight it is Lambert's surface
}

TEST(Unit_WriteMaterials, WhatShinesAndHasHoles) {
  Material material;
  material.model = DiffuseMaterial{};
  material.emission = odd;
  material.emits_both_sides = true;
  material.opacity.factor = 0.625;
  const Outcome back = outcome_of(material);
  EXPECT_EQ(back.material.emission, odd);
  EXPECT_TRUE(back.material.emits_both_sides);
  EXPECT_EQ(back.material.opacity.factor, 0.625);
}

TEST(Unit_WriteMaterials, HeightsBesideAMapOfNormalsAreLostForPbrt) {
  SceneDescription scene = scene_of(Material{});
  scene.images = {{"bumps.png", Encoding::Linear, Wrap::Repeat, {}}};
  scene.materials[0].height = scene.materials[0].normal_map = ImageHandle(0);
  const test::RoundTrip trip = test::round_trip(scene, {8, 8, 3, -1, false});
  ASSERT_EQ(trip.diagnostics.list().size(), 1u);
  EXPECT_NE(trip.diagnostics.list()[0].message.find("its heights, beside its map of normals"),
            std::string::npos);
}

}  // namespace
}  // namespace candela::pbrt
