#include "renderer/scene/compile_media.h"

#include <gtest/gtest.h>

#include "integrators/render.h"
#include "renderer/description/validate.h"
#include "tests/scenes/description.h"
#include "tests/scenes/render_scene.h"

namespace candela {
namespace {

using namespace test;
using description::SceneDescription;

// A box from -1 to 1, times `unit`, in a clear world; the camera within `around_camera`.
SceneDescription box_of(const description::MediumInterface& media, double unit = 1) {
  SceneDescription scene = empty_scene();
  add_medium(scene, Vec3d(1, 2, 3) / unit, Vec3d(4, 5, 6) / unit, 0.5);
  add_medium(scene, Vec3d(0.0), Vec3d(0.0));
  const auto material = add_material(scene, description::InterfaceMaterial{});
  scene.materials[material.index].media = media;
  add_mesh(scene, box(Vec3d(-1) * unit, Vec3d(1) * unit), material);
  add_light(scene, description::ConstantEnvironment{Vec3d(1.0), true});
  set_camera(scene, Vec3d(0, 0, 5) * unit, Vec3d(0.0));
  return scene;
}

const description::MediumHandle fog{0}, clear{1}, none;

TEST(Unit_CompileMedia, CoefficientsAreOfNormalisedSpace) {
  for (const double unit : {1.0, 1024.0, 0.125}) {
    const Scene scene = compiled(box_of({fog, none}, unit), {});
    ASSERT_EQ(scene.media.size(), 1u);
    const double normalised = unit * scene.normalisation.scale;  // half the box
    EXPECT_EQ(scene.media[0].scattering, Rgb(Vec3d(4, 5, 6) / normalised));
    EXPECT_EQ(scene.media[0].extinction, Rgb(Vec3d(5, 7, 9) / normalised));
    EXPECT_EQ(scene.media[0].asymmetry, 0.5f);
  }
}

// Light would scatter where no ray can start.
TEST(Unit_CompileMedia, ChannelsTooThinForTheSceneAreClear) {
  SceneDescription scene = box_of({fog, none});
  scene.media[0].scattering = Vec3d(1e-30, 1e-10, 0);
  scene.media[0].absorption = Vec3d(0, 0, 1e-20);
  const Scene thin = compiled(scene, {});
  ASSERT_EQ(thin.media.size(), 1u);
  EXPECT_EQ(thin.media[0].scattering.x, 0);
  EXPECT_EQ(thin.media[0].extinction.x, 0);
  EXPECT_GT(thin.media[0].extinction.y, 0);
  EXPECT_EQ(thin.media[0].extinction.z, 0);
  scene.media[0].scattering.y = 0;
  EXPECT_TRUE(compiled(scene, {}).media.empty());
}

TEST(Unit_CompileMedia, ThinFogAllAroundGivesValidSamples) {
  for (const double scattering : {1e-12, 1e-13, 1e-14, 1e-18, 1e-30}) {
    SceneDescription scene = box_of({none, none});
    scene.media[0].scattering = scene.media[0].absorption = Vec3d(scattering);
    scene.cameras[0].medium = fog;
    EXPECT_EQ(rendered(scene, settings_of(8, 256)).statistics.invalid_samples, 0u) << scattering;
  }
}

TEST(Unit_CompileMedia, InterfacesStayWhereTheyBoundSomething) {
  const Scene scene = compiled(box_of({fog, none}), {});
  ASSERT_EQ(scene.medium_boundaries.size(), 1u);
  EXPECT_EQ(scene.medium_boundaries[0].inside, MediumHandle(0));
  EXPECT_FALSE(scene.medium_boundaries[0].outside);
  EXPECT_TRUE(scene.medium_boundaries[0].is_clear);
  EXPECT_EQ(scene.geometries.size(), 1u);
  EXPECT_TRUE(scene.features.media && scene.features.scattering_media &&
              scene.features.clear_boundaries);
  EXPECT_EQ(kernel_name(scene, {}), "path/media_lanes");
}

// A scene without media carries none of it.
TEST(Unit_CompileMedia, WhatBoundsNothingIsNotThere) {
  for (const auto& media : {description::MediumInterface{none, none}, {clear, none}, {fog, fog}}) {
    const Scene scene = compiled(box_of(media), {});
    EXPECT_TRUE(scene.media.empty());
    EXPECT_TRUE(scene.medium_boundaries.empty());
    EXPECT_TRUE(scene.geometries.empty());
    EXPECT_FALSE(scene.features.media);
    EXPECT_EQ(kernel_name(scene, {}), "path/lanes");
  }
}

TEST(Unit_CompileMedia, TheCameraMayBeInOne) {
  SceneDescription description = box_of({none, none});
  description.cameras[0].medium = fog;
  const Scene scene = compiled(description, {});
  EXPECT_EQ(scene.cameras[0].medium, MediumHandle(0));
  EXPECT_EQ(kernel_name(scene, {}), "path/media");
  EXPECT_TRUE(scene.features.media);
  EXPECT_FALSE(scene.features.clear_boundaries);
}

// whitted, raster and report have no media, nor surfaces that only bound them.
TEST(Unit_CompileMedia, OnlyPathHasMedia) {
  RenderOptions options;
  options.integrator = IntegratorKind::Report;
  const Scene scene = compiled(box_of({fog, none}), options);
  EXPECT_TRUE(scene.media.empty());
  EXPECT_TRUE(scene.geometries.empty());
}

TEST(Errors_Media, OthersThanPathSayThatTheyLeaveThemOut) {
  RenderOptions options;
  EXPECT_TRUE(check_integrator(box_of({fog, none}), options).list().empty());
  options.integrator = IntegratorKind::Whitted;
  const Diagnostics diagnostics = check_integrator(box_of({fog, none}), options);
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(to_string(diagnostics.list()[0]),
            "warning: medium 'medium0': whitted leaves media out; expected path");
}

std::string first_error(const SceneDescription& scene) {
  const Diagnostics diagnostics = description::validate(scene);
  return diagnostics.list().empty() ? "" : diagnostics.list().front().message;
}

TEST(Errors_Media, AreNamed) {
  SceneDescription scene = box_of({fog, none});
  EXPECT_EQ(first_error(scene), "");
  scene.media[0].absorption.y = -1;
  EXPECT_EQ(first_error(scene), "medium 'medium0': the absorption is -1, expected at least 0");
  scene.media[0].absorption.y = 1;
  scene.media[0].scattering.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(first_error(scene), "medium 'medium0': the scattering is inf, expected at least 0");
  scene.media[0].scattering.x = 0;
  scene.media[0].asymmetry = 1;
  EXPECT_EQ(first_error(scene),
            "medium 'medium0': the asymmetry is 1, expected above -1 and below 1");
  scene.media[0].asymmetry = 0;
  scene.materials[0].media.outside = description::MediumHandle(7);
  EXPECT_EQ(first_error(scene), "material 'material0' bounds a medium that does not exist");
  scene.materials[0].media.outside = {};
  scene.cameras[0].medium = description::MediumHandle(7);
  EXPECT_EQ(first_error(scene), "a camera is in a medium that does not exist");
}

}  // namespace
}  // namespace candela
