// Materials of every model as (kd, ks, exponent, alpha).
#include "integrators/whitted/lab_surface.h"

#include "tests/integrators/whitted/lab_scenes.h"

namespace candela {
namespace {

using namespace test;

template <class Model>
LabSurface surface_of(Model model, double opacity = 1) {
  description::SceneDescription scene = empty_scene();
  add_sheet(scene, 0, add_material(scene, std::move(model)));
  scene.materials[0].opacity.factor = opacity;
  set_camera(scene, {0, 2, 0}, {0, 0, 0}, 40, {0, 0, 1});
  const Scene made = compiled(scene, lab_settings(IntegratorKind::Whitted).options);
  const Material& material = made.materials[0];
  return lab_surface_at(material, material, made.textures, {Vec2f(0.5f)});
}

TEST(Unit_LabSurface, CookTorranceIsTheInverseOfTheHighlightsWidth) {
  description::CookTorranceMaterial model;
  model.diffuse.factor = {0.1, 0.2, 0.3};
  model.specular.factor = Vec3d(0.5);
  model.f0 = {0.9, 0.6, 0.3};
  model.roughness.factor = std::sqrt(2 / (30.0 + 2));  // a of n = 30
  const LabSurface surface = surface_of(model);
  expect_near(surface.kd, {0.1, 0.2, 0.3});
  expect_near(surface.ks, {0.45, 0.3, 0.15});
  expect_near(surface.mirror, {0.225, 0.15, 0.075});
  EXPECT_NEAR(surface.exponent, 30, 1e-4);
  EXPECT_EQ(surface.alpha, 1);
}

TEST(Unit_LabSurface, LabMaterialsStayAsTheyAre) {
  description::LabMaterial model;
  model.diffuse.factor = Vec3d(1.0, 0.0, 51 / 255.0);
  model.specular.factor = Vec3d(51 / 255.0);
  model.shininess = 256 * 102 / 255.0;
  model.alpha = 204 / 255.0;
  const LabSurface surface = surface_of(model);
  expect_near(surface.kd, {1, 0, std::pow(0.2, 2.2)});
  expect_near(surface.ks, Vec3d(0.2));
  expect_near(surface.mirror, Vec3d(0.1));
  EXPECT_NEAR(surface.exponent, 102.4, 1e-4);
  EXPECT_NEAR(surface.alpha, 0.8, 1e-6);
}

TEST(Unit_LabSurface, PolishedMetalMirrorsItsReflectance) {
  const LabSurface surface =
      surface_of(description::ConductorMaterial{Vec3d(1.0), {2, 4, 6}, {0.0, {}, 0}});
  expect_near(surface.mirror, {4.0 / 8, 16.0 / 20, 36.0 / 40});  // k^2 / (4 + k^2)
  expect_near(surface.kd, Vec3d(0.0));
}

TEST(Unit_LabSurface, GlassIsAHoleForShadowsThatCoversWhatItReflects) {
  description::DielectricMaterial model;
  model.ior = 1.5;
  model.transmittance = {1, 0.5, 0.25};
  const LabSurface surface = surface_of(model);
  EXPECT_NEAR(surface.alpha, 0.04, 1e-6);
  expect_near(surface.behind, 0.96 * Vec3d(1, 0.5, 0.25));
}

// What is not there tints nothing.
TEST(Unit_LabSurface, HolesInTintedGlassAreClear) {
  description::DielectricMaterial model;
  model.ior = 1.5;
  model.transmittance = Vec3d(0.5);
  expect_near(surface_of(model, 0).behind, Vec3d(1.0));
  const LabSurface half = surface_of(model, 0.5);
  EXPECT_NEAR(half.alpha, 0.02, 1e-6);
  expect_near(half.behind, Vec3d(0.5 + 0.5 * 0.96 * 0.5));
}

TEST(Unit_LabSurface, ThinPanesHaveTheNarrowestHighlight) {
  description::DielectricMaterial pane;
  pane.ior = 1.5;
  pane.is_thin = true;
  EXPECT_EQ(surface_of(pane).exponent, 256);
}

}  // namespace
}  // namespace candela
