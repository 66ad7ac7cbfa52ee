// What whitted's rays do behind the first surface (docs/cli.md, "Whitted and raster"): mirrors,
// transparency, depth.
#include "tests/integrators/whitted/lab_scenes.h"

namespace candela {
namespace {

using description::SceneDescription;
using namespace test;

// Under ambient light of 1 a diffuse surface shows its reflectance.
SceneDescription ambient_scene() {
  SceneDescription scene = empty_scene();
  scene.lab_ambient = Vec3d(1.0);
  set_camera(scene, {0, 4, 0}, {0, 0, 0}, 40, {0, 0, 1});
  return scene;
}

TEST(Unit_WhittedRays, MirrorsWeighHalfOfTheHighlightsColour) {
  SceneDescription scene = ambient_scene();
  description::LabMaterial floor = highlight_only(102 / 255.0, 32);
  floor.diffuse.factor = Vec3d(1.0);
  add_sheet(scene, 0, add_material(scene, floor));
  add_sheet(scene, 8, add_material(scene, diffuse({0.7, 0.5, 0.3})));
  const double mirror = 0.5 * 102 / 255;
  expect_near(seen_by_whitted(scene), (1 - mirror) + mirror * Vec3d(0.7, 0.5, 0.3));
}

TEST(Unit_WhittedRays, IdealMirrorsReflectAllThatTheyReflect) {
  SceneDescription scene = ambient_scene();
  add_sheet(scene, 0, add_material(scene, description::MirrorMaterial{{{0.9, 0.8, 0.7}, {}}}));
  add_sheet(scene, 8, add_material(scene, diffuse(Vec3d(0.5))));
  expect_near(seen_by_whitted(scene), Vec3d(0.9, 0.8, 0.7) * 0.5);
}

// Seen under 45 degrees, the mirrored ray leaves under 45 degrees.
TEST(Unit_WhittedRays, MirroredRaysLeaveAsTheyCame) {
  SceneDescription scene = ambient_scene();
  add_sheet(scene, 0, add_material(scene, description::MirrorMaterial{{Vec3d(1.0), {}}}));
  const auto target = add_material(scene, diffuse(Vec3d(0.6)));
  add_mesh(scene, quad({2.9, 3, 0.1}, {0.3, 0, 0}, {0, 0, -0.3}), target);  // about (3, 3, 0)
  set_camera(scene, {-2, 2, 0}, {0, 0, 0}, 40);
  expect_near(seen_by_whitted(scene), Vec3d(0.6));
}

TEST(Unit_WhittedRays, WhatIsNotSolidShowsWhatLiesStraightBehind) {
  for (const double alpha : {0.0, 0.1, 0.5, 0.899, 0.9, 1.0}) {
    SceneDescription scene = ambient_scene();
    add_sheet(scene, 0, add_material(scene, diffuse(Vec3d(0.25))));
    add_sheet(scene, 2, add_cutout(scene, 0.75, alpha));
    const double covered = alpha < 0.9 ? alpha : 1.0;
    expect_near(seen_by_whitted(scene), Vec3d(covered * 0.75 + (1 - covered) * 0.25));
  }
}

// A mixture is the part that is there more often: glass shows and lets through as on its own, and
// the mixture's opacity, not the part's, says what it covers.
TEST(Unit_WhittedRays, GlassInAMixtureIsClear) {
  const auto mixed_with_clay = [](SceneDescription& scene, description::MaterialHandle glass) {
    const auto clay = add_material(scene, diffuse(Vec3d(0.75)));
    return add_material(scene, description::MixMaterial{glass, clay, {0.3, {}, 0}});
  };
  for (const double opacity : {1.0, 0.5}) {
    Rgb pictures[2][2];
    for (const int is_mixed : {0, 1}) {
      SceneDescription scene = floor_seen_from(4, diffuse(Vec3d(0.25)));
      scene.lab_ambient = Vec3d(0.5);
      add_lab_point_light(scene, {0, 3, 0.5}, 3);
      auto material = add_material(scene, description::DielectricMaterial{});
      if (is_mixed == 1) material = mixed_with_clay(scene, material);
      scene.materials[material.index].opacity.factor = opacity;
      add_sheet(scene, 2, material);
      pictures[is_mixed][0] = seen_by_whitted(scene);
      pictures[is_mixed][1] = seen(scene, lab_settings(IntegratorKind::Raster));
    }
    EXPECT_GT(pictures[0][0].x, 0.15f);  // the floor, and no shadow on it
    for (const int i : {0, 1}) EXPECT_EQ(pictures[1][i], pictures[0][i]) << opacity << " " << i;
  }
}

TEST(Unit_WhittedRays, LightOfLampsIsSeen) {
  SceneDescription scene = ambient_scene();
  add_sheet(scene, 0, add_material(scene, diffuse(Vec3d(0.0)), {3, 2, 1}));
  expect_near(seen_by_whitted(scene), {3, 2, 1});
}

// Every surface counts, holes too: three sheets and the floor are four.
TEST(Unit_WhittedRays, DepthCountsSurfaces) {
  SceneDescription scene = ambient_scene();
  add_sheet(scene, 0, add_material(scene, diffuse(Vec3d(0.25))));
  for (const double y : {1.0, 2.0, 3.0}) add_sheet(scene, y, add_cutout(scene, 0.75, 0.0));
  expect_near(seen_by_whitted(scene, 3), Vec3d(0.0));
  expect_near(seen_by_whitted(scene, 4), Vec3d(0.25));
  expect_near(seen_by_whitted(scene, 0), Vec3d(0.0));
}

// Between two mirrors of reflectance 1/2 the series of what each shows.
TEST(Unit_WhittedRays, DepthLimitsCutTheSeriesBetweenTwoMirrors) {
  SceneDescription scene = ambient_scene();
  description::LabMaterial mirror = highlight_only(1.0, 32);
  mirror.diffuse.factor = Vec3d(1.0);
  const auto handle = add_material(scene, mirror);
  add_sheet(scene, 0, handle);
  add_sheet(scene, 8, handle);
  double sum = 0;
  for (int depth = 1; depth <= 8; ++depth) {
    sum += 0.5 * std::pow(0.5, depth - 1);
    expect_near(seen_by_whitted(scene, depth), Vec3d(sum));
  }
}

TEST(Unit_WhittedRays, TheDefaultDepthIsFive) {
  SceneDescription scene = ambient_scene();
  add_sheet(scene, 0, add_material(scene, diffuse(Vec3d(0.25))));
  for (const double y : {0.5, 1.0, 2.0, 3.0}) add_sheet(scene, y, add_cutout(scene, 0.75, 0.0));
  expect_near(seen(scene, lab_settings(IntegratorKind::Whitted)), Vec3d(0.25));
  add_sheet(scene, 3.5, add_cutout(scene, 0.75, 0.0));
  expect_near(seen(scene, lab_settings(IntegratorKind::Whitted)), Vec3d(0.0));
}

TEST(Unit_WhittedRays, AlphaTellsHowMuchOfTheBackgroundIsCovered) {
  for (const double alpha : {0.0, 0.5, 1.0}) {
    SceneDescription scene = ambient_scene();
    add_sheet(scene, 0, add_cutout(scene, 0.5, alpha));
    const Image image = rendered(scene, lab_settings(IntegratorKind::Whitted)).film.to_image(true);
    EXPECT_FLOAT_EQ(image.values[3], static_cast<float>(alpha));
  }
}

TEST(Unit_WhittedRays, LayersComeFromTheFirstSurfaceThatIsNoHole) {
  SceneDescription scene = ambient_scene();
  add_sheet(scene, 0, add_material(scene, diffuse(Vec3d(0.25))));
  add_sheet(scene, 1, add_cutout(scene, 0.5, 0.5));
  add_sheet(scene, 3, add_cutout(scene, 0.75, 0.1));
  for (const IntegratorKind integrator : {IntegratorKind::Whitted, IntegratorKind::Raster}) {
    RenderSettings settings = lab_settings(integrator);
    settings.options.aovs = aov_bit(Aov::Depth) | aov_bit(Aov::Albedo);
    const Image image = rendered(scene, settings).film.to_image(false);
    EXPECT_FLOAT_EQ(image.values[static_cast<std::size_t>(image.channel_index("depth.Z"))], 3);
    EXPECT_FLOAT_EQ(image.values[static_cast<std::size_t>(image.channel_index("albedo.R"))], 0.5f);
  }
}

TEST(Unit_WhittedRays, ThoseThatCannotBeTracedAreCounted) {
  for (const IntegratorKind integrator : {IntegratorKind::Whitted, IntegratorKind::Raster}) {
    const RenderSettings settings = lab_settings(integrator, 2);
    Scene scene = compiled(floor_seen_from(4, diffuse(Vec3d(0.5))), settings.options);
    scene.cameras[0].eye.x = 10 * farthest_traceable;
    const AnyAccelerator accelerator = build_accelerator(scene, settings.accelerator);
    const RenderStatistics statistics =
        render(scene, accelerator, settings.options, nullptr, nullptr).statistics;
    EXPECT_EQ(statistics.invalid_samples, 4u);
  }
}

}  // namespace
}  // namespace candela
